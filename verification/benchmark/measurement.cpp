#include "verification/benchmark/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace rotor {

Measurement::Measurement(double seconds_per_row) : seconds_per_row_(seconds_per_row) {
  fmt::print("{:<14} {:<31} {:>6} {:>8} {:>8} {:>8} {:>10} {:>9} {:>8}\n", "problem", "method",
             "set", "state", "event, s", "peak", "time, ms", "rhs", "steps");
}

void Measurement::enter(const std::string& method, const std::string& setting, const Solve& solve) {
  entries_.push_back({method, setting, solve});
}

void Measurement::run(const Problem& problem, const Outcome& exact) {
  constexpr int rounds = 50;
  for (int round = 0; round < rounds; ++round)
    for (Entry& entry : entries_)
      if (entry.works &&
          std::accumulate(entry.times.begin(), entry.times.end(), 0.) < seconds_per_row_)
        measure(entry, problem);
  for (const Entry& entry : entries_) add(row(entry, problem, exact));
  entries_.clear();
}

void Measurement::add(const Row& row) {
  fmt::print("{:<14} {:<31} {:>6} {:>8.1e} {:>8.1e} {:>8.1e} {:>10.3f} {:>9} {:>8}\n", row.problem,
             row.method, row.setting, row.error_state, row.error_event_s, row.error_peak,
             1e3 * row.time_s, row.right_hand_sides, row.steps);
  std::fflush(stdout);
  rows_.push_back(row);
}

void Measurement::measure(Entry& entry, const Problem& problem) {
  const auto begin = std::chrono::steady_clock::now();
  try {
    entry.outcome = entry.solve(problem);
  } catch (const std::runtime_error&) {
    entry.works = false;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  entry.times.push_back(time.count());
}

Row Measurement::row(const Entry& entry, const Problem& problem, const Outcome& exact) {
  Row row{.problem = problem.name, .method = entry.method, .setting = entry.setting};
  const double none = std::numeric_limits<double>::quiet_NaN();
  row.error_state = row.error_event_s = row.error_peak = row.time_s = none;
  if (!entry.works) return row;  // a failed solve is listed
  const Outcome& outcome = entry.outcome;
  row.error_state = state_error(problem, outcome, exact);
  row.error_event_s = event_error(outcome, exact);
  row.error_peak = peak_error(outcome, exact);
  row.time_s = std::ranges::min(entry.times);
  row.right_hand_sides = outcome.counters.right_hand_sides;
  row.steps = outcome.counters.steps;
  row.events = outcome.counters.located_events;
  row.contact_evaluations = outcome.counters.contact_evaluations;
  return row;
}

}  // namespace rotor
