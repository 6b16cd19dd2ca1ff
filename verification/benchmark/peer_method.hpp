/// GSL as a peer: its adaptive Dormand-Prince steps of order 8 (rk8pd) through the same phases of
/// the motion. GSL has no events: the guards are evaluated after each step, and a root is found by
/// repeating the step.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <memory>
#include <stdexcept>

#include "model/phases/flight.hpp"
#include "model/run/simulation.hpp"

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

/// A run from an instant on, in coordinates of flight and of contact.
template <class ForFlight, class ForContact>
class GslMethod {
 public:
  GslMethod(const Scenario& scenario, double tolerance, const Instant& from)
      : tolerance_(tolerance), rotor_(scenario.parameters, scenario.equations), at_(from) {
    gsl_set_error_handler_off();
    rotor_.body = at_.body;
    rotor_.motor_on = at_.motor_on;
  }

  /// Throws std::runtime_error if GSL fails.
  RunEnd run(double until_s) {
    while (at_.time_s < until_s) switch (at_.contact) {
        case ContactState::free:
          pass<FreeFlight<double, ForFlight>, ForFlight>(until_s);
          break;
        case ContactState::indented:
          pass<IndentedFlight<double, ForContact>, ForContact>(until_s);
          break;
        case ContactState::sliding:
          pass<Sliding<double, ForContact>, ForContact>(until_s, at_.direction);
          break;
        case ContactState::rolling:
          pass<Rolling<double, ForContact>, ForContact>(until_s);
      }
    return {at_, counters_};
  }

 private:
  /// Integrates to the end of a phase, where one of its guards becomes negative, or to `until_s`.
  template <class Phase, class Chart, class... Direction>
  void pass(double until_s, Direction... direction) {
    const Chart chart(rotor_, at_.state);
    const Phase phase(rotor_, chart, direction...);
    auto x = chart.unknowns(at_.state);
    const auto guard = integrate(phase, x, until_s);
    at_.state = chart.state(x);
    if (guard == Phase::event_count) return;
    ++counters_.located_events;
    const Transition next =
        with_end<Phase::event_count>(guard, [&](auto end) { return phase.next(end, x); });
    at_.contact = next.contact;
    at_.direction = next.direction;
    if (next.event == Event::motor_off) rotor_.motor_on = at_.motor_on = false;
  }

  /// Returns the guard that became negative, or their number if none did.
  template <class Phase, class Unknowns>
  std::size_t integrate(const Phase& phase, Unknowns& x, double until_s) {
    const auto guard = [&](std::size_t n, const Unknowns& at) {
      return with_end<Phase::event_count>(n, [&](auto end) { return phase.guard(end, at); });
    };
    Task<Phase> task{phase, counters_};
    const gsl_odeiv2_system system{rates<Phase, Unknowns>, nullptr, x.size(), &task};
    const auto scale = phase.scale(x);
    const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
        gsl_odeiv2_driver_alloc_scaled_new(&system, gsl_odeiv2_step_rk8pd, first_step, tolerance_,
                                           1e-3 * tolerance_, 1, 0, scale.data()),
        gsl_odeiv2_driver_free);
    gsl_odeiv2_driver& d = *driver;
    while (at_.time_s < until_s) {
      const auto start = x;
      const double start_s = at_.time_s;
      if (gsl_odeiv2_evolve_apply(d.e, d.c, d.s, &system, &at_.time_s, until_s, &d.h, x.data()) ||
          ++counters_.steps > most_steps)
        throw std::runtime_error("GSL gave up");
      std::size_t i = 0;
      while (i < Phase::event_count && guard(i, x) >= 0) ++i;
      if (i == Phase::event_count) continue;

      const double after = guard(i, x), length = at_.time_s - start_s;
      const auto guard_after = [&](double part) {
        x = start;
        double errors[6];
        gsl_odeiv2_step_reset(d.s);
        gsl_odeiv2_step_apply(d.s, start_s, part * length, x.data(), errors, nullptr, nullptr,
                              &system);
        return guard(i, x);
      };
      const double before = guard(i, start);
      double part = 0;  // a phase may start on the far side by rounding
      if (before > 0) {
        boost::uintmax_t evaluations = 50;
        part = boost::math::tools::toms748_solve(guard_after, 0., 1., before, after,
                                                 boost::math::tools::eps_tolerance<double>(48),
                                                 evaluations)
                   .second;
      }
      guard_after(part);
      at_.time_s = start_s + part * length;
      return i;
    }
    return Phase::event_count;
  }

  template <class Phase>
  struct Task {
    const Phase& phase;
    Counters& counters;
  };

  template <class Phase, class Unknowns>
  static int rates(double, const double* y, double* rates, void* task) {
    ++static_cast<Task<Phase>*>(task)->counters.right_hand_sides;
    static_cast<Task<Phase>*>(task)->phase(*reinterpret_cast<const Unknowns*>(y),
                                           *reinterpret_cast<Unknowns*>(rates), 0);
    return GSL_SUCCESS;
  }

  static constexpr double first_step = 1e-6;
  static constexpr long most_steps = 1'000'000;

  double tolerance_;
  RotorSystem<double> rotor_;
  Instant at_;
  Counters counters_;
};

}  // namespace rotor
