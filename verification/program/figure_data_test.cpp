/// What `rotor figure` writes, against the engine asked directly, figure by figure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "figures/data/csv.hpp"
#include "figures/data/thinning.hpp"
#include "figures/scenes/names.hpp"
#include "figures/scenes/recorder.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/figure_list.hpp"
#include "verification/support/figure_watch.hpp"

namespace rotor {
namespace {

/// The data of all figures in one set of equations, written once.
class FigureFolder {
 public:
  explicit FigureFolder(Equations equations)
      : path_(fs::temp_directory_path() /
              fmt::format("rotor-figures-{}-{}", ::getpid(), name_of(equations))) {
    const std::string command =
        fmt::format("'{}' figure --out '{}' --equations {} 2>&1 >/dev/null | cat >/dev/null",
                    ROTOR_PROGRAM, path_.string(), name_of(equations));
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  ~FigureFolder() { fs::remove_all(path_); }
  FigureFolder(const FigureFolder&) = delete;
  FigureFolder& operator=(const FigureFolder&) = delete;

  fs::path csv(int number) const { return path_ / fmt::format("fig{:02}.csv", number); }

  static const FigureFolder& of(Equations equations) {
    static const FigureFolder published(Equations::published), consistent(Equations::consistent);
    return equations == Equations::published ? published : consistent;
  }

 private:
  fs::path path_;
};

/// Of velocities near 17 m/s: in rolling, the slip is nothing else.
constexpr double rounding = 1e-13;

/// The rows of each run, their columns in the figure's order.
using Rows = std::vector<std::vector<double>>;

std::vector<std::pair<std::string, Rows>> rows_of(const Figure& figure, Equations equations) {
  std::vector<std::pair<std::string, Rows>> runs;
  for (const CsvRow& row : read_csv(FigureFolder::of(equations).csv(figure.number))) {
    if (runs.empty() || runs.back().first != row["run"]) runs.push_back({row["run"], {}});
    runs.back().second.emplace_back();
    for (const std::string& column : figure.columns)
      runs.back().second.back().push_back(static_cast<double>(row.number(column)));
  }
  return runs;
}

/// How far a curve lies from a value at a time, as a line through its rows; where it jumps, the
/// line is upright.
double distance(const Rows& rows, std::size_t column, double time_s, double value) {
  constexpr double rounding_s = 1e-11;
  auto right = std::lower_bound(rows.begin(), rows.end(), time_s - rounding_s,
                                [](const auto& row, double t) { return row[0] < t; });
  if (right != rows.begin()) --right;
  double least = std::numeric_limits<double>::infinity();
  for (; right + 1 < rows.end() && (*right)[0] <= time_s + rounding_s; ++right) {
    const double t = (*right)[0], h = (*(right + 1))[0] - t;
    const double a = (*right)[column], b = (*(right + 1))[column];
    if (h > rounding_s)
      least = std::min(least, std::abs(value - (a + (b - a) * (time_s - t) / h)));
    else
      least = std::min({least, std::max({0., std::min(a, b) - value, value - std::max(a, b)})});
  }
  return least;
}

class FigureData : public testing::TestWithParam<std::tuple<Figure, Equations>> {
 protected:
  const Figure& figure() const { return std::get<0>(GetParam()); }
  Equations equations() const { return std::get<1>(GetParam()); }
  Scenario scenario(std::size_t run) const {
    Scenario scenario = figure().runs[run].second;
    scenario.equations = equations();
    return scenario;
  }
};

TEST_P(FigureData, HasItsRunsInOrderFromTheBeginningToTheEndOfItsWindow) {
  const auto runs = rows_of(figure(), equations());
  ASSERT_EQ(runs.size(), figure().runs.size());
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const auto& [name, rows] = runs[n];
    EXPECT_EQ(name, figure().runs[n].first);
    ASSERT_GT(rows.size(), 10U);
    double from_s = figure().from_s, until_s = figure().until_s;
    if (figure().number == 10) {
      FigureWatch watch(figure(), scenario(n), {});
      run(scenario(n), watch);
      from_s = watch.from_s();
      until_s = watch.until_s();
    }
    EXPECT_NEAR(rows.front()[0], from_s, 1e-10);
    EXPECT_NEAR(rows.back()[0], until_s, 1e-10);
    EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(),
                               [](const auto& a, const auto& b) { return a[0] < b[0]; }));
  }
}

