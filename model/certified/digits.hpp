/// A run to a number of significant digits, which the program itself makes sure of. The inputs are
/// the decimals that were stated; the truth is what exact arithmetic would make of them.
#pragma once

#include <limits>

#include "model/certified/comparison.hpp"

namespace rotor {

/// That a double holds.
constexpr int most_digits = std::numeric_limits<double>::digits10;

/// How many significant digits of a value are sure.
int sure_digits(const NamedEstimate& value);

/// Whether a number of digits has been had: each value has them, and the course is sure.
bool has_digits(const Comparison& comparison, int digits);

/// The cheapest comparison that has so many digits: in double precision first, then by what its
/// errors require. If none has them, the best. Empty if not even one could be finished.
std::optional<Comparison> run_to_digits(const Scenario& scenario, int digits,
                                        const GoesOn& goes_on);

}  // namespace rotor
