/// The ways in which the benchmark solves its problems.
#pragma once

#include "verification/benchmark/problem.hpp"

namespace rotor {

/// The event-located method in extended precision by another stepper, which is the reference, and
/// by the same stepper, which estimates the error of the reference.
Outcome by_reference(const Problem& problem);
Outcome by_other_reference(const Problem& problem);

/// The event-located method at a tolerance.
Outcome by_events(const Problem& problem, double tolerance);
Outcome by_events_fehlberg78(const Problem& problem, double tolerance);

/// The published method with its step.
Outcome by_fixed_steps(const Problem& problem, double step);

/// The simplest use of Odeint: controlled Dormand-Prince steps on the paper's equations, with
/// friction against the present slip.
Outcome by_odeint_off_the_shelf(const Problem& problem, double tolerance);

/// A packaged solver.
struct Peer {
  std::string name;
  std::function<Outcome(const Problem&, double tolerance)> solve;
};

/// The solvers that are installed. Missing ones are named on standard output.
std::vector<Peer> peers();

}  // namespace rotor