// Rows are instants of the motion, and the lines between them stay as close to it as thinning
// promises.
TEST_P(FigureData, IsTheMotionThatTheEngineGives) {
  const auto runs = rows_of(figure(), equations());
  ASSERT_EQ(runs.size(), figure().runs.size());
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const auto& [name, rows] = runs[n];
    std::vector<double> times;
    for (const auto& row : rows) times.push_back(row[0]);
    FigureWatch watch(figure(), scenario(n), times);
    run(scenario(n), watch);
    for (std::size_t column = 1; column < figure().columns.size(); ++column) {
      const std::string at = name + ": " + figure().columns[column];
      double least = std::numeric_limits<double>::infinity(), greatest = -least;
      for (const auto& sample : watch.samples()) {
        least = std::min(least, sample[column]);
        greatest = std::max(greatest, sample[column]);
      }
      const double range = greatest - least;
      double off = 0, between = 0;
      for (std::size_t row = 0; row < rows.size(); ++row) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& instant : watch.at(row))
          nearest = std::min(nearest, std::abs(instant[column] - rows[row][column]));
        off = std::max(off, nearest);
      }
      for (const auto& sample : watch.samples())
        between = std::max(between, distance(rows, column, sample[0], sample[column]));
      EXPECT_LE(off, 1e-11 * std::max(range, std::abs(greatest)) + rounding) << at;
      EXPECT_LE(between, thinning * range + rounding) << at;

      // The extremes that the engine locates stand in the data themselves.
      const auto extreme = watch.largest(column);
      if (!extreme) continue;
      double largest = 0;
      for (const auto& row : rows) largest = std::max(largest, std::abs(row[column]));
      EXPECT_NEAR(largest, *extreme, 1e-12 * *extreme) << at;
    }
  }
}

TEST_P(FigureData, SaysWhereItComesFrom) {
  std::ifstream file(FigureFolder::of(equations()).csv(figure().number));
  std::vector<std::string> lines, predictions;
  for (std::string line; std::getline(file, line) && line.starts_with('#');)
    (line.find(": by closed forms, ") == std::string::npos ? lines : predictions).push_back(line);
  std::size_t losing = 0;
  for (std::size_t n = 0; n < figure().runs.size(); ++n) losing += scenario(n).parameters.separates;
  EXPECT_EQ(predictions.size(), losing);
  ASSERT_EQ(lines.size(), 2 + figure().runs.size() + figure().columns.size());
  EXPECT_TRUE(lines[0].starts_with(fmt::format("# Fig. {}: ", figure().number))) << lines[0];
  EXPECT_EQ(lines[1], "# rotor " ROTOR_VERSION);
  for (std::size_t n = 0; n < figure().runs.size(); ++n) {
    const Scenario of = scenario(n);
    std::string expected =
        fmt::format("# {}: equations {}, method {}", figure().runs[n].first, name_of(equations()),
                    of.method == Method::rk4 ? "rk4" : "event");
    for (const Quantity& quantity : quantities())
      expected += fmt::format(", {} = {}{}{}", quantity.name, quantity.of(of),
                              quantity.unit.empty() ? "" : " ", quantity.unit);
    if (!of.parameters.separates) expected += ", no mass loss";
    EXPECT_EQ(lines[2 + n], expected);
  }
}

std::string name_of_case(const testing::TestParamInfo<FigureData::ParamType>& c) {
  const auto& [figure, equations] = c.param;
  return fmt::format("Fig{:02}{}", figure.number,
                     equations == Equations::published ? "Published" : "Consistent");
}

INSTANTIATE_TEST_SUITE_P(Every, FigureData,
                         testing::Combine(testing::ValuesIn(paper_figures()),
                                          testing::Values(Equations::published,
                                                          Equations::consistent)),
                         name_of_case);

class PinnedFigure : public testing::TestWithParam<Figure> {};

// The chain's other end: values from the run in quadruple precision, with formulas of its own.
TEST_P(PinnedFigure, PassesThroughTheValuesOfTheReference) {
  const Figure& figure = GetParam();
  std::map<std::string, Rows> data;
  for (auto& [name, rows] : rows_of(figure, Equations::published)) data[name] = rows;
  std::map<std::string, int> pinned;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/figure-values.csv")) {
    if (row["figure"] != std::to_string(figure.number)) continue;
    ASSERT_TRUE(data.contains(row["run"])) << row["run"];
    const Rows& rows = data[row["run"]];
    const auto column = static_cast<std::size_t>(
        std::find(figure.columns.begin(), figure.columns.end(), row["column"]) -
        figure.columns.begin());
    ASSERT_LT(column, figure.columns.size());
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const auto& values : rows) {
      least = std::min(least, values[column]);
      greatest = std::max(greatest, values[column]);
    }
    const auto time_s = static_cast<double>(row.number("time_s"));
    const auto value = static_cast<double>(row.number("value"));
    EXPECT_LE(distance(rows, column, time_s, value), thinning * (greatest - least) + rounding)
        << "fig" << figure.number << ", " << row["run"] << ": " << row["column"] << " at " << time_s
        << " s is to be " << value;
    ++pinned[row["run"]];
  }
  for (const auto& [name, scenario] : figure.runs)
    EXPECT_EQ(pinned[name] >= 7, scenario.method == Method::event) << name;
}

INSTANTIATE_TEST_SUITE_P(Every, PinnedFigure, testing::ValuesIn(paper_figures()),
                         [](const auto& c) { return fmt::format("Fig{:02}", c.param.number); });

}  // namespace
}  // namespace rotor
