/// Runs of only a rotor and a ring, for comparison with closed forms.
#pragma once

#include "verification/support/follow.hpp"

namespace rotor {

/// A scenario with only a rotor and a ring: no supports, gravity, motor, unbalance, friction or
/// damping.
inline Scenario bare() {
  Scenario scenario{.tolerance = 1e-13};
  Parameters& p = scenario.parameters;
  p.support_stiffness = p.support_damping = p.gravity = p.torque = p.eccentricity = 0;
  p.friction = p.contact_damping = 0;
  return scenario;
}

/// The run that starts from a state clear of the ring.
inline EventRecorder follow_from_state(const Scenario& scenario, const State<double>& state,
                                       double duration_s, bool motor_on = false) {
  Instant at = at_rest(scenario.parameters);
  at.state = state;
  at.motor_on = motor_on;
  EventRecorder events;
  follow(scenario, at, duration_s, events);
  return events;
}

}  // namespace rotor
