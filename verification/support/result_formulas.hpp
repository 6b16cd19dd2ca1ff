/// What the results of a run must be, written independently: from the motion that a run shows, by
/// the definitions of the results, without the model's summary, outcome and touch-downs.
#pragma once

#include <string>

#include "model/scenario/scenario.hpp"

namespace rotor {

/// The results of a scenario's run that are not what its motion gives; empty if all are.
std::string wrong_results(const Scenario& scenario);

}  // namespace rotor
