/// What a solver of another library needs to be entered to reference-data/problems. The problem,
/// its contact law, events and quantities are problem_run.cpp; a solver is what differs between
/// entries.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "verification/support/newton.hpp"

namespace rotor {

/// A function of the motion, and what follows where it falls through zero.
struct Root {
  std::function<double(const Newton&)> value;
  std::function<void()> follow;
};

/// The motion from an instant on, until a guard falls or the run ends.
struct Stretch {
  std::function<Newton(const Newton&)> rates;
  std::vector<Root> guards;
  Newton unit;          ///< of errors
  double first_step_s;  ///< leaves the zero of the guard that has just been passed
  double begin_s, until_s;
};

/// Integrates one stretch; errors are std::runtime_error.
class Solver {
 public:
  Solver() = default;
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  virtual ~Solver() = default;

  /// Takes a step of its own choice, or a part of it that ends where a guard falls. Returns that
  /// guard, if one fell.
  virtual const Root* step(double& time_s, Newton& x) = 0;
  /// Within the last step.
  virtual Newton at(double time_s) = 0;
  /// Where a function on [0, 1] with these values at the ends has passed its root.
  virtual double after_root(const std::function<double(double)>& f, double at_0, double at_1) = 0;

  /// Where it falls through zero within the last step.
  std::optional<double> time_of_fall(const Root& root, double from_s, double until_s) {
    const double before = root.value(at(from_s)), after = root.value(at(until_s));
    if (!(before >= 0 && after < 0)) return {};
    const auto time_s = [&](double part) { return from_s + part * (until_s - from_s); };
    return time_s(
        after_root([&](double part) { return root.value(at(time_s(part))); }, before, after));
  }
};

}  // namespace rotor
