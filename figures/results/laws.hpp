/// What the closed forms of model/theory/accident.hpp say of a scenario.
#pragma once

#include <nlohmann/json.hpp>

#include "model/scenario/scenario.hpp"

namespace rotor {

/// By names with units; null for what does not happen. The speed at the loss is the motor's torque
/// times time over inertia. Throws InputError for a run without mass loss, and std::domain_error
/// for supports that do not vibrate.
nlohmann::ordered_json laws(const Scenario& scenario);

}  // namespace rotor
