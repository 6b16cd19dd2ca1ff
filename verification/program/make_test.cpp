/// What `make` says of requests that cannot be fulfilled: one line each.
#include <algorithm>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Make : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    fs::copy_file(fs::path(ROTOR_SOURCES) / "Makefile", folder_ / "Makefile");
    fs::create_directories(folder_ / "figures/paper");
    write("figures/paper/fig18.toml", "");
  }

  void expect_line(const std::string& arguments, const std::string& line) const {
    // Not as a part of the make that may run the tests.
    const auto [status, output] = shell("env -u MAKEFLAGS -u MAKELEVEL -u CXX make " + arguments);
    EXPECT_NE(status, 0) << arguments;
    EXPECT_NE(output.find(line), std::string::npos) << output;
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
  }
};

TEST_F(Make, SaysWhatItCannotMake) {
  expect_line("FORMAT=jpg figures", "FORMAT=jpg: must be one of: svg pdf png");
  expect_line("EQUATIONS=printed figures",
              "EQUATIONS=printed: must be one of: published consistent");
  expect_line("POINTS=many maps", "POINTS=many: must be a whole number, 20 at least");
  write("build", "a file in the place of the folder");
  expect_line("build", "build: cannot be written");
  expect_line("figures/paper/fig18.gp",
              "The scene figures/paper/fig18.toml has no script figures/paper/fig18.gp");
}

TEST_F(Make, NamesTheFiguresThatThereAre) {
  EXPECT_NE(
      shell("env -u MAKEFLAGS -u MAKELEVEL -u CXX make help").output.find("one figure: fig18\n"),
      std::string::npos);
}

}  // namespace
}  // namespace rotor
