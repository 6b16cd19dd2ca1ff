/// What a packaged solver with root-finding is given to compete with the event-located method: the
/// same phases, guards and resets, either in the paper's coordinates or in those of phases.hpp.
#pragma once

#include <memory>
#include <optional>

#include "model/phases.hpp"
#include "model/simulation.hpp"

namespace rotor {

/// A phase of the motion as a solver sees it. It ends where one of the guards becomes negative.
class PeerProblem {
 public:
  using Unknowns = std::array<double, 6>;
  static constexpr std::size_t guard_count = 3;

  virtual ~PeerProblem() = default;
  virtual void rates(const Unknowns& x, Unknowns& rates) const = 0;
  virtual std::array<double, guard_count> guards(const Unknowns& x) const = 0;
  virtual Guard guard_name(std::size_t i) const = 0;
  virtual Unknowns unknowns(const State<double>& q) const = 0;
  virtual State<double> state(const Unknowns& x) const = 0;
  virtual Unknowns scale(const Unknowns& x) const = 0;  ///< that errors are measured by
};

/// A phase in its own coordinates.
template <class Phase>
class PhaseProblem : public PeerProblem {
 public:
  explicit PhaseProblem(const Phase& phase) : phase_(phase) {}

  void rates(const Unknowns& x, Unknowns& rates) const override { phase_(x, rates, 0); }
  std::array<double, guard_count> guards(const Unknowns& x) const override {
    std::array<double, guard_count> all{1, 1, 1};
    std::ranges::copy(phase_.guards(x), all.begin());
    return all;
  }
  Guard guard_name(std::size_t i) const override { return Phase::guard_names[i]; }
  Unknowns unknowns(const State<double>& q) const override { return phase_.unknowns(q); }
  State<double> state(const Unknowns& x) const override { return phase_.state(x); }
  Unknowns scale(const Unknowns& x) const override { return phase_.scale(x); }

 private:
  Phase phase_;
};

/// A phase in the paper's coordinates, the axes that turn with the rotor.
class PaperProblem : public PeerProblem {
 public:
  /// `direction` is the sign of the slip velocity while the rim slides.
  PaperProblem(const Surroundings<double>& around, ContactState contact, int direction)
      : around_(around), contact_(contact), direction_(direction) {}

  void rates(const Unknowns& x, Unknowns& rates) const override {
    const auto motion = RotatingFrame<double>::motion(around_.body, x);
    auto loads = around_.supports.loads(around_.body, motion, around_.motor_on);
    if (in_contact()) {
      const auto k = around_.ring.rim_point(motion);
      loads += around_.ring.loads(k, {around_.ring.elastic_force(k), friction(motion, k)});
    }
    rates = RotatingFrame<double>::rates(motion, x, acceleration(around_.body, motion, loads));
  }

  std::array<double, guard_count> guards(const Unknowns& x) const override {
    const Ring<double>& ring = around_.ring;
    const auto motion = RotatingFrame<double>::motion(around_.body, x);
    const double motor = around_.motor_guard(x[5]);
    if (contact_ == ContactState::free)
      return {ring.clearance * ring.clearance - motion.displacement.squaredNorm(), motor, 1};
    const auto k = ring.rim_point(motion);
    const double normal = ring.elastic_force(k);
    if (contact_ == ContactState::indented) return {k.indentation, normal, motor};
    if (contact_ == ContactState::sliding) return {-normal, direction_ * k.slip_velocity, motor};
    const double limit = ring.friction * normal, f = friction(motion, k);
    return {-normal, limit * limit - f * f, motor};
  }

  Guard guard_name(std::size_t i) const override {
    using enum Guard;
    constexpr std::array<std::array<Guard, guard_count>, 4> names = {
        {{touch_down, motor, motor},
         {release, slip_ends, motor},
         {release, break_away, motor},
         {ring_clear, renewed_contact, motor}}};  // in the order of ContactState
    return names[static_cast<std::size_t>(contact_)][i];
  }

