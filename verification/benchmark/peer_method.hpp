/// Peers: the solvers of other libraries through the same phases of the motion. They have no
/// events: the guards are evaluated after each step, and a root is found by repeating the step.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <memory>
#include <stdexcept>

#include "model/integration/fehlberg.hpp"
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

constexpr double first_step = 1e-6;  // s
constexpr int root_digits = 48;      // binary, of a root's place in a step
const boost::math::tools::eps_tolerance<double> at_root(root_digits);

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

/// GSL: adaptive Dormand-Prince steps of order 8 (rk8pd), errors relative to the phase's scale.
template <class Phase>
class Gsl {
 public:
  Gsl(const Counted<Phase>& system, const State<double>& x, double tolerance)
      : system_(system),
        scale_(system.phase.scale(x)),
        driver_(
            gsl_odeiv2_driver_alloc_scaled_new(&gsl_system_, gsl_odeiv2_step_rk8pd, first_step,
                                               tolerance, 1e-3 * tolerance, 1, 0, scale_.data()),
            gsl_odeiv2_driver_free) {
    gsl_set_error_handler_off();
  }

  /// Takes a step of its own choice, at most to `until_s`.
  void step(State<double>& x, double& time_s, double until_s) {
    gsl_odeiv2_driver& d = *driver_;
    if (gsl_odeiv2_evolve_apply(d.e, d.c, d.s, &gsl_system_, &time_s, until_s, &d.h, x.data()))
      throw std::runtime_error("GSL gave up");
  }
  /// Takes a step of that length.
  void step_by(State<double>& x, double length) {
    double errors[6];
    gsl_odeiv2_step_reset(driver_->s);
    gsl_odeiv2_step_apply(driver_->s, 0, length, x.data(), errors, nullptr, nullptr, &gsl_system_);
  }
  /// The end of an interval about a root between 0 and 1.
  template <class Function>
  static double after_root(const Function& f, double at_0, double at_1) {
    boost::uintmax_t evaluations = 50;
    return boost::math::tools::toms748_solve(f, 0., 1., at_0, at_1, at_root, evaluations).second;
  }

 private:
  static int rates(double time, const double* x, double* rates, void* system) {
    (*static_cast<const Counted<Phase>*>(system))(*reinterpret_cast<const State<double>*>(x),
                                                  *reinterpret_cast<State<double>*>(rates), time);
    return GSL_SUCCESS;
  }

  Counted<Phase> system_;
  gsl_odeiv2_system gsl_system_{rates, nullptr, 6, &system_};
  State<double> scale_;
  std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_;
};

/// Odeint as its users write it: controlled Fehlberg steps of order 8(7), and bisection.
template <class Phase>
class Odeint {
 public:
  Odeint(const Counted<Phase>& system, const State<double>& /*x*/, double tolerance)
      : system_(system),
        stepper_(boost::numeric::odeint::default_error_checker<
                     double, boost::numeric::odeint::array_algebra,
                     boost::numeric::odeint::default_operations>(1e-3 * tolerance, tolerance),
                 {}, unused_) {}

  void step(State<double>& x, double& time_s, double until_s) {
    for (int n = 0; n < 100; ++n) {
      const bool last = time_s + step_ >= until_s;
      double tried = last ? until_s - time_s : step_;
      const auto result = stepper_.try_step(std::cref(system_), x, time_s, tried);
      if (!last || tried < step_) step_ = tried;
      if (result == boost::numeric::odeint::fail) continue;
      if (last) time_s = until_s;
      return;
    }
    throw std::runtime_error("Odeint gave up");
  }
  void step_by(State<double>& x, double length) {
    stepper_.stepper().do_step(std::cref(system_), x, 0., length);
  }
  template <class Function>
  static double after_root(const Function& f, double /*at_0*/, double /*at_1*/) {
    return boost::math::tools::bisect(f, 0., 1., at_root).second;
  }

 private:
  using Stepper = Fehlberg78<State<double>, double>;
  // Odeint copies a stepper, and gcc warns if the arrays of that one were never set.
  static inline const Stepper unused_;

  Counted<Phase> system_;
  boost::numeric::odeint::controlled_runge_kutta<Stepper> stepper_;
  double step_ = first_step;
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
    Solver<Phase> solver({phase, counters_.right_hand_sides}, x, tolerance_);
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
