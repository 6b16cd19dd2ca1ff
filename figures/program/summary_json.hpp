/// The summary of a run as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "model/simulation/simulation.hpp"
#include "model/simulation/summary.hpp"

namespace rotor {

/// What has not happened is null.
nlohmann::ordered_json to_json(const Summary& summary, const RunEnd& end, const Scenario& scenario);

}  // namespace rotor
