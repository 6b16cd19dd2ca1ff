/// `rotor plot` of a sweep's results.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "figures/data/read_csv.hpp"
#include "figures/input/words.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class PlotSweep : public CommandLine {
 protected:
  const std::string
      speeds_ = "[[axis]]\nquantity = \"start_speed_Hz\"\nvalues = [60, 0.1, 80, 150, 300]\n",
      clearances_ = "[[axis]]\nquantity = \"clearance\"\nvalues = [4e-3, 1e-3, 1.5e-3]\n",
      sets_ =
          "[[axis]]\nquantity = \"equations\"\nvalues = [\"corrected\", "
          "\"published\"]\n",
      sample_ =
          "[sample]\ncount = 40\n[[sample.over]]\nquantity = \"friction\"\n"
          "uniform = [0.02, 0.3]\n";

  /// Computes it, with some refusals: at rest nothing rolls, and no steady response is above 1e3
  /// Hz.
  void sweep(const std::string& varied, const std::string& first = "") const {
    write("s.toml", first + "[parameters]\nuntil = 0.02\n" + varied);
    ASSERT_EQ(rotor("sweep s.toml --force").status, 0);
  }
  /// The rows of a file of numbers, which gnuplot reads.
  std::vector<std::vector<std::string>> drafts(const std::string& name) const {
    std::ifstream file(folder_ / "drafts" / name);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) rows.push_back(csv_cells(line));
    return rows;
  }
  void draft(const std::string& options = "") const {
    fs::create_directories(folder_ / "drafts");
    const auto [status, output] = rotor("plot s.csv --drafts drafts " + options);
    ASSERT_EQ(status, 0) << output;
  }
  DrawnPicture picture(const std::string& options = "") const {
    const auto [status, output] = rotor("plot s.csv " + options);
    EXPECT_EQ(status, 0) << output;
    DrawnPicture drawn(content("s.svg"));
    EXPECT_EQ(drawn.clipped, std::vector<std::string>());
    EXPECT_EQ(drawn.overlapping, std::vector<std::string>());
    return drawn;
  }

  static int code_of(const std::string& outcome) {
    const auto found = std::ranges::find(outcomes, outcome, &OutcomeInWords::name);
    return static_cast<int>(found - outcomes.begin());  // 7: no result
  }

  static bool shows(const DrawnPicture& picture, std::string_view text) {
    return std::ranges::any_of(picture.texts,
                               [&](const std::string& one) { return has(one, text); });
  }
};

// The cell around each row's values has its results, whichever axis comes first and however the
// values are ordered and spaced.
TEST_F(PlotSweep, DrawsEachPointOfAMapAtItsValues) {
  for (const std::string& axes : {sets_ + speeds_ + clearances_, clearances_ + sets_ + speeds_}) {
    const bool speed_is_last = axes.ends_with(speeds_);
    sweep(axes);
    draft();
    std::size_t rows = 0;
    for (const CsvRow& row : read_csv(folder_ / "s.csv")) {
      const double speed = std::log10(static_cast<double>(row.number("start_speed_Hz"))),
                   clearance = 1e3 * static_cast<double>(row.number("clearance")),
                   x = speed_is_last ? speed : clearance, y = speed_is_last ? clearance : speed;
      const auto cells =
          drafts(row["equations_varied"] == "corrected" ? "panel1.csv" : "panel2.csv");
      const auto distance = [&](const std::vector<std::string>& cell) {
        return std::abs(std::stod(cell[0]) - x) + std::abs(std::stod(cell[1]) - y);
      };
      const auto nearest = std::ranges::min_element(cells, {}, distance);
      ASSERT_NE(nearest, cells.end());
      EXPECT_LT(distance(*nearest), 0.02);  // 400 strips across a decade or two, and a few mm
      EXPECT_EQ(std::stoi((*nearest)[2]), code_of(row["outcome"]));
      const std::string& force_N = row["peak_force_to_rolling_N"];
      if (force_N.empty())
        EXPECT_EQ((*nearest)[3], "NaN");
      else
        EXPECT_NEAR(std::stod((*nearest)[3]), std::stod(force_N) / 1e3, 1e-6 * std::stod(force_N));
      ++rows;
    }
    EXPECT_EQ(rows, 30U);
    EXPECT_TRUE(shows(picture(), "corrected equations"));
  }
}

// At 10 Hz the steady response exceeds the smaller clearances.
TEST_F(PlotSweep, TellsPointsWithoutAResultFromStalledOnes) {
  sweep(replaced(speeds_, "\\[60.*300\\]", "[10, 150]") + clearances_);
  const DrawnPicture drawn = picture();
  EXPECT_TRUE(shows(drawn, no_result));
  EXPECT_FALSE(shows(drawn, "stalled"));
}