  Unknowns unknowns(const State<double>& q) const override { return q; }
  State<double> state(const Unknowns& x) const override { return x; }

  Unknowns scale(const Unknowns& x) const override {
    const double length = around_.ring.clearance / (contact_ == ContactState::rolling ? 1 : 100);
    const double w = in_contact() ? Rub<double>::frequency(around_, x[5])
                                  : Flight<double>::frequency(around_, x[5]);
    return {length, length, 1, length * w, length * w, w / 10};
  }

 private:
  bool in_contact() const {
    return contact_ == ContactState::sliding || contact_ == ContactState::rolling;
  }

  double friction(const Motion<double>& motion, const RimPoint<double>& k) const {
    const Ring<double>& ring = around_.ring;
    const double normal = ring.elastic_force(k);
    if (contact_ == ContactState::sliding) return ring.sliding_friction(normal, direction_);
    return friction_without_slip(around_.body, ring, motion, k,
                                 around_.supports.loads(around_.body, motion, around_.motor_on),
                                 normal);
  }

  const Surroundings<double>& around_;
  ContactState contact_;
  int direction_;
};

/// A packaged solver.
class PeerSolver {
 public:
  virtual ~PeerSolver() = default;
  /// Goes on from x at `time_s` to `until_s`, or to where the first guard becomes negative, which
  /// it returns. Throws std::runtime_error if it gives up.
  virtual std::optional<std::size_t> integrate(const PeerProblem& problem, PeerProblem::Unknowns& x,
                                               double& time_s, double until_s, Work& work) = 0;
};

enum class PeerCoordinates { of_the_paper, of_the_phases };

/// A run by a packaged solver.
class PeerMethod {
 public:
  PeerMethod(const Scenario& scenario, PeerCoordinates coordinates, PeerSolver& solver,
             Observer& observer, Work& work)
      : coordinates_(coordinates),
        solver_(solver),
        observer_(observer),
        work_(work),
        around_(Surroundings<double>::of(scenario)) {}

  Instant rub(Instant at, double until_s) {
    around_.body = at.body;
    around_.motor_on = at.motor_on;
    while (at.time_s < until_s) {
      const auto problem = this->problem(at);
      auto x = problem->unknowns(at.state);
      const auto fired = solver_.integrate(*problem, x, at.time_s, until_s, work_);
      at.state = problem->state(x);
      if (!fired) break;
      ++work_.located_events;
      const Guard guard = problem->guard_name(*fired);
      if (guard == Guard::motor) {
        around_.motor_on = at.motor_on = false;
      } else {
        const Begin begin = follow(guard, around_, at.state);
        at.contact = begin.contact;
        direction_ = begin.direction;
      }
      observer_.see(at);
    }
    observer_.see(at);
    return at;
  }

 private:
  template <class Phase>
  static std::unique_ptr<PeerProblem> in_phase(const Phase& phase) {
    return std::make_unique<PhaseProblem<Phase>>(phase);
  }

  std::unique_ptr<PeerProblem> problem(const Instant& at) const {
    if (coordinates_ == PeerCoordinates::of_the_paper)
      return std::make_unique<PaperProblem>(around_, at.contact, direction_);
    switch (at.contact) {
      case ContactState::free:
        return in_phase(FreeFlight<double>(around_, at.state));
      case ContactState::indented:
        return in_phase(IndentedFlight<double>(around_, at.state));
      case ContactState::sliding:
        return in_phase(Sliding<double>(around_, at.state, direction_, false));
      case ContactState::rolling:
        return in_phase(Rolling<double>(around_, at.state));
    }
    return nullptr;
  }

  PeerCoordinates coordinates_;
  PeerSolver& solver_;
  Observer& observer_;
  Work& work_;
  Surroundings<double> around_;
  int direction_ = 0;
};

}  // namespace rotor
