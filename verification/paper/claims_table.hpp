/// The claims of the paper's text as a table to print.
#pragma once

#include "verification/paper/claims.hpp"

namespace rotor {

/// Figure by figure, then section by section; the numbers of a claim below it, the readings of a
/// number below that; last, what came out, and the figures about which nothing is claimed.
std::string claims_table(const std::vector<Number>& numbers);

/// Of those that have a scene.
std::vector<int> figures_without_claim(const std::vector<Number>& numbers);

}  // namespace rotor
