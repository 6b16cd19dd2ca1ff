/// CVODE of SUNDIALS with its own location of events.
#pragma once

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <stdexcept>

#include "verification/benchmark/solver.hpp"

namespace rotor {

/// Adams methods, as its manual has it for systems that are not stiff.
class Cvode : public Solver {
 public:
  Cvode(const Stretch& stretch, const Newton& x, double tolerance)
      : stretch_(stretch), now_(x), least_(stretch.unit) {
    check(SUNContext_Create(0, &context_));
    for (double& least : least_) least *= tolerance / 100;
    for (auto [vector, values] : {std::pair(&vectors_[0], &now_), std::pair(&vectors_[1], &there_),
                                  std::pair(&vectors_[2], &least_)})
      *vector = N_VMake_Serial(6, values->data(), context_);
    solver_ = CVodeCreate(CV_ADAMS, context_);
    iteration_ = SUNNonlinSol_FixedPoint(vectors_[0], 0, context_);
    std::vector<int> falling(stretch.guards.size(), -1);
    check(CVodeInit(solver_, rates_of, stretch.begin_s, vectors_[0]));
    check(CVodeSetUserData(solver_, this));
    check(CVodeSVtolerances(solver_, tolerance, vectors_[2]));
    check(CVodeSetNonlinearSolver(solver_, iteration_));
    check(CVodeRootInit(solver_, static_cast<int>(falling.size()), guards_of));
    check(CVodeSetRootDirection(solver_, falling.data()));
    check(CVodeSetNoInactiveRootWarn(solver_));
    check(CVodeSetInitStep(solver_,
                           std::min(stretch.first_step_s, stretch.until_s - stretch.begin_s)));
    check(CVodeSetStopTime(solver_, stretch.until_s));
  }
  ~Cvode() override {
    CVodeFree(&solver_);
    SUNNonlinSolFree(iteration_);
    for (const N_Vector vector : vectors_) N_VDestroy(vector);
    SUNContext_Free(&context_);
  }

  const Root* step(double& time_s, Newton& x) override {
    const int flag = CVode(solver_, stretch_.until_s, vectors_[0], &time_s, CV_ONE_STEP);
    check(flag);
    x = now_;
    if (flag != CV_ROOT_RETURN) return nullptr;
    std::vector<int> which(stretch_.guards.size());
    check(CVodeGetRootInfo(solver_, which.data()));
    const auto fallen = std::find_if(which.begin(), which.end(), [](int w) { return w != 0; });
    return &stretch_.guards.at(static_cast<std::size_t>(fallen - which.begin()));
  }
  Newton at(double time_s) override {
    check(CVodeGetDky(solver_, time_s, 0, vectors_[1]));
    return there_;
  }
  double after_root(const std::function<double(double)>& f, double, double) override {
    return boost::math::tools::bisect(f, 0., 1., boost::math::tools::eps_tolerance<double>(52))
        .second;
  }

 private:
  static void check(int flag) {
    if (flag < 0) throw std::runtime_error(fmt::format("CVODE gave up with {}", flag));
  }
  static Newton& newton(N_Vector x) { return *reinterpret_cast<Newton*>(N_VGetArrayPointer(x)); }
  static int rates_of(double /*time*/, N_Vector x, N_Vector rates, void* self) {
    newton(rates) = static_cast<Cvode*>(self)->stretch_.rates(newton(x));
    return 0;
  }
  static int guards_of(double /*time*/, N_Vector x, double* values, void* self) {
    for (const Root& guard : static_cast<Cvode*>(self)->stretch_.guards)
      *values++ = guard.value(newton(x));
    return 0;
  }

  const Stretch& stretch_;
  Newton now_, there_{}, least_;
  SUNContext context_{};
  std::array<N_Vector, 3> vectors_{};
  void* solver_ = nullptr;
  SUNNonlinearSolver iteration_{};
};

}  // namespace rotor
