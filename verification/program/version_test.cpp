/// A result says which program computed it.
#include "figures/results/version.hpp"

#include <fmt/format.h>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

using Version = CommandLine;

TEST_F(Version, IsInEachResult) {
  const std::string known(version());
  EXPECT_EQ(rotor("--version").output, "rotor " + known + '\n');
  EXPECT_EQ(summary("--until 0.01")["version"], known);
  for (const char* made :
       {"rotor run --until 0.01 --trace out.csv", "rotor figure 3 --out .; mv fig03.csv out.csv",
        "echo '[[axis]]\nquantity = \"until\"\nvalues = [0.01, 0.02]' >s.toml; "
        "rotor sweep s.toml --out out.csv"}) {
    shell(fmt::format("rotor() {{ \"$rotor\" \"$@\"; }}; {}", made));
    EXPECT_TRUE(has(content("out.csv"), "\n# rotor " + known + '\n')) << made;
    fs::remove(folder_ / "out.csv");
  }
}

// By git in a checkout, by what git has written in an archive, and by neither.
TEST_F(Version, IsThatOfTheCheckoutOrArchive) {
  if (shell("git --version").status != 0) GTEST_SKIP() << "needs git";
  const auto [status, output] = shell(
      "export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1\n"
      "script=figures/results/version.cmake\n"
      "mkdir -p one/figures/results archive && cd one\n"
      "cp '" ROTOR_SOURCES "/.gitattributes' . && cp '" ROTOR_SOURCES
      "'/$script figures/results\n"
      "say() { cmake -D NUMBER=7 -D SOURCES=\"$PWD\" -P $script; sed -n "
      "'s/.*\"\\(7.*\\)\".*/\\1/p' "
      "version.cpp; rm version.cpp; }\n"
      "say\n"
      "git init -q && git add . && git -c user.name=a -c user.email=a@b commit -qm a\n"
      "hash=$(git rev-parse --short HEAD)\n"
      "say | sed s/$hash/HASH/\n"
      "git archive HEAD | tar x -C ../archive; (cd ../archive; say) | sed s/$hash/HASH/\n"
      "git tag v7\n"
      "git archive HEAD | tar x -C ../archive; (cd ../archive; say) \n"
      "echo '# more' >>$script; say\n");
  EXPECT_EQ(status, 0);
  EXPECT_EQ(output, "7 (unknown commit)\n7 (HASH)\n7 (HASH)\n7 (v7)\n7 (v7-dirty)\n");
}

}  // namespace
}  // namespace rotor
