/// What happens between two phases of the motion.
#pragma once

#include "model/mechanics/contact.hpp"

namespace rotor {

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

/// The event that ends a phase, and the phase that follows it.
struct Transition {
  Event event;
  ContactState contact;
  int direction = 0;  ///< sign of the slip velocity, if the rim slides then
};

}  // namespace rotor
