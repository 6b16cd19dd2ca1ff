/// What `make explore` calls, with stand-ins for the compiler and for what has to be downloaded.
#include <fmt/format.h>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class ExploreBuild : public CommandLine {
 protected:
  /// A program of that name, which notes its call and does no more.
  void pretend(const std::string& name, int status) const {
    fs::create_directory(folder_ / "programs");
    write("programs/" + name,
          fmt::format("#!/bin/sh\necho {} \"$@\" >> calls\nexit {}\n", name, status));
    fs::permissions(folder_ / "programs" / name, fs::perms::owner_all);
  }

  /// Its outcome, and in `calls` what it has called.
  Outcome build() const {
    fs::remove(folder_ / "calls");
    return shell("PATH=$PWD/programs:$PATH " ROTOR_SOURCES "/figures/explore/build.sh built");
  }
};

// What could not be downloaded is not taken for installed; what has been is not installed again.
TEST_F(ExploreBuild, InstallsItsPackagesUntilItHasThem) {
  for (const char* name : {"em++", "node", "emcmake", "cmake"}) pretend(name, 0);
  for (const int status : {1, 1, 0}) {
    pretend("npm", status);
    const auto [ended, output] = build();
    EXPECT_EQ(ended == 0, status == 0) << output;
    EXPECT_NE(content("calls").find("npm ci --prefix built/explore/npm --ignore-scripts"),
              std::string::npos)
        << content("calls");
  }
  EXPECT_EQ(build().output, "built/report/explore.html\n");
  EXPECT_EQ(content("calls").find("npm"), std::string::npos) << content("calls");
  pretend("emcmake", 1);
  EXPECT_NE(build().status, 0);
}

}  // namespace
}  // namespace rotor
