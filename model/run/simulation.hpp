/// A whole run: run-up, mass loss, rub. As long as the rotor stays clear of the ring, the run-up
/// does not depend on friction, contact stiffness and damping, or the mass loss: runs that differ
/// only in these can share it.
#pragma once

#include <memory>

#include "model/scenario/observer.hpp"

namespace rotor {

/// A run by the scenario's method, up to its present instant. A copy continues independently, so
/// that runs which differ only later share their beginning. Throws std::runtime_error, with time
/// and reason, if the run cannot continue.
class Simulation {
 public:
  explicit Simulation(const Scenario& scenario);
  Simulation(const Scenario& scenario, const Instant& from);
  Simulation(const Simulation& other);
  Simulation(Simulation&& other) noexcept;
  Simulation& operator=(Simulation other) noexcept {
    state_.swap(other.state_);
    return *this;
  }
  ~Simulation();

  /// Takes whole steps of the method that end by `until_s`, as long as the rotor stays clear of the
  /// ring.
  void run_up(double until_s, Observer& observer);

  /// Runs to the end of the scenario.
  void run_to_end(Observer& observer);

  /// The same run continued by another scenario, which must not have differed so far.
  Simulation branch(const Scenario& scenario) const;

  const Instant& instant() const;
  const Counters& counters() const;
  bool stopped() const;  ///< by an observer

 private:
  struct State;  // keeps the steppers out of this header
  std::unique_ptr<State> state_;
};

/// How a run has ended.
template <class S>
struct BasicRunEnd {
  BasicInstant<S> last;
  Counters counters;
  bool stopped = false;  ///< by the observer
};

using RunEnd = BasicRunEnd<double>;

/// A run from where the scenario starts, or from an instant, to the end of the scenario. The
/// observer is shown the start first. Throws as Simulation and start_of() do.
RunEnd run(const Scenario& scenario, Observer& observer);
RunEnd run(const Scenario& scenario, const Instant& from, Observer& observer);

}  // namespace rotor
