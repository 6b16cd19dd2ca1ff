/// The rotor at one instant of a run.
#pragma once

#include "model/mechanics/rotating_frame.hpp"
#include "model/phases/rotor_system.hpp"
#include "model/phases/transition.hpp"

namespace rotor {

/// What a method continues from, and what an observer is shown.
template <class S>
struct BasicInstant {
  S time_s{0};
  State<S> state{};  // at rest, in static equilibrium
  Body<S> body{};
  bool motor_on = true;
  bool mass_lost = false;  ///< whether the mass has been lost
  ContactState contact = ContactState::free;
  int direction = 0;          ///< sign of the slip velocity while the rim slides; 0 by fixed steps
  Event event = Event::none;  ///< what has just happened

  Motion<S> motion() const { return RotatingFrame<S>::motion(body, state); }

  /// Whether the rim is pressed against the ring.
  bool touches() const {
    return contact == ContactState::sliding || contact == ContactState::rolling;
  }
};

using Instant = BasicInstant<double>;

/// A speed in rad/s as turns per second.
template <class S>
S in_Hz(const S& speed) {
  return speed / RotorSystem<S>::radians_per_turn();
}

/// At rest at t = 0, where a run starts unless it states a speed.
template <class S = double>
BasicInstant<S> at_rest(const Parameters& p) {
  return {.body = Body<S>::of(p)};
}

}  // namespace rotor
