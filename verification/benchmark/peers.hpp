/// Steps by GSL and by Odeint, from an instant on. Neither finds events.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <boost/math/tools/roots.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <functional>
#include <memory>
#include <stdexcept>

#include "model/integration/fehlberg.hpp"
#include "model/mechanics/rotating_frame.hpp"

namespace rotor {

constexpr int root_digits = 48;  // binary, of a root's place in a step
const boost::math::tools::eps_tolerance<double> at_root(root_digits);

/// GSL: adaptive Dormand-Prince steps of order 8 (rk8pd), errors relative to a scale.
template <class System>
class Gsl {
 public:
  Gsl(const System& system, const State<double>& scale, double tolerance, double first_step)
      : system_(system),
        scale_(scale),
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
    (*static_cast<const System*>(system))(*reinterpret_cast<const State<double>*>(x),
                                          *reinterpret_cast<State<double>*>(rates), time);
    return GSL_SUCCESS;
  }

  System system_;
  gsl_odeiv2_system gsl_system_{rates, nullptr, 6, &system_};
  State<double> scale_;
  std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_;
};

/// Odeint as its users write it: controlled Fehlberg steps of order 8(7), and bisection.
template <class System>
class Odeint {
 public:
  Odeint(const System& system, const State<double>& /*scale*/, double tolerance, double first_step)
      : system_(system),
        stepper_(boost::numeric::odeint::default_error_checker<
                     double, boost::numeric::odeint::array_algebra,
                     boost::numeric::odeint::default_operations>(1e-3 * tolerance, tolerance),
                 {}, unused_),
        step_(first_step) {}

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

  System system_;
  boost::numeric::odeint::controlled_runge_kutta<Stepper> stepper_;
  double step_;
};

}  // namespace rotor
