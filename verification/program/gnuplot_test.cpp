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
  const auto drawn = [&](const std::string& name, const std::string& block,
                         const std::string& column) {
    write_gnuplot("PATH=${PATH#*:} gnuplot \"$@\" -e 'set print \"kept\"; print $" + block +
                  "' && cp kept \"$KEPT\"\n");
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
  const auto [cells, draws] = drawn("map", "cells", "");
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
  const auto [bins, sample_draws] = drawn("sample", "bins", "--column rolling_onset_speed_Hz");
  const auto roll = std::count_if(sample_draws.begin(), sample_draws.end(), [](const CsvRow& row) {
    return !row["rolling_onset_speed_Hz"].empty();
  });
  double sum = 0;
  for (const auto& bin : bins) sum += bin[1];
  EXPECT_NEAR(sum, static_cast<double>(roll) / 7, 1e-6);
  EXPECT_LT(roll, 7);
}

// O moves steadily on a circle, forward, once per turn of the rotor: the spectrum has one line at
// f = 60 Hz, with the circle's radius as its height. A Hann window over a whole number of turns
// leaves lines of half the height next to it, and nothing elsewhere.
TEST_F(Gnuplot, GetsTheSpectrumOfACircle) {
  write_gnuplot("cp run1.csv \"$KEPT\"; exit 1\n");
  write("circle.toml",
        "[parameters]\nstart_speed_hz = 60\ntorque = 0\ngravity = 0\nno_mass_loss = true\nuntil = "
        "0.5\n");
  EXPECT_EQ(
      shell("KEPT=$PWD/spectrum.csv PATH=$PWD:$PATH $rotor plot circle.toml --spectrum").status, 1);
  ASSERT_EQ(rotor("run --scene circle.toml --trace t.csv --rows 2").status, 0);
  const auto rho = static_cast<double>(read_csv(folder_ / "t.csv").front().number("rho_m"));
  double at_60_Hz = 0, beside = 0, elsewhere = 0;
  for (const CsvRow& row : read_csv(folder_ / "spectrum.csv")) {
    const auto from_60_Hz = std::abs(static_cast<double>(row.number("frequency_Hz")) - 60);
    double& its = from_60_Hz < 1 ? at_60_Hz : from_60_Hz < 3 ? beside : elsewhere;
    its = std::max(its, static_cast<double>(row.number("displacement_m")));
    EXPECT_EQ(row.number("force_N"), 0);
  }
  // The dampers slow the rotor by some millionths in this time.
  EXPECT_NEAR(at_60_Hz / rho, 1, 1e-4);
  EXPECT_NEAR(beside / rho, 0.5, 1e-3);
  EXPECT_LT(elsewhere / rho, 1e-3);
}

// The highest line of the force in rolling agrees with a direct sum over the trace, in which the
// force is composed of its components along the normal and the tangent.
TEST_F(Gnuplot, GetsTheSpectrumOfTheForceInRolling) {
  write_gnuplot("cp run1.csv \"$KEPT\"; exit 1\n");
  const double from_s = 0.03, length_s = 0.03;
  const long samples = 1024;  // of so short a time
  write("rub.toml",
        "[parameters]\nequations = \"consistent\"\nstart_speed_hz = 150\nuntil = 0.06\n");
  shell("KEPT=$PWD/spectrum.csv PATH=$PWD:$PATH $rotor plot rub.toml --spectrum --from 0.03");
  ASSERT_EQ(rotor(fmt::format("run --scene rub.toml --from {} --trace t.csv --rows {} --columns "
                              "time_s,x_a_m,y_a_m,normal_force_N,friction_force_N",
                              from_s, samples + 1))
                .status,
            0);
  double frequency_Hz = 0, highest_N = 0;
  for (const CsvRow& row : read_csv(folder_ / "spectrum.csv"))
    if (const auto force_N = static_cast<double>(row.number("force_N")); force_N > highest_N) {
      highest_N = force_N;
      frequency_Hz = static_cast<double>(row.number("frequency_Hz"));
    }
  EXPECT_LT(frequency_Hz, -700);  // the whirl runs backwards
  const std::vector<CsvRow> rows = read_csv(folder_ / "t.csv");
  ASSERT_EQ(rows.size(), samples + 1);
  double real = 0, imaginary = 0;
  for (long k = 0; k < samples; ++k) {
    const auto number = [&](const char* column) {
      return static_cast<double>(rows[static_cast<std::size_t>(k)].number(column));
    };
    const double rho = std::hypot(number("x_a_m"), number("y_a_m"));
    const double n_x = number("x_a_m") / rho, n_y = number("y_a_m") / rho;
    const double force_x = number("normal_force_N") * n_x - number("friction_force_N") * n_y,
                 force_y = number("normal_force_N") * n_y + number("friction_force_N") * n_x;
    const double share = static_cast<double>(k) / static_cast<double>(samples),
                 window = 1 - std::cos(two_pi * share),
                 angle = -two_pi * frequency_Hz * length_s * share;
    real += window * (force_x * std::cos(angle) - force_y * std::sin(angle));
    imaginary += window * (force_x * std::sin(angle) + force_y * std::cos(angle));
  }
  EXPECT_NEAR(std::hypot(real, imaginary) / static_cast<double>(samples) / highest_N, 1, 1e-9);
}

// gnuplot reports success even if the disk is full.
TEST_F(Gnuplot, RefusesAPictureWithoutItsEnd) {
  write_gnuplot(
      "PATH=${PATH#*:} gnuplot \"$@\"\n"
      "truncate -s -20 \"$(sed -n \"s/.*output = '\\([^']*\\)'.*/\\1/p\" \"$2\")\"\n");
  for (const std::string name : {"a.svg", "a.pdf", "a.png"}) {
    write(name, "old");
    const auto [status, output] = shell("PATH=$PWD:$PATH $rotor plot \"it's.toml\" --out " + name);
    EXPECT_NE(status, 0);
    EXPECT_EQ(output, "rotor: gnuplot did not draw the whole picture\n");
    EXPECT_EQ(content(name), "old");
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
  EXPECT_NE(output.find("gnuplot cannot be started"), std::string::npos) << output;
  EXPECT_EQ(content("a.svg"), "old");
  EXPECT_EQ(files(), 2);
}

}  // namespace
}  // namespace rotor
