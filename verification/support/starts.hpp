/// Where tests begin: just after a mass loss, or pressed against the ring.
#pragma once

#include "model/scenario/instant.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// As the scenario's own run-up leads to it.
Instant after_mass_loss(const Scenario& scenario);

/// At a speed in rad/s that no run-up has led to: self-centred before the loss as far as the
/// clearance lets it.
Instant mass_lost_at_speed(const Scenario& scenario, double speed);

/// Pressed against the ring by a whirl against the rotation that the centrifugal force of the mass
/// alone holds there, so that it rolls at a speed in rad/s, or slides by a slip in m/s.
Instant pressed_by_whirl(const Scenario& scenario, double speed, double slip);

}  // namespace rotor
