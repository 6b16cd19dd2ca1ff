/// `rotor plot` with different versions and failures of gnuplot.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

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
          "title = \"It's 100 %\"\n[parameters]\nstart_speed_hz = 150\nuntil = 0.03\n");
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
    EXPECT_NE(output.find("rotor: interrupted"), std::string::npos) << output;
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
  EXPECT_EQ(rotor("plot long.toml").output, "long.svg\n");
}

// The share that rolls at each point of a map, and of a distribution with draws that have no
// result.
TEST_F(Gnuplot, DrawsASweepInARelativeFolder) {
  fs::create_directory(folder_ / "drafts");
  write("s.toml",
        "[parameters]\nequations = \"consistent\"\nstart_speed_hz = 150\nuntil = 1e-3\n"
        "[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.2]\n");
  const auto [status, output] = shell("TMPDIR=drafts $rotor plot s.toml --column outcome");
  EXPECT_EQ(status, 0) << output;
  EXPECT_TRUE(fs::is_empty(folder_ / "drafts"));
}

TEST_F(Gnuplot, GetsTheSharesOfTheDraws) {
  const std::string sample =
      "[sample]\ncount = 7\nseed = 1\n[[sample.over]]\nquantity = \"friction\"\n"
      "uniform = [0.02, 0.3]\n";
  const std::string rotor_at_150_Hz = "[parameters]\nstart_speed_hz = 150\nuntil = 0.06\n";
  write("map.toml", "columns = [\"outcome\"]\n" + rotor_at_150_Hz +
                        "[[axis]]\nquantity = \"mass\"\nvalues = [5, 4, 6]\n[[axis]]\nquantity = "
                        "\"clearance\"\nvalues = [2e-3, 3e-3]\n" +
                        sample);
  write("sample.toml", rotor_at_150_Hz + sample);
  const auto drawn = [&](const std::string& name, const std::string& kept,
                         const std::string& column) {
    write_gnuplot("PATH=${PATH#*:} gnuplot \"$@\"" + kept + " \"$KEPT\"\n");
    EXPECT_EQ(rotor("sweep " + name + ".toml --out " + name + ".csv").status, 0);
    const auto [status, output] =
        shell("KEPT=$PWD/kept PATH=$PWD:$PATH $rotor plot " + name + ".csv " + column);
    EXPECT_EQ(status, 0) << output;
    std::string text = content("kept");
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream lines(text);
    std::vector<std::array<double, 3>> all;
    for (std::string line; std::getline(lines, line);)
      if (std::array<double, 3> row{};
          std::sscanf(line.c_str(), "%lf %lf %lf", &row[0], &row[1], &row[2]) >= 2)
        all.push_back(row);
    return std::pair(all, read_csv(folder_ / (name + ".csv")));
  };
  const auto [cells, draws] = drawn("map", " && cp panel0.csv", "");
  ASSERT_EQ(cells.size(), 6U);
  double parts = 0;
  for (const auto& [x, y, share] : cells) {
    const auto first = static_cast<std::size_t>(7 * (2 * y + x));
    const auto roll = std::count_if(draws.begin() + static_cast<long>(first),
                                    draws.begin() + static_cast<long>(first + 7),
                                    [](const CsvRow& row) { return row["outcome"] == "rolling"; });
    EXPECT_NEAR(share, static_cast<double>(roll) / 7, 1e-6);
    parts += share * (1 - share);
  }
  EXPECT_GT(parts, 0);  // some, but not all
  shell("sed -i '$d' map.csv");
  expect_refusal("plot map.csv", "map.csv: has 41 rows; the sweep file above them has 42 points");
  shell("sed -i 's/^#   count = .*/#   count = 0/' map.csv");
  expect_refusal(
      "plot map.csv",
      fmt::format("rotor: map.csv:{}: count: must be at least 1",
                  shell("grep -n 'count = 0' map.csv | cut -d: -f1 | tr -d '\\n'").output));
  const auto [bins, sample_draws] =
      drawn("sample", " -e 'set print \"bins\"; print $bins' && cp bins",
            "--column rolling_onset_speed_Hz");
  const auto roll = std::count_if(sample_draws.begin(), sample_draws.end(), [](const CsvRow& row) {
    return !row["rolling_onset_speed_Hz"].empty();
  });
  double sum = 0;
  for (const auto& bin : bins) sum += bin[1];
  EXPECT_NEAR(sum, static_cast<double>(roll) / 7, 1e-6);
  EXPECT_LT(roll, 7);
}

