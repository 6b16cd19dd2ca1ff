/// What `rotor figure` writes, against values in quadruple precision, figure by figure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "figures/data/thinning.hpp"
#include "verification/support/figure_folder.hpp"
#include "verification/support/figure_list.hpp"

namespace rotor {
namespace {

/// Of velocities near 17 m/s: in rolling, the slip is nothing else.
constexpr double rounding = 1e-13;

/// The rows of each run, their columns in the figure's order.
using Rows = std::vector<std::vector<double>>;

std::vector<std::pair<std::string, Rows>> rows_of(const Figure& figure, Equations equations) {
  std::vector<std::pair<std::string, Rows>> runs;
  for (const CsvRow& row : FigureFolder::of(equations).rows(figure.number)) {
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

std::string name_of_figure(const testing::TestParamInfo<Figure>& of) {
  return fmt::format("Fig{:02}", of.param.number);
}

class PinnedFigure : public testing::TestWithParam<Figure> {};

// From the run in quadruple precision, with formulas of its own.
TEST_P(PinnedFigure, PassesThroughTheValuesOfTheReference) {
  const Figure& figure = GetParam();
  std::map<std::string, Rows> data;
  for (auto& [name, rows] : rows_of(figure, Equations::published)) data[name] = rows;
  std::map<std::string, int> pinned;
  for (const auto& [name, rows] : data) {
    const double from_s = figure.from_rolling_onset ? rows.front()[0] : figure.from_s;
    const double length_s = figure.until_s - figure.from_s;
    EXPECT_NEAR(rows.front()[0], from_s, 1e-10) << name;
    EXPECT_NEAR(rows.back()[0], from_s + length_s, 1e-10) << name;
    EXPECT_TRUE(std::ranges::is_sorted(rows, {}, [](const auto& row) { return row[0]; })) << name;
  }
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

INSTANTIATE_TEST_SUITE_P(Every, PinnedFigure, testing::ValuesIn(paper_figures()), name_of_figure);

}  // namespace
}  // namespace rotor
