/// Results over all values of a continuous quantity.
#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>

namespace rotor {

/// A result on a grid, refined until the last two grids agree to a relative difference. A feature
/// narrower than both grids stays unseen. Throws std::runtime_error if they never agree.
inline double refined(const std::function<double(long points)>& on_grid, long points,
                      double agreement) {
  double before = on_grid(points);
  for (int refinements = 0; refinements < 5; ++refinements) {
    points *= 2;
    const double now = on_grid(points);
    if (std::abs(now - before) <= agreement * std::abs(now)) return now;
    before = now;
  }
  throw std::runtime_error("grids do not agree, even the finest ones");
}

}  // namespace rotor
