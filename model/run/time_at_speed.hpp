/// When a rotor reaches a speed during its run-up.
#pragma once

#include <optional>

#include "model/run/simulation.hpp"

namespace rotor {

struct SpeedReached {
  std::optional<double> time_s;  ///< the first time, if it is reached clear of the ring
  double looked_until_s;         ///< end of that run
  double greatest_Hz;            ///< the greatest speed until then, if it is not reached
  bool touches;                  ///< whether the rotor touches the ring then
};

/// The run-up to a speed: by the event method, without mass loss.
Scenario run_up_to_speed(const Scenario& scenario);

/// Runs to where the motor's guard finds the speed, until a time, or for twice as long as the motor
/// would take without any resistance. `from` is a run of that run-up before the speed is reached,
/// at any instant: the result does not depend on it. The monitor can end the run after every step;
/// then nothing is found.
SpeedReached time_at_speed(const Simulation& from, const Scenario& scenario, double speed_Hz,
                           std::optional<double> until_s, Observer& monitor);

}  // namespace rotor
