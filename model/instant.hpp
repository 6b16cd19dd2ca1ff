/// The rotor at one instant of a run: what a method hands on and what an observer gets to see.
#pragma once

#include <functional>

#include "model/contact.hpp"
#include "model/rotating_frame.hpp"

namespace rotor {

struct Instant {
  double time_s = 0;
  State<double> state{};  // at rest, in static equilibrium
  Body<double> body{};
  bool motor_on = true;
  bool separated = false;
  ContactState contact = ContactState::free;

  Motion<double> motion() const { return RotatingFrame<double>::motion(body, state); }
};

/// Sees the instants of a run in order. Where something jumps, it sees both sides.
using Observer = std::function<void(const Instant&)>;

}  // namespace rotor
