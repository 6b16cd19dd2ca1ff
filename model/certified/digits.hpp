/// A run to a guaranteed number of significant digits, compared with exact arithmetic for the
/// decimals that were stated.
#pragma once

#include <limits>

#include "model/certified/comparison.hpp"

namespace rotor {

/// Decimal digits that a double can hold.
constexpr int most_digits = std::numeric_limits<double>::digits10;

/// How many significant digits of a value are certain.
int sure_digits(const NamedEstimate& value);

/// Whether the digits are reached: every value has them, and the course is certain.
bool has_digits(const Comparison& comparison, int digits);

/// The cheapest comparison that reaches so many digits: the first is in double precision, and its
/// errors determine the next. If none reaches them, the last one. Empty if none was finished.
std::optional<Comparison> run_to_digits(const Scenario& scenario, int digits,
                                        const GoesOn& goes_on);

}  // namespace rotor
