/// A motion at a constant speed once a turn.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "figures/record/recorder.hpp"

namespace rotor {

/// The last turns of a run, one row each, at the instant at which e_x points down: its points of
/// Poincare. The run must have a dense output and a constant speed.
class Section : public Sampler {
 public:
  static constexpr long most_turns = 192, longest_period = 64;

  Section(const Scenario& scenario, RowSink sink)
      : Sampler(first_turn(scenario) / scenario.start_speed_Hz, scenario.until,
                1 / scenario.start_speed_Hz, columns(), scenario,
                [this, sink = std::move(sink)](std::span<const double> row) {
                  places_.emplace_back(row[1], row[2]);
                  sink(row);
                }),
        near_(1e-6 * Ring<double>(scenario.parameters).clearance) {}

  Section(const Section&) = delete;  // its sink refers to it
  Section& operator=(const Section&) = delete;

  /// Time, position, velocity and normal force.
  static std::vector<const Column*> columns() {
    std::vector<const Column*> all;
    for (const char* name :
         {"time_s", "x_a_m", "y_a_m", "x_a_rate_m_per_s", "y_a_rate_m_per_s", "normal_force_N"})
      all.push_back(find_column(name));
    return all;
  }

  /// The least number of turns after which O comes back, in all turns, to within a millionth of the
  /// clearance. Empty if there is none, or fewer than twice as many turns.
  std::optional<long> repeats_after() const {
    const auto turns = static_cast<long>(places_.size());
    for (long n = 1; n <= std::min(longest_period, turns / 2); ++n)
      if (std::equal(places_.begin() + n, places_.end(), places_.begin(),
                     [&](const auto& a, const auto& b) { return (a - b).norm() <= near_; }))
        return n;
    return std::nullopt;
  }

 private:
  /// The number of the first turn of the section; the last may be at the end, up to rounding.
  static double first_turn(const Scenario& scenario) {
    const double last = std::floor(scenario.until * scenario.start_speed_Hz + 1e-6);
    return std::max(0., last - (most_turns - 1));
  }

  double near_;
  std::vector<Vector<double>> places_;
};

}  // namespace rotor
