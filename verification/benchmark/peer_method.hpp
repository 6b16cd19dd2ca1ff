/// Peers: the solvers of other libraries through the same phases of the motion. They have no
/// events: the guards are evaluated after each step, and a root is found by repeating the step.
#pragma once

#include <stdexcept>

#include "model/phases/flight.hpp"
#include "model/run/simulation.hpp"
#include "verification/benchmark/peers.hpp"

namespace rotor {

/// The paper's own coordinates as a chart of model/phases: O in the axes that turn with the rotor,
/// and the rotor's angle.
class PaperChart {
 public:
  using Unknowns = State<double>;

  struct Kinematics {
    Motion<double> motion;
  };

  PaperChart(const RotorSystem<double>& rotor, const Unknowns& /*q*/)
      : body_(rotor.body), ring_(rotor.ring) {}

  Unknowns unknowns(const Unknowns& q) const { return q; }
  Unknowns state(const Unknowns& x) const { return x; }
  double speed(const Unknowns& x) const { return x[5]; }
  double speed_with_ripple(const Unknowns& x) const { return x[5]; }
  Kinematics kinematics(const Unknowns& x) const {
    return {RotatingFrame<double>::motion(body_, x)};
  }
  RimPoint<double> rim_point(const Unknowns& x) const {
    return ring_.rim_point(kinematics(x).motion);
  }
  Unknowns rates(const Unknowns& x, const Kinematics& at, const Acceleration<double>& a) const {
    return RotatingFrame<double>::rates(at.motion, x, a);
  }
  Unknowns scale(double length, double frequency, double speed) const {
    return {length, length, 1, length * frequency, length * frequency, speed};
  }
  /// The slip is not one of these coordinates: it is only as small as the integrator keeps it.
  Unknowns without_slip(const Unknowns& x) const { return x; }

 private:
  Body<double> body_;
  Ring<double> ring_;
};

constexpr double first_step = 1e-6;  // s

/// Counts the evaluations of a phase.
template <class Phase>
struct Counted {
  const Phase& phase;
  long& right_hand_sides;

  void operator()(const State<double>& x, State<double>& rates, double time) const {
    ++right_hand_sides;
    phase(x, rates, time);
  }
};

/// A run from an instant on, in coordinates of flight and of contact.
template <template <class> class Solver, class ForFlight, class ForContact>
class PeerMethod {
 public:
  PeerMethod(const Scenario& scenario, double tolerance, const Instant& from)
      : tolerance_(tolerance), rotor_(scenario.parameters, scenario.equations), at_(from) {
    rotor_.body = at_.body;
    rotor_.motor_on = at_.motor_on;
  }

  /// Throws std::runtime_error if the solver fails.
  RunEnd run(double until_s) {
    while (at_.time_s < until_s) {
      switch (at_.contact) {
        case ContactState::free:
          pass<FreeFlight<double, ForFlight>, ForFlight>(until_s);
          break;
        case ContactState::indented:
          pass<IndentedFlight<double, ForContact>, ForContact>(until_s);
          break;
        case ContactState::sliding:
          pass<Sliding<double, ForContact>, ForContact>(until_s, at_.slip_sign);
          break;
        case ContactState::rolling:
          pass<Rolling<double, ForContact>, ForContact>(until_s);
          break;
      }
    }
    return {at_, counters_};
  }

 private:
  /// Integrates to the end of a phase, where one of its guards becomes negative, or to `until_s`.
  template <class Phase, class Chart, class... Sign>
  void pass(double until_s, Sign... slip_sign) {
    const Chart chart(rotor_, at_.state);
    const Phase phase(rotor_, chart, slip_sign...);
    auto x = chart.unknowns(at_.state);
    const auto guard = integrate(phase, x, until_s);
    at_.state = chart.state(x);
    if (guard == Phase::event_count) return;
    ++counters_.located_events;
    const Transition next =
        with_exit<Phase::event_count>(guard, [&](auto exit) { return phase.next(exit, x); });
    at_.contact = next.contact;
    at_.slip_sign = next.slip_sign;
    if (next.event == Event::motor_off) rotor_.motor_on = at_.motor_on = false;
  }

  /// Returns the guard that became negative, or their number if none did.
  template <class Phase>
  std::size_t integrate(const Phase& phase, State<double>& x, double until_s) {
    const auto guard = [&](std::size_t n, const State<double>& at) {
      return with_exit<Phase::event_count>(n, [&](auto exit) { return phase.guard(exit, at); });
    };
    Solver<Counted<Phase>> solver({phase, counters_.right_hand_sides}, phase.scale(x), tolerance_,
                                  first_step);
    while (at_.time_s < until_s) {
      const State<double> start = x;
      const double start_s = at_.time_s;
      solver.step(x, at_.time_s, until_s);
      if (++counters_.steps > most_steps) throw std::runtime_error("too many steps");
      std::size_t i = 0;
      while (i < Phase::event_count && guard(i, x) >= 0) ++i;
      if (i == Phase::event_count) continue;

      const double after = guard(i, x), before = guard(i, start), length = at_.time_s - start_s;
      const auto guard_after = [&](double part) {
        x = start;
        solver.step_by(x, part * length);
        return guard(i, x);
      };
      // A phase may start on the far side by rounding.
      const double part = before > 0 ? solver.after_root(guard_after, before, after) : 0;
      guard_after(part);
      at_.time_s = start_s + part * length;
      return i;
    }
    return Phase::event_count;
  }

  static constexpr long most_steps = 1'000'000;

  double tolerance_;
  RotorSystem<double> rotor_;
  Instant at_;
  Counters counters_;
};

}  // namespace rotor
