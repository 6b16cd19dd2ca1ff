/// The closed forms of model/theory/accident.hpp for a scenario.
#pragma once

#include "figures/results/json.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// Keys have units; null: does not happen. Speeds and forces of rolling are those of a rotor that
/// rolls, whatever the outcome. The speed at the loss is that of a motor without resistance. Throws
/// InputError for a run without mass loss, and std::domain_error for supports that do not vibrate.
Json laws(const Scenario& scenario);

}  // namespace rotor
