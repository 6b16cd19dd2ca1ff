/// A peer of the event-located method: the same phases, guards and resets, integrated by SUNDIALS
/// with its own root-finding. CVODE (Adams with fixed-point iteration, BDF with Newton and a dense
/// matrix) and ARKODE's explicit Runge-Kutta of orders 5 and 8.
#pragma once

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <boost/math/constants/constants.hpp>
#include <functional>
#include <memory>
#include <stdexcept>

#include "model/phases.hpp"
#include "model/simulation.hpp"

namespace rotor {

enum class SundialsSolver { adams, bdf, erk5, erk8 };

class SundialsMethod {
 public:
  SundialsMethod(const Scenario& scenario, SundialsSolver solver, double tolerance,
                 Observer& observer, Work& work)
      : solver_(solver),
        tolerance_(tolerance),
        observer_(observer),
        work_(work),
        around_{.body = Body<double>::of(scenario.parameters),
                .supports = Supports<double>(scenario.parameters, scenario.equations),
                .ring = Ring<double>(scenario.parameters),
                .motor_off =
                    boost::math::constants::two_pi<double>() * scenario.parameters.motor_off_Hz,
                .motor_on = true},
        context_(make_context()),
        y_(N_VNew_Serial(6, context_.get()), N_VDestroy),
        absolute_(N_VNew_Serial(6, context_.get()), N_VDestroy),
        matrix_(SUNDenseMatrix(6, 6, context_.get()), SUNMatDestroy),
        linear_(SUNLinSol_Dense(y_.get(), matrix_.get(), context_.get()), SUNLinSolFree),
        fixed_point_(SUNNonlinSol_FixedPoint(y_.get(), 0, context_.get()), SUNNonlinSolFree) {}

  Instant rub(Instant at, double until_s) {
    around_.body = at.body;
    around_.motor_on = at.motor_on;
    while (at.time_s < until_s) {
      const auto guard = integrate(at, until_s);
      if (!guard) break;
      ++work_.located_events;
      if (*guard == Guard::motor) {
        around_.motor_on = at.motor_on = false;
      } else {
        const Begin begin = follow(*guard, around_, at.state);
        at.contact = begin.contact;
        direction_ = begin.direction;
      }
      observer_.see(at);
    }
    observer_.see(at);
    return at;
  }

 private:
  using Unknowns = std::array<double, 6>;
  template <class T, class Free>
  using Handle = std::unique_ptr<std::remove_pointer_t<T>, Free>;

  static std::shared_ptr<std::remove_pointer_t<SUNContext>> make_context() {
    SUNContext context = nullptr;
    if (SUNContext_Create(nullptr, &context) != 0) throw std::runtime_error("SUNDIALS: no context");
    return {context, [](SUNContext c) { SUNContext_Free(&c); }};
  }

  /// A phase as SUNDIALS sees it: plain functions and a pointer.
  template <class Phase>
  struct Problem {
    const Phase& phase;
    Work& work;

    static int rates(realtype t, N_Vector y, N_Vector ydot, void* self) {
      const auto& problem = *static_cast<Problem*>(self);
      ++problem.work.right_hand_sides;
      problem.phase(unknowns(y), *reinterpret_cast<Unknowns*>(N_VGetArrayPointer(ydot)), t);
      return 0;
    }
    static int roots(realtype, N_Vector y, realtype* g, void* self) {
      const auto guards = static_cast<Problem*>(self)->phase.guards(unknowns(y));
      std::ranges::copy(guards, g);
      return 0;
    }
  };

  static Unknowns& unknowns(N_Vector y) {
    return *reinterpret_cast<Unknowns*>(N_VGetArrayPointer(y));
  }

  std::optional<Guard> integrate(Instant& at, double until_s) {
    switch (at.contact) {
      case ContactState::free:
        return integrate(FreeFlight<double>(around_, at.state), at, until_s);
      case ContactState::indented:
        return integrate(IndentedFlight<double>(around_, at.state), at, until_s);
      case ContactState::sliding:
        return integrate(Sliding<double>(around_, at.state, direction_), at, until_s);
      case ContactState::rolling:
        return integrate(Rolling<double>(around_, at.state), at, until_s);
    }
    return std::nullopt;
  }

