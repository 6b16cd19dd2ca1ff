/// The cosines and sines of two angles at once, which are usually small.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

namespace rotor {

/// 1/n! - z/(n + 2)! + z^2/(n + 4)! ... z^9/(n + 18)!, in independent parts.
template <int n, class Numbers>
Numbers alternating_series(const Numbers& z) {
  constexpr auto terms = [] {
    std::array<double, 10> all{};
    double factorial = 1;
    for (int i = 2; i < n + 20; ++i) {
      factorial *= i;
      if (i >= n && (i - n) % 2 == 0) all[static_cast<std::size_t>(i - n) / 2] = 1 / factorial;
    }
    return all;
  }();
  const auto two = [&](std::size_t k) -> Numbers { return terms[k] - terms[k + 1] * z; };
  const Numbers z2 = z * z, z4 = z2 * z2;
  return (two(0) + z2 * two(2)) + z4 * ((two(4) + z2 * two(6)) + z4 * two(8));
}

/// Cosines, and sines.
template <class S>
using Turns = std::array<std::array<S, 2>, 2>;

template <class S>
Turns<S> turns(const S& a, const S& b) {
  using std::abs, std::cos, std::sin;
  if constexpr (std::is_same_v<S, double>) {
    constexpr double small = 1.5;  // rad; up to here the series are exact to rounding
    if (abs(a) < small && abs(b) < small) {
      using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;
      const Pair x = {a, b}, z = x * x;
      const Pair cosine = 1 - z * alternating_series<2>(z),
                 sine = x - x * z * alternating_series<3>(z);
      return {{{cosine[0], cosine[1]}, {sine[0], sine[1]}}};
    }
  }
  return {{{cos(a), cos(b)}, {sin(a), sin(b)}}};
}

}  // namespace rotor