// Frequencies of 0, a single value, values that hardly differ, and results that no point has.
// gnuplot prints nothing.
TEST_F(Gnuplot, DrawsWhatHasNoExtent) {
  const std::string axis = "until = 1e-3\n[[axis]]\nquantity = \"friction\"\n",
                    close = "from = 0.1\nto = 0.1000000000001\npoints = 2\n";
  for (const std::string& parameters :
       {std::string("support_stiffness = 0\nstart_speed_hz = 50\nuntil = 0.01\n"),
        std::string("torque = 0\nno_mass_loss = true\nuntil = 0.01\n"), axis + "values = [0.1]\n",
        axis + close, axis + close + "spacing = \"log\"\n"}) {
    write("s.toml", "[parameters]\nequations = \"consistent\"\n" + parameters);
    const bool is_scene = parameters.find("axis") == std::string::npos;
    for (const char* option : {is_scene ? "--spectrum" : "", is_scene ? "" : "--column outcome"}) {
      const auto [status, output] = rotor(std::string("plot s.toml ") + option + " 2>messages");
      EXPECT_EQ(output, std::string(*option == '\0' ? "s"
                                    : is_scene      ? "s-spectrum"
                                                    : "s-outcome") +
                            ".svg\n")
          << parameters << option;
      EXPECT_EQ(content("messages").find("gnuplot"), std::string::npos) << content("messages");
      EXPECT_EQ(content("messages").find("arning"), std::string::npos) << content("messages");
    }
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
    EXPECT_NE(output.find("gnuplot did not draw the whole picture\n"), std::string::npos) << output;
    EXPECT_EQ(content(name), "old");
  }
}

// What a scene states becomes variables of gnuplot.
TEST_F(Gnuplot, ExecutesNothingThatASceneSays) {
  const std::string name =
      R"(a'.system('touch done').'`touch done`\"; system("touch done") # 100 %\\n)";
  write("fig40.toml",
        "columns = [\"time_s\", \"rho_m\"]\n[parameters]\nstart_speed_hz = 150\nuntil = "
        "0.01\n[[run]]\nname = '''" +
            name + "'''\n[[run]]\nname = \"b\"\nmass = 4\n");
  write("fig40.gp",
        "set title of('run', 1) noenhanced\nset xlabel sprintf('%g kg', number(of('run', 1), "
        "'mass'))\n"
        "set ylabel sprintf('%g kg', number('b', 'mass'))\nplot data using 2:3 with lines\n");
  ASSERT_EQ(rotor("figure --scenes . --out . --equations consistent").status, 0);
  const auto [status, output] = shell(
      "\"" ROTOR_SOURCES "/figures/draw.sh\" a.svg \"data_consistent = 'fig40.csv'\" fig40.gp");
  EXPECT_EQ(status, 0) << output;
  EXPECT_FALSE(fs::exists(folder_ / "done"));
  const DrawnPicture picture(content("a.svg"));
  for (const std::string text : {"5 kg", "4 kg"})
    EXPECT_TRUE(std::ranges::find(picture.texts, text) != picture.texts.end()) << text;
}

TEST_F(Gnuplot, LeavesNothingBehindWhereItFails) {
  write("a.svg", "old");
  expect_refusal("plot \"it's.toml\" --out a.jpg", "must end in .svg, .pdf or .png");
  expect_refusal("plot nowhere.toml --out a.svg", "nowhere.toml");
  expect_refusal("plot \"it's.toml\" --out no/a.svg",
                 "no/a.svg: cannot be written: there is no folder no");
  const auto [status, output] = shell("PATH= $rotor plot \"it's.toml\" --out a.svg");
  EXPECT_NE(status, 0);
  EXPECT_NE(output.find("gnuplot cannot be started"), std::string::npos) << output;
  EXPECT_EQ(content("a.svg"), "old");
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace rotor
