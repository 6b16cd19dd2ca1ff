/// Runs that tests begin wherever they like.
#pragma once

#include "model/run/simulation.hpp"
#include "verification/support/observers.hpp"

namespace rotor {

/// From an instant to a time by the event method, without run-up and mass loss. The observer is
/// shown both ends.
RunEnd follow(const Scenario& scenario, const Instant& from, double until_s, Observer& observer);

}  // namespace rotor
