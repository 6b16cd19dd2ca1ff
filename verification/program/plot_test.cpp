/// `rotor plot`.
#include <gtest/gtest.h>

#include <algorithm>

#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class Plot : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    write("it's.toml",
          "title = \"It's 100 %\"\n[parameters]\nstart_speed_hz = 150\nuntil = 0.03\n"
          "[[run]]\nname = \"high_mu\"\n[[run]]\nname = \"mu's 0.1\"\nfriction = 0.1\n");
  }
};

// Names are shown as they are, gnuplot has nothing to complain of, and nothing else is left.
TEST_F(Plot, DrawsEveryRunOfAScene) {
  const auto [status, output] = rotor("plot \"it's.toml\"");
  EXPECT_EQ(status, 0);
  EXPECT_EQ(output, "it's.svg\n");
  const std::string picture = content("it's.svg");
  for (const char* shown : {"It's 100 %", "high_mu", "mu's 0.1", "f, Hz", "clearance"})
    EXPECT_NE(picture.find(shown), std::string::npos) << shown;
  EXPECT_EQ(files(), 2);
}

TEST_F(Plot, DrawsTheFormatThatTheNameEndsIn) {
  EXPECT_EQ(rotor("plot \"it's.toml\" --out a.pdf").status, 0);
  EXPECT_TRUE(content("a.pdf").starts_with("%PDF"));
  EXPECT_EQ(rotor("plot \"it's.toml\" --out a.png").status, 0);
  EXPECT_TRUE(content("a.png").substr(1).starts_with("PNG"));
}

TEST_F(Plot, FollowsLinksAndKeepsTheMode) {
  write("target.svg", "old");
  fs::permissions(folder_ / "target.svg", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target.svg", folder_ / "link.svg");
  EXPECT_EQ(rotor("plot \"it's.toml\" --out link.svg").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.svg"));
  EXPECT_NE(content("target.svg").find("</svg>"), std::string::npos);
  EXPECT_EQ(fs::status(folder_ / "target.svg").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(Plot, LeavesNothingBehindWhereItFails) {
  write("a.svg", "old");
  expect_refusal("plot \"it's.toml\" --out a.jpg", "must end in .svg, .pdf or .png");
  expect_refusal("plot nowhere.toml --out a.svg", "nowhere.toml");
  expect_refusal("plot \"it's.toml\" --out no/a.svg", "no: cannot be written");
  const auto [status, output] = shell("PATH= $rotor plot \"it's.toml\" --out a.svg");
  EXPECT_NE(status, 0);
  EXPECT_NE(output.find("gnuplot, which draws, cannot be started"), std::string::npos) << output;
  EXPECT_EQ(content("a.svg"), "old");
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace rotor
