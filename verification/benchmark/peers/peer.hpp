/// The phases of the event-located method for a packaged solver with root-finding, either in their
/// own coordinates or in the paper's.
#pragma once

#include <memory>
#include <optional>

#include "model/phases/flight.hpp"
#include "model/scenario/counters.hpp"
#include "model/scenario/observer.hpp"
#include "model/scenario/scenario.hpp"
#include "verification/benchmark/peers/paper_chart.hpp"

namespace rotor {

/// A phase of the motion as a solver sees it. It ends where one of the guards becomes negative.
class PeerProblem {
 public:
  using Unknowns = std::array<double, 6>;
  static constexpr std::size_t guard_count = 3;

  virtual ~PeerProblem() = default;
  virtual Unknowns start() const = 0;
  virtual void rates(const Unknowns& x, Unknowns& rates) const = 0;
  virtual std::array<double, guard_count> guards(const Unknowns& x) const = 0;
  virtual Transition next(std::size_t guard, Unknowns& x) const = 0;
  virtual State<double> state(const Unknowns& x) const = 0;
  virtual Unknowns scale(const Unknowns& x) const = 0;  ///< reference of errors
};

template <class Phase, class Chart>
class PhaseProblem : public PeerProblem {
 public:
  template <class... Direction>
  PhaseProblem(const RotorSystem<double>& rotor, const State<double>& q, Direction... direction)
      : chart_(rotor, q), phase_(rotor, chart_, direction...), start_(chart_.unknowns(q)) {}

  Unknowns start() const override { return start_; }
  void rates(const Unknowns& x, Unknowns& rates) const override { phase_(x, rates, 0); }
  std::array<double, guard_count> guards(const Unknowns& x) const override {
    std::array<double, guard_count> all{1, 1, 1};
    for (std::size_t n = 0; n < Phase::event_count; ++n) all[n] = phase_.guard(n, x);
    return all;
  }
  Transition next(std::size_t guard, Unknowns& x) const override { return phase_.next(guard, x); }
  State<double> state(const Unknowns& x) const override { return chart_.state(x); }
  Unknowns scale(const Unknowns& x) const override { return phase_.scale(x); }

 private:
  Chart chart_;
  Phase phase_;
  Unknowns start_;
};

/// A packaged solver.
class PeerSolver {
 public:
  virtual ~PeerSolver() = default;
  /// Integrates from x at `time_s` to `until_s`, or to where the first guard becomes negative;
  /// returns that guard. Throws std::runtime_error if it fails.
  virtual std::optional<std::size_t> integrate(const PeerProblem& problem, PeerProblem::Unknowns& x,
                                               double& time_s, double until_s,
                                               Counters& counters) = 0;
};

enum class PeerCoordinates { of_the_paper, of_the_phases };

/// A run by a packaged solver from an instant on. The observer is shown only events.
class PeerMethod {
 public:
  PeerMethod(const Scenario& scenario, PeerCoordinates coordinates, PeerSolver& solver,
             const Instant& from)
      : coordinates_(coordinates),
        solver_(solver),
        rotor_(scenario.parameters, scenario.equations),
        at_(from) {
    rotor_.body = at_.body;
    rotor_.motor_on = at_.motor_on;
  }

  void advance(double until_s, Observer& observer) {
    while (at_.time_s < until_s) {
      const auto problem = coordinates_ == PeerCoordinates::of_the_paper
                               ? this->problem<PaperChart<double>, PaperChart<double>>()
                               : this->problem<FlightChart<double>, ContactChart<double>>();
      auto x = problem->start();
      const auto guard = solver_.integrate(*problem, x, at_.time_s, until_s, counters_);
      at_.state = problem->state(x);
      if (!guard) break;
      ++counters_.located_events;
      const Transition next = problem->next(*guard, x);
      at_.contact = next.contact;
      direction_ = next.direction;
      if (next.event == Event::motor_off) rotor_.motor_on = at_.motor_on = false;
      observer.on_instant(at_);
    }
  }

  const Instant& instant() const { return at_; }
  const Counters& counters() const { return counters_; }

 private:
  template <class ForFlight, class ForContact>
  std::unique_ptr<PeerProblem> problem() const {
    using S = double;
    const State<S>& q = at_.state;
    switch (at_.contact) {
      case ContactState::free:
        return make<FreeFlight<S, ForFlight>, ForFlight>(rotor_, q);
      case ContactState::indented:
        return make<IndentedFlight<S, ForContact>, ForContact>(rotor_, q);
      case ContactState::sliding:
        return make<Sliding<S, ForContact>, ForContact>(rotor_, q, direction_);
      case ContactState::rolling:
        return make<Rolling<S, ForContact>, ForContact>(rotor_, q);
    }
    return nullptr;
  }

  template <class Phase, class Chart, class... Arguments>
  static std::unique_ptr<PeerProblem> make(const Arguments&... arguments) {
    return std::make_unique<PhaseProblem<Phase, Chart>>(arguments...);
  }

  PeerCoordinates coordinates_;
  PeerSolver& solver_;
  RotorSystem<double> rotor_;
  Instant at_;
  int direction_ = 0;
  Counters counters_;
};

}  // namespace rotor
