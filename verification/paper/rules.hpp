/// What a number as printed allows, by the rules of reference-data/policy.md.
#pragma once

#include <cmath>
#include <string>

namespace rotor {

struct Allowed {
  double middle, half;  ///< half of the width

  double least() const { return middle - half; }
  double greatest() const { return middle + half; }
  bool holds(double value) const { return off(value) <= 1; }
  /// How far a value lies from the middle, in halves of the width.
  double off(double value) const { return std::abs(value - middle) / half; }
};

/// With the widths that words have multiplied. Throws std::invalid_argument for a rule that does
/// not exist, or a number that is none.
Allowed allowed(const std::string& printed, const std::string& rule, double words = 1);

/// Half a unit of the last digit of a number as printed.
double half_digit(const std::string& printed);

}  // namespace rotor
