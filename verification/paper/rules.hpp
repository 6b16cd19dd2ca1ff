/// What a printed number allows, by the rules of reference-data/policy.md.
#pragma once

#include <cmath>
#include <string>

namespace rotor {

struct Allowed {
  double middle, half;  ///< half of the width
  bool is_open_above = false;

  double least() const { return middle - half; }
  double greatest() const { return is_open_above ? INFINITY : middle + half; }
  bool holds(double value) const { return off(value) <= 1; }
  /// The distance of a value from the middle, relative to half the width; 0 on an open side.
  double off(double value) const {
    return is_open_above && value > middle ? 0 : std::abs(value - middle) / half;
  }
};

/// `zeros_count`: those at the end of a whole number are digits. Throws std::invalid_argument for
/// an unknown rule or an invalid number.
Allowed allowed(const std::string& printed, const std::string& rule, double word_width_factor = 1,
                bool zeros_count = false);

/// Whether a rule bounds a change.
bool bounds_a_change(const std::string& rule);

/// Half a unit of the last digit of a number as printed.
double half_digit(const std::string& printed, bool zeros_count = false);

}  // namespace rotor