  template <class Phase>
  std::optional<Guard> integrate(const Phase& phase, Instant& at, double until_s) {
    Problem<Phase> problem{phase, work_};
    unknowns(y_.get()) = phase.unknowns(at.state);
    unknowns(absolute_.get()) = phase.scale(unknowns(y_.get()));
    for (double& size : unknowns(absolute_.get())) size *= tolerance_;
    std::array<int, Phase::guard_names.size()> fired{};
    const bool cvode = solver_ == SundialsSolver::adams || solver_ == SundialsSolver::bdf;
    const int status =
        cvode ? by_cvode(problem, at, until_s, fired) : by_arkode(problem, at, until_s, fired);
    if (status < 0) throw std::runtime_error("SUNDIALS gave up");
    at.state = phase.state(unknowns(y_.get()));
    for (std::size_t i = 0; i < fired.size(); ++i)
      if (fired[i] != 0) return Phase::guard_names[i];
    return std::nullopt;
  }

  template <class Phase, class Fired>
  int by_cvode(Problem<Phase>& problem, Instant& at, double until_s, Fired& fired) {
    const bool adams = solver_ == SundialsSolver::adams;
    const auto close = [](void* memory) { CVodeFree(&memory); };
    std::unique_ptr<void, decltype(close)> memory(
        CVodeCreate(adams ? CV_ADAMS : CV_BDF, context_.get()), close);
    void* cv = memory.get();
    CVodeInit(cv, Problem<Phase>::rates, at.time_s, y_.get());
    CVodeSVtolerances(cv, tolerance_ * 1e-3, absolute_.get());
    CVodeSetUserData(cv, &problem);
    CVodeSetMaxNumSteps(cv, most_steps);
    CVodeRootInit(cv, static_cast<int>(fired.size()), Problem<Phase>::roots);
    const std::vector<int> falling(fired.size(), -1);
    CVodeSetRootDirection(cv, const_cast<int*>(falling.data()));
    CVodeSetNoInactiveRootWarn(cv);
    CVodeSetStopTime(cv, until_s);
    if (adams)
      CVodeSetNonlinearSolver(cv, fixed_point_.get());
    else
      CVodeSetLinearSolver(cv, linear_.get(), matrix_.get());
    const int status = CVode(cv, until_s, y_.get(), &at.time_s, CV_NORMAL);
    if (status == CV_ROOT_RETURN) CVodeGetRootInfo(cv, fired.data());
    long steps = 0;
    CVodeGetNumSteps(cv, &steps);
    work_.steps += steps;
    return status;
  }

  template <class Phase, class Fired>
  int by_arkode(Problem<Phase>& problem, Instant& at, double until_s, Fired& fired) {
    const auto close = [](void* memory) { ERKStepFree(&memory); };
    std::unique_ptr<void, decltype(close)> memory(
        ERKStepCreate(Problem<Phase>::rates, at.time_s, y_.get(), context_.get()), close);
    void* erk = memory.get();
    ERKStepSetOrder(erk, solver_ == SundialsSolver::erk5 ? 5 : 8);
    ERKStepSVtolerances(erk, tolerance_ * 1e-3, absolute_.get());
    ERKStepSetUserData(erk, &problem);
    ERKStepSetMaxNumSteps(erk, most_steps);
    ERKStepRootInit(erk, static_cast<int>(fired.size()), Problem<Phase>::roots);
    const std::vector<int> falling(fired.size(), -1);
    ERKStepSetRootDirection(erk, const_cast<int*>(falling.data()));
    ERKStepSetNoInactiveRootWarn(erk);
    ERKStepSetStopTime(erk, until_s);
    const int status = ERKStepEvolve(erk, until_s, y_.get(), &at.time_s, ARK_NORMAL);
    if (status == ARK_ROOT_RETURN) ERKStepGetRootInfo(erk, fired.data());
    long steps = 0;
    ERKStepGetNumSteps(erk, &steps);
    work_.steps += steps;
    return status;
  }

  static constexpr long most_steps = 1'000'000;

  SundialsSolver solver_;
  double tolerance_;
  Observer& observer_;
  Work& work_;
  Surroundings<double> around_;
  int direction_ = 0;
  std::shared_ptr<std::remove_pointer_t<SUNContext>> context_;
  Handle<N_Vector, decltype(&N_VDestroy)> y_, absolute_;
  Handle<SUNMatrix, decltype(&SUNMatDestroy)> matrix_;
  Handle<SUNLinearSolver, decltype(&SUNLinSolFree)> linear_;
  Handle<SUNNonlinearSolver, decltype(&SUNNonlinSolFree)> fixed_point_;
};

}  // namespace rotor
