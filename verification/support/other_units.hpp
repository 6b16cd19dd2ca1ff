/// Other units, by powers of two, so that all numbers are scaled without rounding. The units make
/// all forces tiny numbers, so that any comparison with a fixed number would show.
#pragma once

#include <map>

#include "model/scenario/scenario.hpp"

namespace rotor {

constexpr double metre = 4, second = 0x1p-20, kilogram = 0x1p-80;
constexpr double newton = kilogram * metre / (second * second);

/// Throws std::out_of_range for a unit that is not known.
inline Scenario in_other_units(Scenario scenario) {
  static const std::map<std::string_view, double> sizes = {{"", 1},
                                                           {"kg", kilogram},
                                                           {"kg m^2", kilogram * metre * metre},
                                                           {"m", metre},
                                                           {"s", second},
                                                           {"m/s^2", metre / (second * second)},
                                                           {"Hz", 1 / second},
                                                           {"N m", newton * metre},
                                                           {"N/m", newton / metre},
                                                           {"N s/m", newton * second / metre}};
  for (const Quantity& quantity : quantities()) quantity.in(scenario) *= sizes.at(quantity.unit);
  return scenario;
}

inline State<double> in_other_units(const State<double>& q) {
  return {q[0] * metre,          q[1] * metre,          q[2],
          q[3] * metre / second, q[4] * metre / second, q[5] / second};
}

}  // namespace rotor