// Of places that are too close for a picture one is drawn; the others are not left out.
TEST_F(PlotSweep, DrawsSectionsAboveACurve) {
  std::string text = content(ROTOR_SOURCES "/figures/maps/partial-rub.toml");
  text = replaced(replaced(text, "until = 100", "until = 10"), "points = 400", "points = 7");
  write("s.toml", text);
  ASSERT_EQ(rotor("sweep s.toml").status, 0);
  draft();
  const auto drawn = drafts("section1.csv");
  double least = 1e9, most = -1e9;
  std::map<double, std::vector<double>> at_speed;
  for (const CsvRow& row : read_csv(folder_ / "s-sections.csv")) {
    const double x = 1e3 * static_cast<double>(row.number("x_a_m"));
    least = std::min(least, x);
    most = std::max(most, x);
    at_speed[static_cast<double>(row.number("start_speed_Hz"))].push_back(x);
  }
  EXPECT_EQ(at_speed.size(), 7U);
  EXPECT_GT(drawn.size(), 100U);  // some speeds have rub
  EXPECT_LT(drawn.size(), 4 * 192U);
  for (const auto& [speed, all] : at_speed)
    for (const double x : all)
      EXPECT_TRUE(std::ranges::any_of(drawn,
                                      [&, speed = speed](const auto& row) {
                                        return std::stod(row[0]) == speed &&
                                               std::abs(std::stod(row[1]) - x) <=
                                                   (most - least) / 600;
                                      }))
          << speed << ' ' << x;
  EXPECT_TRUE(shows(picture(), "once a turn, mm"));
}

TEST_F(PlotSweep, DrawsACurveForEachCombinationOfTheOtherAxes) {
  sweep(speeds_ + sets_);
  draft("--columns rolling_onset_speed_Hz,peak_displacement_m");
  std::map<std::string, std::size_t> seen;
  for (const CsvRow& row : read_csv(folder_ / "s.csv")) {
    const bool is_corrected = row["equations_varied"] == "corrected";
    const auto points = drafts(is_corrected ? "panel1.csv" : "panel2.csv");
    const auto& point = points.at(seen[row["equations_varied"]]++);
    EXPECT_EQ(point[0], row["start_speed_Hz"]);
    EXPECT_EQ(std::stoi(point[1]), code_of(row["outcome"]));
    const std::string& onset_Hz = row["rolling_onset_speed_Hz"];
    EXPECT_EQ(point[4], onset_Hz.empty() ? "1" : "0");
    EXPECT_NEAR(std::stod(point[3]), 1e3 * static_cast<double>(row.number("peak_displacement_m")),
                1e-6);
  }
  const DrawnPicture drawn = picture();
  for (const char* text : {"start speed, Hz", "peak force to rolling, kN",
                           "at the lower edge: no value", "until = 0.02 s"})
    EXPECT_TRUE(shows(drawn, text)) << text;
}

// Of each outcome the bars have as many percent as there are draws, and each value is in one.
TEST_F(PlotSweep, DrawsAHistogramOfASample) {
  sweep("start_speed_Hz = 150\n" + sets_ + sample_);
  draft();
  const auto rows = read_csv(folder_ / "s.csv");
  for (const std::string panel : {"1", "2"}) {
    std::map<int, double> wanted;
    double rolls = 0;
    for (const CsvRow& row : rows)
      if ((row["equations_varied"] == "corrected") == (panel == "1")) {
        wanted[code_of(row["outcome"])] += 100. / 40;
        rolls += row["rolling_onset_s"].empty() ? 0 : 100. / 40;
      }
    for (const std::string column : {"1", "2", "3"}) {
      std::map<int, double> found;
      double all = 0;
      for (const auto& bar : drafts("bars" + panel + "-" + column + ".csv")) {
        found[std::stoi(bar[4])] += std::stod(bar[3]) - std::stod(bar[2]);
        all += std::stod(bar[3]) - std::stod(bar[2]);
      }
      EXPECT_NEAR(all, column == "3" ? rolls : 100, 1e-6);
      if (column == "3") continue;
      for (const auto& [code, percent] : wanted) EXPECT_NEAR(found[code], percent, 1e-6);
    }
  }
  for (const CsvRow& row : rows) {
    const double force = static_cast<double>(row.number("peak_force_to_rolling_N")) / 1e3,
                 digits = 1e-6 * force;
    const auto bars =
        drafts(row["equations_varied"] == "corrected" ? "bars1-2.csv" : "bars2-2.csv");
    EXPECT_TRUE(std::ranges::any_of(bars, [&](const auto& bar) {
      return std::stod(bar[0]) <= force + digits && std::stod(bar[1]) >= force - digits &&
             std::stoi(bar[4]) == code_of(row["outcome"]);
    })) << force;
  }
  EXPECT_TRUE(shows(picture(), "Sample of friction"));
}

