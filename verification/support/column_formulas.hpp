/// What the columns of traces and figures must contain, written independently: from the numbers of
/// an instant and a scenario, without the model's mechanics, so that no mistake can be in both.
#pragma once

#include <string_view>

#include "model/scenario/instant.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// The value of a column at an instant. Throws std::out_of_range for a column that is not known
/// here.
double column_by_formula(std::string_view column, const Instant& at, const Scenario& scenario);

}  // namespace rotor
