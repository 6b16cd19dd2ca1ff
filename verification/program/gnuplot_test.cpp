/// `rotor plot` with different versions and failures of gnuplot.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "figures/data/csv.hpp"
#include "model/mechanics/parameters.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class Gnuplot : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    write("it's.toml",
          "title = \"It's 100 %\"\n[parameters]\nstart_speed_Hz = 150\nuntil = 0.03\n");
  }

  /// A program of this name instead of gnuplot, in the folder.
  void write_gnuplot(const std::string& script) const {
    write("gnuplot", "#!/bin/sh\n" + script);
    fs::permissions(folder_ / "gnuplot", fs::perms::owner_all);
  }
};

TEST_F(Gnuplot, EndsWithGnuplotWhenItIsInterrupted) {
  write_gnuplot("exec sleep 60\n");
  fs::create_directory(folder_ / "drafts");
  for (const auto& [signal, expected] : {std::pair("INT", 130), std::pair("HUP", 129)}) {
    const auto [status, output] =
        shell(fmt::format("(TMPDIR=$PWD/drafts PATH=$PWD:$PATH exec $rotor plot \"it's.toml\" "
                          "--out a.svg) & sleep 1; "
                          "kill -{} $!; wait $!",
                          signal));
    EXPECT_EQ(status, expected) << output;
    EXPECT_TRUE(has(output, "rotor: interrupted"));
    EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
    EXPECT_TRUE(fs::is_empty(folder_ / "drafts"));
  }
}

