/// What `rotor figure` writes, figure by figure: each column agrees with the motion of each run.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "figures/data/read_csv.hpp"
#include "figures/data/thinning.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/paper_figures.hpp"

namespace rotor {
namespace {

/// The rows of each run, their columns in the figure's order.
using Rows = std::vector<std::vector<double>>;

std::vector<std::pair<std::string, Rows>> rows_of(const Figure& figure, Equations equations) {
  std::vector<std::pair<std::string, Rows>> runs;
  for (const CsvRow& row : FigureFolder::of(equations).rows(figure.number)) {
    if (runs.empty() || runs.back().first != row["run"]) runs.push_back({row["run"], {}});
    runs.back().second.emplace_back();
    for (const Column* column : figure.scene.columns)
      runs.back().second.back().push_back(
          static_cast<double>(row.number(std::string(column->name))));
  }
  return runs;
}

/// How far a curve is from a value at a time, as a line through its rows; at a jump the line is
/// vertical.
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

/// The motion within a window, as its steps describe it.
class Samples : public Observer {
 public:
  Samples(double from_s, double until_s) : from_s_(from_s), until_s_(until_s) {}

  bool wants_dense_output(const double& from_s, const double& until_s) const override {
    return until_s > from_s_ && from_s < until_s_;
  }
  void on_step(const DenseOutput& step) override {
    constexpr int parts = 8;
    for (int n = 0; n < parts; ++n) {
      const double time_s = step.from_s + (step.until_s - step.from_s) * (n + 0.5) / parts;
      if (time_s >= from_s_ && time_s <= until_s_) all.push_back(step.at(time_s));
    }
  }
  void on_instant(const Instant& at) override {
    if (!onset_s && at.contact == ContactState::rolling) onset_s = at.time_s;
  }

  std::vector<Instant> all;
  std::optional<double> onset_s;  ///< of rolling

 private:
  double from_s_, until_s_;
};

class FigureData : public testing::TestWithParam<Figure> {};

// By runs of the test and independent formulas. Between the points at which rows are chosen, a line
// may be slightly further off than at them.
TEST_P(FigureData, IsTheMotionOfItsRuns) {
  const auto& [number, scene] = GetParam();
  constexpr double rounding = 1e-13;  // of velocities near 17 m/s; slip in rolling is nothing else
  std::map<std::string, Rows> data;
  for (auto& [name, rows] : rows_of(GetParam(), Equations::published)) data[name] = rows;
  for (const SceneRun& scene_run : scene.runs) {
    SCOPED_TRACE(scene_run.name);
    ASSERT_TRUE(data.contains(scene_run.name));
    const Rows& rows = data[scene_run.name];
    const double from_s = rows.front()[0], until_s = rows.back()[0];
    EXPECT_TRUE(std::ranges::is_sorted(rows, {}, [](const auto& row) { return row[0]; }));
    Samples samples(from_s, until_s);
    run(scene_run.scenario, samples);
    const Window& window = scene.window;
    EXPECT_NEAR(from_s, window.from_rolling_onset ? samples.onset_s.value() : window.from_s, 1e-10);
    EXPECT_NEAR(until_s, from_s + window.length_s, 1e-10);
    if (scene_run.scenario.method != Method::event) continue;  // its steps are the paper's
    EXPECT_GT(samples.all.size(), 100U);
    for (std::size_t i = 0; i < scene.columns.size(); ++i) {
      const std::string column(scene.columns[i]->name);
      if (column == "time_s" || column == "contact_state") continue;
      const auto [least, greatest] =
          std::ranges::minmax_element(rows, {}, [&](const auto& row) { return row[i]; });
      const double allowed = 1.3 * thinning * ((*greatest)[i] - (*least)[i]) + rounding;
      for (const Instant& at : samples.all)
        ASSERT_LE(distance(rows, i, at.time_s, column_by_formula(column, at, scene_run.scenario)),
                  allowed)
            << column << " at " << at.time_s << " s";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, FigureData, testing::ValuesIn(paper_figures()),
                         [](const auto& of) { return fmt::format("Fig{:02}", of.param.number); });

}  // namespace
}  // namespace rotor