// Nothing in a title acts as a command or a format of gnuplot.
TEST_F(PlotSweep, ShowsATitleAsItIs) {
  const std::string title = "{/:Bold x} `touch pwned` %s a_b '.system(`touch pwned`).'";
  for (const std::string& varied :
       {speeds_, speeds_ + clearances_, "start_speed_Hz = 150\n" + sample_}) {
    sweep(varied, "title = \"" + title + "\"\n");
    EXPECT_TRUE(shows(picture(), replaced(title, "'", "&apos;")) || shows(picture(), title));
    EXPECT_FALSE(fs::exists(folder_ / "pwned"));
  }
}

// Without tolerance and equations, and with a time of its own.
TEST_F(PlotSweep, SaysWhatThePointsShare) {
  sweep(speeds_ + clearances_);
  const DrawnPicture drawn = picture();
  EXPECT_TRUE(shows(drawn, "until = 0.02 s"));
  EXPECT_TRUE(shows(drawn, "corrected equations"));
  EXPECT_FALSE(shows(drawn, "0.5 s"));
  EXPECT_FALSE(shows(drawn, "tolerance"));
}

// A column without any value, and one that is constant.
TEST_F(PlotSweep, DrawsEmptyAndConstantColumns) {
  for (const std::string& varied : {replaced(speeds_, "\\[60.*300\\]", "[1, 2, 3]"),
                                    replaced(speeds_, "\\[60.*300\\]", "[1, 2, 3]") + clearances_,
                                    "start_speed_Hz = 1\n" + sample_})
    for (const char* column : {"rolling_onset_s", "touch_downs", "final_time_s"}) {
      sweep(varied, "columns = [\"rolling_onset_s\", \"touch_downs\", \"final_time_s\"]\n");
      picture(std::string("--columns ") + column);
    }
}

TEST_F(PlotSweep, RefusesInWordsWhatItCannotDraw) {
  sweep(speeds_, "columns = [\"outcome\", \"peak_force_to_rolling_N\", \"method\"]\n");
  for (const auto& [options, message] : std::vector<std::pair<std::string, std::string>>{
           {"--columns outcome", "--columns: outcome is drawn as the colour of the others"},
           {"--columns method", "has method = \"event\", which is not a number"},
           {"--columns touch_downs", "has no column touch_downs"},
           {"--until 1", "only --columns, --drafts and --out have an effect"},
           {"--equations published", "only --columns, --drafts and --out have an effect"}})
    expect_refusal("plot s.csv " + options, message);
  const std::string whole = content("s.csv");
  write("s.csv", replaced(whole, "rolling,", "rollin,"));
  expect_refusal("plot s.csv", "s.csv: is damaged or cut");
  shell(
      "sed -i '$d' s.csv && echo '# crc32 of the lines above:' $(gzip -c s.csv | tail -c 8 | od "
      "--endian=little -An -tu4 -N4) >>s.csv");
  expect_refusal("plot s.csv", "has outcome = \"rollin\", which is not an outcome of this version");
  write("s.csv", "a,b\n1,2\n");
  expect_refusal("plot s.csv", "s.csv: is not a file of results that rotor sweep has written");
  write("s.csv", replaced(whole, "until = 0.02", "until = 0.03 # another"));
  expect_refusal("plot s.csv", "s.csv: is damaged or cut");
  ASSERT_EQ(rotor("sweep s.toml --part 1/2").status, 0);
  expect_refusal("plot s.1-of-2.csv", "has the results of a part: rotor sweep --join puts all");
  expect_refusal("plot s.toml --columns outcome", "--columns: is for the results of a sweep");
  sweep("start_speed_Hz = 60\n" + sets_);
  expect_refusal("plot s.csv", "s.csv: no quantity has several numbers");
  sweep(replaced(speeds_, "\\[60.*300\\]", "[60, 70, 80, 90]") + sets_ + clearances_ +
        replaced(sample_, "count = 40", "count = 2"));
  expect_refusal("plot s.csv", "s.csv: has more than 6 combinations of start_speed_Hz, equations");
}

}  // namespace
}  // namespace rotor
