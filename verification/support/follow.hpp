/// Runs that begin at any instant, and instants to begin at.
#pragma once

#include "model/run/simulation.hpp"
#include "verification/support/observers.hpp"

namespace rotor {

/// From an instant to a time by the event method, without run-up and mass loss. The observer is
/// shown both ends.
RunEnd follow(const Scenario& scenario, const Instant& from, double until_s, Observer& observer);

/// Just after a mass loss at a speed in rad/s that no run-up has led to: self-centred before the
/// loss as far as the clearance lets it.
Instant mass_lost_at_speed(const Scenario& scenario, double speed);

/// Pressed against the ring by a whirl against the rotation that the centrifugal force of the mass
/// alone holds there, so that it rolls at a speed in rad/s, or slides by a slip in m/s.
Instant pressed_by_whirl(const Scenario& scenario, double speed, double slip);

}  // namespace rotor
