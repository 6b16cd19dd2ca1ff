/// GSL as a peer: its adaptive Dormand-Prince steps of order 8 (rk8pd). GSL has no events:
/// the guards are evaluated after each step, and a root is found by repeating the step.
#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <boost/math/tools/toms748_solve.hpp>
#include <stdexcept>

#include "verification/benchmark/peers/peer.hpp"

namespace rotor {

class GslSolver : public PeerSolver {
 public:
  explicit GslSolver(double tolerance) : tolerance_(tolerance) { gsl_set_error_handler_off(); }

  std::optional<std::size_t> integrate(const PeerProblem& problem, PeerProblem::Unknowns& x,
                                       double& time_s, double until_s,
                                       Counters& counters) override {
    Task task{problem, counters};
    const gsl_odeiv2_system system{rates, nullptr, x.size(), &task};
    const auto scale = problem.scale(x);
    const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
        gsl_odeiv2_driver_alloc_scaled_new(&system, gsl_odeiv2_step_rk8pd, first_step, tolerance_,
                                           1e-3 * tolerance_, 1, 0, scale.data()),
        gsl_odeiv2_driver_free);
    gsl_odeiv2_driver& d = *driver;
    while (time_s < until_s) {
      const auto start = x;
      const double start_s = time_s;
      if (gsl_odeiv2_evolve_apply(d.e, d.c, d.s, &system, &time_s, until_s, &d.h, x.data()) != 0 ||
          ++counters.steps > most_steps)
        throw std::runtime_error("GSL gave up");
      const auto guards = problem.guards(x);
      const auto fired = std::ranges::find_if(guards, [](double g) { return g < 0; });
      if (fired == guards.end()) continue;

      const auto i = static_cast<std::size_t>(fired - guards.begin());
      const double length = time_s - start_s;
      const auto guard_after = [&](double part) {
        x = start;
        double errors[6];
        gsl_odeiv2_step_reset(d.s);
        gsl_odeiv2_step_apply(d.s, start_s, part * length, x.data(), errors, nullptr, nullptr,
                              &system);
        return problem.guards(x)[i];
      };
      const double before = problem.guards(start)[i];
      double part = 0;  // a phase may start on the far side by rounding
      if (before > 0) {
        boost::uintmax_t evaluations = 50;
        part = boost::math::tools::toms748_solve(guard_after, 0., 1., before, *fired,
                                                 boost::math::tools::eps_tolerance<double>(48),
                                                 evaluations)
                   .second;
      }
      guard_after(part);
      time_s = start_s + part * length;
      return i;
    }
    return std::nullopt;
  }

 private:
  struct Task {
    const PeerProblem& problem;
    Counters& counters;
  };

  static int rates(double, const double* y, double* rates, void* task) {
    ++static_cast<Task*>(task)->counters.right_hand_sides;
    static_cast<Task*>(task)->problem.rates(*reinterpret_cast<const PeerProblem::Unknowns*>(y),
                                            *reinterpret_cast<PeerProblem::Unknowns*>(rates));
    return GSL_SUCCESS;
  }

  static constexpr double first_step = 1e-6;
  static constexpr long most_steps = 1'000'000;

  double tolerance_;
};

}  // namespace rotor
