/// What a run reports of its phases: the events between them, and the maxima within them. Observers
/// and results need only this, not the integrator.
#pragma once

#include <cstddef>

namespace rotor {

/// What happens between two phases.
enum class Event {
  none,
  touch_down,       ///< the rim meets the ring
  release,          ///< F_n = 0; a damped ring is still indented
  ring_clear,       ///< the ring has sprung back, the rotor is clear of it
  renewed_contact,  ///< the rim meets the ring again before it is clear
  rolling_onset,    ///< the slip ends, and friction can hold the rim
  slip_reversal,    ///< the slip ends, and friction cannot hold the rim
  break_away,       ///< friction can no longer hold the rim
  motor_off,
  mass_loss,
};

/// The quantities whose maxima a run can locate.
enum class Extreme { displacement, bearing_force, normal_force };
constexpr std::size_t extreme_count = 3;

}  // namespace rotor
