/// How far two states are apart.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/mechanics/rotating_frame.hpp"

namespace rotor {

/// Largest deviation of two states, each component in its own unit.
inline double deviation(const State<double>& a, const State<double>& b) {
  const double length = 3e-3, speed = std::abs(b[5]) + 1;
  return std::max({std::hypot(a[0] - b[0], a[1] - b[1]) / length,
                   std::hypot(a[3] - b[3], a[4] - b[4]) / (length * speed),
                   std::abs(a[5] - b[5]) / speed, std::abs(a[2] - b[2])});
}

}  // namespace rotor
