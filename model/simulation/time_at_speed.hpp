/// When a rotor that runs up reaches a speed.
#pragma once

#include <optional>

#include "model/simulation/observer.hpp"
#include "model/simulation/scenario.hpp"

namespace rotor {

struct SpeedReached {
  std::optional<double> time_s;  ///< the first time, if it is reached clear of the ring
  double looked_until_s;         ///< how long was looked for it
  double greatest_Hz;            ///< the greatest speed until then, if it is not reached
};

/// Without mass loss; until a time, or twice as long as the motor would take without any
/// resistance. The monitor is asked after every step whether to go on.
SpeedReached time_at_speed(Scenario scenario, double speed_Hz, std::optional<double> until_s,
                           Observer& monitor);

}  // namespace rotor
