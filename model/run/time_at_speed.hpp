/// When a rotor that runs up reaches a speed.
#pragma once

#include <optional>

#include "model/run/simulation.hpp"

namespace rotor {

struct SpeedReached {
  std::optional<double> time_s;  ///< the first time, if it is reached clear of the ring
  double looked_until_s;         ///< how long was looked for it
  double greatest_Hz;            ///< the greatest speed until then, if it is not reached
  bool touches;                  ///< whether the rotor touches the ring then
};

/// The run-up that is searched for a speed: by the event method, without mass loss.
Scenario run_up_to_speed(const Scenario& scenario);

/// Until a time, or twice as long as the motor would take without any resistance. `from` is a run
/// of that run-up on its way there; the answer does not depend on how far it has got. The monitor
/// is asked after every step whether to go on; a search that it ends has found nothing.
SpeedReached time_at_speed(const Simulation& from, const Scenario& scenario, double speed_Hz,
                           std::optional<double> until_s, Observer& monitor);

}  // namespace rotor
