/// Interpolation between points whose values and rates are known.
#pragma once

#include <array>
#include <cstddef>

namespace rotor {

/// The polynomial of degree 2 N - 1 through N points with their rates, in Newton's form with every
/// point taken twice. Unknowns is an array of numbers.
template <class S, class Unknowns, std::size_t N>
class HermitePolynomial {
 public:
  /// Through points with time, x and rates.
  template <class Node>
  explicit HermitePolynomial(const std::array<Node, N>& nodes) {
    for (std::size_t i = 0; i < terms; ++i) {
      time_[i] = nodes[i / 2].time;
      difference_[i] = nodes[i / 2].x;
    }
    for (std::size_t order = 1; order < terms; ++order)
      for (std::size_t i = terms; i-- > order;) {
        const bool same_point = order == 1 && i % 2 == 1;
        for (std::size_t k = 0; k < difference_[i].size(); ++k)
          difference_[i][k] = same_point ? nodes[i / 2].rates[k]
                                         : (difference_[i][k] - difference_[i - 1][k]) /
                                               (time_[i] - time_[i - order]);
      }
  }

  Unknowns operator()(const S& time) const {
    Unknowns x = difference_[terms - 1];
    for (std::size_t i = terms - 1; i-- > 0;)
      for (std::size_t k = 0; k < x.size(); ++k)
        x[k] = difference_[i][k] + (time - time_[i]) * x[k];
    return x;
  }

  Unknowns rates(const S& time) const {
    Unknowns x = difference_[terms - 1], rates{};
    for (std::size_t i = terms - 1; i-- > 0;)
      for (std::size_t k = 0; k < x.size(); ++k) {
        rates[k] = x[k] + (time - time_[i]) * rates[k];
        x[k] = difference_[i][k] + (time - time_[i]) * x[k];
      }
    return rates;
  }

 private:
  static constexpr std::size_t terms = 2 * N;
  std::array<S, terms> time_;
  std::array<Unknowns, terms> difference_;
};

}  // namespace rotor
