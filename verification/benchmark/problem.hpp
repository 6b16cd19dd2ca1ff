/// The problems of the benchmark: scenes of the paper, from states known in extended precision.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scenario/counters.hpp"
#include "model/scenario/observer.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

using Extended = long double;

struct Problem {
  std::string name;
  Scenario scenario;
  BasicInstant<Extended> start;
  bool is_run_up = false;

  bool touches() const { return start.contact != ContactState::free; }
};

/// The run-up, the rubs at three frictions, flight without contact, a single impact, and rolling.
std::vector<Problem> problems();

/// What a run found.
struct Outcome {
  State<double> state{};
  std::vector<double> touch_downs;
  double peak_force = 0;
  Counters counters;
};

/// One way to solve a problem. Throws std::runtime_error if it fails.
using Solve = std::function<Outcome(const Problem&)>;

/// The largest error of the position relative to the clearance, of the velocity relative to itself
/// and clearance times speed, and of the speed relative to itself.
double state_error(const Problem& problem, const Outcome& a, const Outcome& exact);

/// Largest error of the time of a touch-down, s; NaN if the counts differ.
double event_error(const Outcome& a, const Outcome& exact);

double peak_error(const Outcome& a, const Outcome& exact);

/// An instant rounded to double precision.
template <class S, class T>
BasicInstant<S> rounded(const BasicInstant<T>& at) {
  BasicInstant<S> result{.time_s = static_cast<S>(at.time_s),
                         .body = {static_cast<S>(at.body.mass), static_cast<S>(at.body.inertia),
                                  static_cast<S>(at.body.eccentricity)},
                         .motor_on = at.motor_on,
                         .mass_lost = at.mass_lost,
                         .contact = at.contact};
  for (std::size_t i = 0; i < 6; ++i) result.state[i] = static_cast<S>(at.state[i]);
  return result;
}

}  // namespace rotor
