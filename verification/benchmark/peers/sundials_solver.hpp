/// SUNDIALS as a peer: CVODE (Adams with fixed-point iteration, BDF with Newton and a dense matrix)
/// and ARKODE's explicit Runge-Kutta of orders 5 and 8, with their own root-finding. Memory is made
/// once and initialised anew for every phase.
#pragma once

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <stdexcept>

#include "verification/benchmark/peers/peer.hpp"

namespace rotor {

class SundialsSolver : public PeerSolver {
 public:
  enum class Kind { adams, bdf, erk5, erk8 };

  SundialsSolver(Kind kind, double tolerance)
      : kind_(kind),
        tolerance_(tolerance),
        context_(make_context()),
        y_(N_VNew_Serial(6, context_.get()), N_VDestroy),
        absolute_(N_VNew_Serial(6, context_.get()), N_VDestroy),
        matrix_(SUNDenseMatrix(6, 6, context_.get()), SUNMatDestroy),
        linear_(SUNLinSol_Dense(y_.get(), matrix_.get(), context_.get()), SUNLinSolFree),
        fixed_point_(SUNNonlinSol_FixedPoint(y_.get(), 0, context_.get()), SUNNonlinSolFree),
        memory_(is_cvode() ? CVodeCreate(kind == Kind::adams ? CV_ADAMS : CV_BDF, context_.get())
                           : ERKStepCreate(rates, 0, y_.get(), context_.get()),
                is_cvode() ? free_cvode : free_erk) {
    void* const memory = memory_.get();
    constexpr int guards = PeerProblem::guard_count;
    int falling[guards] = {-1, -1, -1};
    if (is_cvode()) {
      CVodeInit(memory, rates, 0, y_.get());
      CVodeSetMaxNumSteps(memory, most_steps);
      CVodeRootInit(memory, guards, roots);
      CVodeSetRootDirection(memory, falling);
      CVodeSetNoInactiveRootWarn(memory);
      if (kind_ == Kind::adams)
        CVodeSetNonlinearSolver(memory, fixed_point_.get());
      else
        CVodeSetLinearSolver(memory, linear_.get(), matrix_.get());
    } else {
      ERKStepSetOrder(memory, kind_ == Kind::erk5 ? 5 : 8);
      ERKStepSetMaxNumSteps(memory, most_steps);
      ERKStepRootInit(memory, guards, roots);
      ERKStepSetRootDirection(memory, falling);
      ERKStepSetNoInactiveRootWarn(memory);
    }
  }

  std::optional<std::size_t> integrate(const PeerProblem& problem, PeerProblem::Unknowns& x,
                                       double& time_s, double until_s,
                                       Counters& counters) override {
    Task task{problem, counters};
    unknowns(y_.get()) = x;
    unknowns(absolute_.get()) = problem.scale(x);
    for (double& size : unknowns(absolute_.get())) size *= tolerance_;
    int fired[PeerProblem::guard_count] = {};
    const int status =
        is_cvode() ? by_cvode(task, time_s, until_s, fired) : by_erk(task, time_s, until_s, fired);
    if (status < 0) throw std::runtime_error("SUNDIALS gave up");
    x = unknowns(y_.get());
    for (std::size_t i = 0; i < std::size(fired); ++i)
      if (fired[i] != 0) return i;
    return std::nullopt;
  }

 private:
  template <class T, class Free>
  using Handle = std::unique_ptr<std::remove_pointer_t<T>, Free>;

  /// What SUNDIALS hands back to its callbacks.
  struct Task {
    const PeerProblem& problem;
    Counters& counters;
  };

  static std::shared_ptr<std::remove_pointer_t<SUNContext>> make_context() {
    SUNContext context = nullptr;
    if (SUNContext_Create(nullptr, &context) != 0) throw std::runtime_error("SUNDIALS: no context");
    return {context, [](SUNContext c) { SUNContext_Free(&c); }};
  }
  static void free_cvode(void* memory) { CVodeFree(&memory); }
  static void free_erk(void* memory) { ERKStepFree(&memory); }

  static PeerProblem::Unknowns& unknowns(N_Vector y) {
    return *reinterpret_cast<PeerProblem::Unknowns*>(N_VGetArrayPointer(y));
  }
  static int rates(realtype, N_Vector y, N_Vector ydot, void* task) {
    ++static_cast<Task*>(task)->counters.right_hand_sides;
    static_cast<Task*>(task)->problem.rates(unknowns(y), unknowns(ydot));
    return 0;
  }
  static int roots(realtype, N_Vector y, realtype* g, void* task) {
    std::ranges::copy(static_cast<Task*>(task)->problem.guards(unknowns(y)), g);
    return 0;
  }

  bool is_cvode() const { return kind_ == Kind::adams || kind_ == Kind::bdf; }

  int by_cvode(Task& task, double& time_s, double until_s, int* fired) {
    void* const memory = memory_.get();
    CVodeReInit(memory, time_s, y_.get());
    CVodeSVtolerances(memory, tolerance_ * relative, absolute_.get());
    CVodeSetUserData(memory, &task);
    CVodeSetStopTime(memory, until_s);
    const int status = CVode(memory, until_s, y_.get(), &time_s, CV_NORMAL);
    if (status == CV_ROOT_RETURN) CVodeGetRootInfo(memory, fired);
    long steps = 0;
    CVodeGetNumSteps(memory, &steps);
    task.counters.steps += steps;
    return status;
  }

  int by_erk(Task& task, double& time_s, double until_s, int* fired) {
    void* const memory = memory_.get();
    ERKStepReInit(memory, rates, time_s, y_.get());
    ERKStepSVtolerances(memory, tolerance_ * relative, absolute_.get());
    ERKStepSetUserData(memory, &task);
    ERKStepSetStopTime(memory, until_s);
    const int status = ERKStepEvolve(memory, until_s, y_.get(), &time_s, ARK_NORMAL);
    if (status == ARK_ROOT_RETURN) ERKStepGetRootInfo(memory, fired);
    long steps = 0;
    ERKStepGetNumSteps(memory, &steps);
    task.counters.steps += steps;
    return status;
  }

  static constexpr long most_steps = 1'000'000;
  static constexpr double relative = 1e-3;  ///< tolerance; the absolute one is what counts

  Kind kind_;
  double tolerance_;
  std::shared_ptr<std::remove_pointer_t<SUNContext>> context_;
  Handle<N_Vector, decltype(&N_VDestroy)> y_, absolute_;
  Handle<SUNMatrix, decltype(&SUNMatDestroy)> matrix_;
  Handle<SUNLinearSolver, decltype(&SUNLinSolFree)> linear_;
  Handle<SUNNonlinearSolver, decltype(&SUNNonlinSolFree)> fixed_point_;
  std::unique_ptr<void, void (*)(void*)> memory_;
};

}  // namespace rotor
