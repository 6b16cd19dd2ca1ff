#include "verification/benchmark/problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/support/follow_with.hpp"

namespace rotor {

std::vector<Problem> problems() {
  std::vector<Problem> all;
  Scenario run_up;
  run_up.parameters.loses_mass = false;
  run_up.until = 29.1;
  all.push_back({"run-up", run_up, at_rest<Extended>(run_up.parameters), true});

  const Scenario high{.until = 29.2};
  all.push_back({"rub mu = 0.3", high, after_mass_loss_with<Extended>(high, 1e-15L)});
  const Scenario intermediate{.parameters = {.friction = 0.2}};
  all.push_back(
      {"rub mu = 0.2", intermediate, after_mass_loss_with<Extended>(intermediate, 1e-15L)});
  const Scenario low{.parameters = {.friction = 0.08}};
  all.push_back({"rub mu = 0.08", low, after_mass_loss_with<Extended>(low, 1e-15L)});
  const Scenario clear{.parameters = {.mass_loss_time = 9.4}, .until = 10.4};
  all.push_back({"no contact", clear, after_mass_loss_with<Extended>(clear, 1e-15L)});
  Problem impact{"single impact", high, after_mass_loss_with<Extended>(high, 1e-15L)};
  impact.scenario.until = 29.106;
  all.push_back(impact);

  Problem rolling{"rolling", Scenario{}, {}};
  rolling.scenario.until = 29.15;
  BasicObserver<Extended> null_observer;
  rolling.start =
      follow_with<Extended>(rolling.scenario, 1e-15L, all[1].start, 29.15L, null_observer).last;
  rolling.scenario.until = 29.35;
  all.push_back(rolling);
  return all;
}

double state_error(const Problem& problem, const Outcome& a, const Outcome& exact) {
  const double length = Ring<double>(problem.scenario.parameters).clearance;
  const auto& [q1, q2, q3, v1, v2, w] = exact.state;
  return std::max(
      {std::hypot(a.state[0] - q1, a.state[1] - q2) / length,
       std::hypot(a.state[3] - v1, a.state[4] - v2) / (std::hypot(v1, v2) + length * std::abs(w)),
       std::abs(a.state[5] - w) / std::abs(w)});
}

double event_error(const Outcome& a, const Outcome& exact) {
  if (a.touch_downs.size() != exact.touch_downs.size())
    return std::numeric_limits<double>::quiet_NaN();
  double largest = 0;
  for (std::size_t i = 0; i < a.touch_downs.size(); ++i)
    largest = std::max(largest, std::abs(a.touch_downs[i] - exact.touch_downs[i]));
  return largest;
}

double peak_error(const Outcome& a, const Outcome& exact) {
  return exact.peak_force > 0 ? std::abs(a.peak_force / exact.peak_force - 1) : 0;
}

}  // namespace rotor
