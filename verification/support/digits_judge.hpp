/// Whether the digits of a run are right, compared with a far more accurate computation.
#pragma once

#include <array>
#include <string>

#include "model/digits/digits.hpp"
#include "verification/support/random_runs.hpp"

namespace rotor {

inline constexpr std::array judged_digits = {3, 6, 9, 12};

/// Random runs that take about a second in quadruple precision.
RandomRuns judged_runs(unsigned seed);

/// What was found of a run to so many digits.
struct JudgedDigits {
  char given = '-';       ///< in double (d) or quadruple (q) precision; or not all, or too late (-)
  std::string falsehood;  ///< an error that is too small, or a wrong printed digit; empty if none
};

/// One for each of judged_digits.
std::array<JudgedDigits, judged_digits.size()> judge(const Scenario& scenario);

/// What is false; empty if nothing is.
std::string falsehood(const Comparison& found, int digits, const Comparison& exact);

}  // namespace rotor
