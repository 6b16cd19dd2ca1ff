/// Run-ups that are shared by runs if only the summary, or a late part, is observed.
#pragma once

#include <chrono>
#include <limits>
#include <list>
#include <optional>
#include <vector>

#include "figures/data/interruption.hpp"
#include "figures/input/scenario_spec.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

/// Ends a run at an interruption, or after a time.
class Interruptible : public Observer {
 public:
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  /// A run-up need not reach its end if the run may stop before that.
  explicit Interruptible(double budget_s = unlimited, std::optional<StopOn> stop_on = {})
      : budget_s_(budget_s), may_stop_early_(stop_on && !awaits_mass_loss(*stop_on)) {}

  double budget_s() const { return budget_s_; }
  bool has_time() const {
    const std::chrono::duration<double> budget(budget_s_);
    return budget_s_ == unlimited || std::chrono::steady_clock::now() - start_ < budget;
  }
  bool may_continue() const { return !is_interrupted() && has_time(); }
  bool should_continue(const Progress& /*now*/) override { return may_continue(); }
  bool may_stop_early() const override { return may_stop_early_; }

 private:
  double budget_s_;
  bool may_stop_early_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A run and its summary up to the present instant.
struct RunUpCheckpoint {
  Simulation simulation;
  SummaryObserver summary;

  /// At the start.
  explicit RunUpCheckpoint(const Scenario& scenario) : simulation(scenario), summary(scenario) {
    summary.on_instant(simulation.instant());
  }
};

struct SpeedReached {
  std::optional<double> time_s;  ///< the first time, if it is reached clear of the ring
  double looked_until_s;         ///< end of that run
  double greatest_Hz;            ///< the greatest speed until then, if it is not reached
  bool touches;                  ///< whether the rotor touches the ring then
};

/// Keeps checkpoints of the most recent run-ups. The memory does not depend on the number of runs.
class RunUps {
 public:
  /// A run before its mass loss and before `latest_s`, clear of the ring, in the same state to the
  /// bit as without sharing; a run without mass loss is at its start. Throws as `run` does. If the
  /// monitor stops the run-up, the checkpoint must not be used.
  RunUpCheckpoint checkpoint_before(const Scenario& scenario, Observer& monitor,
                                    double latest_s = std::numeric_limits<double>::infinity());

  /// When the rotor first has a speed, by the event method, without mass loss: looked for until a
  /// time, or for twice as long as the motor would take without any resistance. The monitor can end
  /// the search; then nothing is found.
  SpeedReached time_at_speed(const Scenario& scenario, double speed_Hz,
                             std::optional<double> until_s, Observer& monitor);

 private:
  struct Family {
    Scenario run_up;
    std::vector<RunUpCheckpoint> checkpoints;  ///< in the order of their times
  };
  Family& family(const Scenario& scenario);
  RunUpCheckpoint follow(std::vector<RunUpCheckpoint>& checkpoints, double until_s,
                         Observer& monitor);

  std::list<Family> families_;   ///< the most recently used first
  std::size_t checkpoints_ = 0;  ///< of all
};

/// The scenario of what is stated. A mass loss at a stated speed is at the time at which the run-up
/// first has that speed. Throws ScenarioError as stated_scenario() does, and if the speed is not
/// reached; Interrupted.
Scenario scenario_of(const ScenarioSpec& spec, RunUps& run_ups);
Scenario scenario_of(const ScenarioSpec& spec);

}  // namespace rotor
