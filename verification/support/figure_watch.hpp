/// Looks at a run as densely as a figure's curves could ask for, and at the times of its rows.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "model/simulation/simulation.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/figure_list.hpp"

namespace rotor {

class FigureWatch : public Observer {
 public:
  using Values = std::vector<double>;  ///< of the figure's columns

  FigureWatch(const Figure& figure, const Scenario& scenario, std::vector<double> row_times)
      : figure_(figure),
        scenario_(scenario),
        times_(std::move(row_times)),
        at_(times_.size()),
        waits_(figure.from_rolling_onset),
        from_s_(figure.from_s),
        until_s_(figure.until_s) {}

  void on_instant(const Instant& at) override {
    if (waits_ && at.contact == ContactState::rolling) {
      waits_ = false;
      from_s_ = at.time_s;
      until_s_ = from_s_ + figure_.until_s;
    }
    note(at);
  }

  bool wants_dense_output(const double& from_s, const double& until_s) const override {
    return !waits_ && until_s > from_s_ && from_s < until_s_;
  }

  void on_step(const DenseOutput& step) override {
    constexpr long per_arc = 12;
    const double from = std::max(step.from_s, from_s_), until = std::min(step.until_s, until_s_);
    for (long n = 0; n <= per_arc * step.arcs; ++n)
      note(step.at(from + (until - from) * static_cast<double>(n) /
                              static_cast<double>(per_arc * step.arcs)));
    const auto first = std::lower_bound(times_.begin(), times_.end(), from);
    for (auto time = first; time != times_.end() && *time <= until; ++time)
      at_[static_cast<std::size_t>(time - times_.begin())].push_back(values(step.at(*time)));
  }

  double threshold(Extreme, const double& from_s, const double& until_s) const override {
    return wants_dense_output(from_s, until_s) ? 0 : std::numeric_limits<double>::infinity();
  }
  void on_maximum(const Maximum& maximum) override { note(maximum.at); }

  double from_s() const { return from_s_; }
  double until_s() const { return until_s_; }

  /// Of all instants in the window that were looked at.
  const std::vector<Values>& samples() const { return samples_; }

  /// At the time of a row: two instants where something happens.
  const std::vector<Values>& at(std::size_t row) const { return at_[row]; }

  /// The largest magnitude of a column that has located extremes.
  std::optional<double> largest(std::size_t column) const {
    const std::string& name = figure_.columns[column];
    if (name != "rho_m" && name != "normal_force_N") return std::nullopt;
    double largest = 0;
    for (const Values& sample : samples_) largest = std::max(largest, std::abs(sample[column]));
    return largest;
  }

 private:
  Values values(const Instant& at) const {
    Values all;
    for (const std::string& column : figure_.columns)
      all.push_back(column_by_formula(column, at, scenario_));
    return all;
  }

  void note(const Instant& at) {
    constexpr double rounding_s = 1e-11;
    if (waits_ || at.time_s < from_s_ - rounding_s || at.time_s > until_s_ + rounding_s) return;
    samples_.push_back(values(at));
    const auto [first, last] = std::equal_range(times_.begin(), times_.end(), at.time_s);
    for (auto time = first; time != last; ++time)
      at_[static_cast<std::size_t>(time - times_.begin())].push_back(samples_.back());
  }

  const Figure& figure_;
  const Scenario scenario_;
  const std::vector<double> times_;
  std::vector<std::vector<Values>> at_;
  bool waits_;
  double from_s_, until_s_;
  std::vector<Values> samples_;
};

}  // namespace rotor
