/// What a run has cost.
#pragma once

namespace rotor {

struct Counters {
  long steps = 0;             ///< accepted ones
  long right_hand_sides = 0;  ///< in all steps, accepted or not
  /// Evaluations of all loads in contact, Eqs. (15)-(25), in right-hand sides and in guards.
  long contact_evaluations = 0;
  long located_events = 0;
};

}  // namespace rotor
