/// A whole run: run-up, mass loss, rub. The run-up knows nothing of friction, contact and mass loss
/// as long as the rotor stays clear of the ring, so that runs which differ only in those can share
/// it.
#pragma once

#include <memory>
#include <span>

#include "model/scenario/counters.hpp"
#include "model/scenario/observer.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// An end of a run, and who watches it until there.
struct RunEnding {
  double until_s;
  Observer& observer;
};

/// A run by the scenario's method, as far as it has got. It can be copied on its way, so that runs
/// which differ only later share the way there. All throw std::runtime_error, saying when and why,
/// if the run cannot go on.
class Simulation {
 public:
  explicit Simulation(const Scenario& scenario);
  Simulation(const Scenario& scenario, const Instant& from);
  Simulation(const Simulation& other);
  Simulation(Simulation&& other) noexcept;
  Simulation& operator=(const Simulation& other);
  ~Simulation();

  /// By whole steps of the method, for as long as they end before `until_s` and the rotor stays
  /// clear of the ring.
  void run_up(double until_s, Observer& observer);

  /// To the end of the scenario.
  void finish(Observer& observer);

  /// To several ends after the mass loss, in the order of their times. Each observer is shown what
  /// it would be shown by a run to its end alone. Returns what all of it has cost.
  Counters finish(std::span<const RunEnding> endings);

  /// The same run on its way to what another scenario states, which has not differed so far.
  Simulation with(const Scenario& scenario) const;

  const Instant& instant() const;
  const Counters& counters() const;
  bool stopped() const;  ///< by an observer

 private:
  struct State;  // which drags the steppers in
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

/// A run from rest at t = 0, or from an instant, which the observer is shown first, to the end of
/// the scenario. Throws as Simulation does.
RunEnd run(const Scenario& scenario, Observer& observer);
RunEnd run(const Scenario& scenario, const Instant& from, Observer& observer);

}  // namespace rotor
