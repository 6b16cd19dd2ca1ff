/// Cosines and sines together: of two angles that are usually small, or of an angle of some turns.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "model/mechanics/plane.hpp"

namespace rotor {

/// A SIMD pair.
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;

/// 1/n!, 1/(n + 2)!, 1/(n + 4)! ... 1/(n + 18)!
template <int n>
inline constexpr auto inverse_factorials = [] {
  std::array<double, 10> all{};
  double factorial = 1;
  for (int i = 2; i < n + 20; ++i) {
    factorial *= i;
    if (i >= n && (i - n) % 2 == 0) all[static_cast<std::size_t>(i - n) / 2] = 1 / factorial;
  }
  return all;
}();

/// term(0) - term(1) z + term(2) z^2 ... - term(9) z^9, in independent parts.
template <class Term>
Pair alternating_series(const Pair& z, const Term& term) {
  const auto two = [&](std::size_t k) -> Pair { return term(k) - term(k + 1) * z; };
  const Pair z2 = z * z, z4 = z2 * z2;
  return (two(0) + z2 * two(2)) + z4 * ((two(4) + z2 * two(6)) + z4 * two(8));
}

/// Cosines, and sines.
template <class S>
using CosinesAndSines = std::array<std::array<S, 2>, 2>;

template <class S>
CosinesAndSines<S> cosines_and_sines(const S& a, const S& b) {
  using std::abs, std::cos, std::sin;
  if constexpr (std::is_same_v<S, double>) {
    constexpr double small = 1.5;  // rad; up to here the series are exact to rounding
    if (abs(a) < small && abs(b) < small) {
      const auto of_cosine = [](std::size_t k) { return inverse_factorials<2>[k]; };
      const auto of_sine = [](std::size_t k) { return inverse_factorials<3>[k]; };
      const Pair x = {a, b}, z = x * x;
      const Pair cosine = 1 - z * alternating_series(z, of_cosine),
                 sine = x - x * z * alternating_series(z, of_sine);
      return {{{cosine[0], cosine[1]}, {sine[0], sine[1]}}};
    }
  }
  return {{{cos(a), cos(b)}, {sin(a), sin(b)}}};
}

/// The unit vector at an angle.
template <class S>
Vector<S> unit_vector(const S& angle) {
  using std::abs, std::cos, std::sin;
  if constexpr (std::is_same_v<S, double>) {
    constexpr double far = 1000;  // rad; up to here whole quarter turns are subtracted exactly
    if (abs(angle) < far) {
      // Adding the large number rounds to a whole one. The quarter turn in two parts, one of few
      // digits.
      constexpr double large = 0x1.8p52, quarters_per_rad = 0x1.45f306dc9c883p-1,
                       quarter = 0x1.921fb544p0, rest_of_quarter = 0x1.0b4611a626331p-34;
      const double quarters = (angle * quarters_per_rad + large) - large;
      const double rest = (angle - quarters * quarter) - quarters * rest_of_quarter;
      const auto of_both = [](std::size_t k) {
        return Pair{inverse_factorials<2>[k], inverse_factorials<3>[k]};
      };
      const Pair z = {rest * rest, rest * rest}, first = {1, rest};
      const Pair vector = first - first * z * alternating_series(z, of_both);
      static constexpr std::array<std::array<double, 2>, 4> turned_by = {
          {{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
      const auto& [c, s] = turned_by[static_cast<unsigned>(static_cast<int>(quarters)) % 4];
      return turned(Vector<S>(vector[0], vector[1]), c, s);
    }
  }
  return {cos(angle), sin(angle)};
}

}  // namespace rotor