// A user's gnuplot settings change no picture; and titles may have any length.
TEST_F(Gnuplot, HeedsNoSettingsButItsOwn) {
  EXPECT_EQ(rotor("plot \"it's.toml\" --out a.svg").status, 0);
  write(".gnuplot", "set logscale y\nset xrange [0:10]\nset decimalsign ','\n");
  const auto [status, output] = shell("HOME=$PWD $rotor plot \"it's.toml\" --out b.svg");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(content("b.svg") == content("a.svg"));
  write("long.toml", "title = \"" + std::string(200'000, 'a') +
                         "\"\n[parameters]\nuntil = 0.01\n"
                         "no_mass_loss = true\n");
  EXPECT_EQ(rotor("plot long.toml 2>/dev/null").output, "long.svg\n");
}

// Values that do not vary. gnuplot prints nothing.
TEST_F(Gnuplot, DrawsWhatHasNoExtent) {
  for (const std::string parameters : {"support_stiffness = 0\nstart_speed_Hz = 50\nuntil = 0.01\n",
                                       "torque = 0\nno_mass_loss = true\nuntil = 0.01\n"}) {
    write("s.toml", "[parameters]\nequations = \"corrected\"\n" + parameters);
    EXPECT_EQ(rotor("plot s.toml 2>messages").output, "s.svg\n") << parameters;
    EXPECT_FALSE(has(content("messages"), "gnuplot"));
    EXPECT_FALSE(has(content("messages"), "arning"));
  }
}

// gnuplot reports success even if the disk is full.
TEST_F(Gnuplot, RefusesAPictureWithoutItsEnd) {
  write_gnuplot(
      "PATH=${PATH#*:} gnuplot \"$@\"\n"
      "truncate -s -20 \"$(echo \"$3\" | sed -n \"s/.*output = '\\([^']*\\)'.*/\\1/p\")\"\n");
  for (const std::string name : {"a.svg", "a.pdf", "a.png"}) {
    write(name, "old");
    const auto [status, output] = shell("PATH=$PWD:$PATH $rotor plot \"it's.toml\" --out " + name);
    EXPECT_NE(status, 0);
    EXPECT_TRUE(has(output, "gnuplot did not draw the whole picture\n"));
    EXPECT_EQ(content(name), "old");
  }
}

TEST_F(Gnuplot, NamesAScriptThatItCannotRun) {
  write("mine.gp", "set title 'mine'\nplot missing(\n");
  const auto [status, output] =
      shell("'" ROTOR_SOURCES "/figures/draw.sh' a.svg \"data = ''\" mine.gp");
  EXPECT_NE(status, 0);
  EXPECT_TRUE(has(output, "\"mine.gp\" line 2: "));
  EXPECT_TRUE(has(output, "a.svg: not drawn by mine.gp: gnuplot's message above"));
  EXPECT_FALSE(fs::exists(folder_ / "a.svg"));
}

// What a scene states becomes variables of gnuplot.
TEST_F(Gnuplot, ExecutesNothingThatASceneSays) {
  const std::string name =
      R"(a'.system('touch done').'`touch done`\"; system("touch done") # 100 %\\n)";
  write("fig40.toml",
        "columns = [\"time_s\", \"rho_m\"]\n[parameters]\nstart_speed_Hz = 150\nuntil = "
        "0.01\n[[run]]\nname = '''" +
            name + "'''\n[[run]]\nname = \"b\"\nmass = 4\n");
  write("fig40.gp",
        "set title of('run', 1) noenhanced\nset xlabel sprintf('%g kg', number(of('run', 1), "
        "'mass'))\n"
        "set ylabel sprintf('%g kg', number('b', 'mass'))\nplot data using 2:3 with lines\n");
  ASSERT_EQ(rotor("figure --scenes . --out . --equations corrected").status, 0);
  const auto [status, output] = shell(
      "\"" ROTOR_SOURCES "/figures/draw.sh\" a.svg \"data_corrected = 'fig40.csv'\" fig40.gp");
  EXPECT_EQ(status, 0) << output;
  EXPECT_FALSE(fs::exists(folder_ / "done"));
  const DrawnPicture picture(content("a.svg"));
  for (const std::string text : {"5 kg", "4 kg"})
    EXPECT_TRUE(std::ranges::find(picture.texts, text) != picture.texts.end()) << text;
}

// The closed form of the first run exists, and its friction is above the limits of whirl and
// forward rub, but the ring lets it go; the second run rolls below one of these limits.
TEST_F(Gnuplot, MarksTheClosedFormOfRollingWhereTheRunRolls) {
  for (const auto& [parameters, rolls] : std::vector<std::pair<std::string, bool>>{
           {"contact_damping = 26\ncontact_stiffness = 448898.329\nsupport_damping = 5.538981\n"
            "friction = 0.92590756\nstart_speed_Hz = 182.362809\nclearance = 0.005301126650\n",
            false},
           {"start_speed_Hz = 150\nfriction = 0.12\n", true}}) {
    write("fig40.toml",
          "columns = [\"time_s\", \"normal_force_N\"]\n[parameters]\ntorque = 0\nuntil = 0.2\n" +
              parameters);
    write("fig40.gp",
          "eval mark_law('run')\nset xlabel number('run', 'outcome') noenhanced\n"
          "plot data using 2:3 with lines\n");
    ASSERT_EQ(rotor("figure --scenes . --out . --equations corrected").status, 0);
    EXPECT_EQ(shell("\"" ROTOR_SOURCES
                    "/figures/draw.sh\" a.svg \"data_corrected = 'fig40.csv'\" fig40.gp")
                  .output,
              "a.svg\n");
    EXPECT_TRUE(has(content("fig40.var"), "law_peak_force_N1 = "));
    EXPECT_FALSE(has(content("fig40.var"), "law_peak_force_N1 = NaN"));
    const auto texts = DrawnPicture(content("a.svg")).texts;
    EXPECT_EQ(std::ranges::find(texts, "rolling") != texts.end(), rolls);
    EXPECT_EQ(has(content("a.svg"), "estimate of the largest force"), rolls) << parameters;
  }
}

TEST_F(Gnuplot, LeavesNothingBehindWhereItFails) {
  write("a.svg", "old");
  expect_refusal("plot \"it's.toml\" --out a.jpg", "must end in .svg, .pdf or .png");
  expect_refusal("plot nowhere.toml --out a.svg", "nowhere.toml");
  expect_refusal("plot \"it's.toml\" --out no/a.svg",
                 "no/a.svg: cannot be written: there is no folder no");
  const auto [status, output] = shell("PATH= $rotor plot \"it's.toml\" --out a.svg");
  EXPECT_NE(status, 0);
  EXPECT_TRUE(has(output, "gnuplot cannot be started"));
  EXPECT_EQ(content("a.svg"), "old");
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace rotor
