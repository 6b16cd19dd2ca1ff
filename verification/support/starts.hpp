/// Where tests begin: just after a mass loss.
#pragma once

#include "model/simulation/instant.hpp"
#include "model/simulation/scenario.hpp"

namespace rotor {

/// As the scenario's own run-up leads to it.
Instant after_mass_loss(const Scenario& scenario);

/// At a speed in rad/s that no run-up has led to: self-centred before the loss as far as the
/// clearance lets it.
Instant separated_at_speed(const Scenario& scenario, double speed);

}  // namespace rotor
