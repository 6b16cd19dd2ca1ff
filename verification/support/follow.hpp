/// Runs that start at any instant, and instants to start from.
#pragma once

#include "model/run/simulation.hpp"
#include "verification/support/observers.hpp"

namespace rotor {

/// From an instant to a time by the event method, without run-up and mass loss. The observer is
/// shown both ends.
RunEnd follow(const Scenario& scenario, const Instant& from, double until_s, Observer& observer);

/// Just after a mass loss at a speed in rad/s, without a run-up: self-centred before the loss, as
/// far as the clearance allows.
Instant mass_lost_at_speed(const Scenario& scenario, double speed);

/// Pressed against the ring by the centrifugal force of a backward whirl; rolls at a speed in
/// rad/s, or slides with a slip in m/s.
Instant pressed_by_whirl(const Scenario& scenario, double speed, double slip);

}  // namespace rotor
