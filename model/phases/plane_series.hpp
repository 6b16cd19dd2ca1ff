/// Power series of a small real variable, with plane vectors as complex coefficients.
#pragma once

#include <array>
#include <cstddef>

#include "model/mechanics/plane.hpp"

namespace rotor {

inline constexpr std::size_t series_degree = 5;

/// A series with real terms.
template <class S>
using RealSeries = std::array<S, series_degree + 1>;

template <class S>
class PlaneSeries {
 public:
  static constexpr std::size_t degree = series_degree;

  PlaneSeries() { terms_.fill(Vector<S>(0, 0)); }
  static PlaneSeries linear(const Vector<S>& constant, const Vector<S>& factor) {
    PlaneSeries series;
    series[0] = constant;
    series[1] = factor;
    return series;
  }

  const Vector<S>& operator[](std::size_t n) const { return terms_[n]; }
  Vector<S>& operator[](std::size_t n) { return terms_[n]; }

  friend PlaneSeries operator+(PlaneSeries a, const PlaneSeries& b) {
    for (std::size_t n = 0; n <= degree; ++n) a[n] += b[n];
    return a;
  }
  friend PlaneSeries operator-(PlaneSeries a, const PlaneSeries& b) {
    for (std::size_t n = 0; n <= degree; ++n) a[n] -= b[n];
    return a;
  }
  friend PlaneSeries operator*(const S& factor, PlaneSeries a) {
    for (Vector<S>& term : a.terms_) term *= factor;
    return a;
  }
  friend PlaneSeries operator*(const Vector<S>& factor, PlaneSeries a) {
    for (Vector<S>& term : a.terms_) term = complex_product(term, factor);
    return a;
  }

  /// b[0] + b[1] x + b[2] x^2.
  using Quadratic = std::array<Vector<S>, 3>;
  friend PlaneSeries operator/(PlaneSeries a, const Quadratic& b) {
    const Vector<S> inverse = Vector<S>(b[0].x(), -b[0].y()) * (1 / b[0].squaredNorm());
    for (std::size_t n = 0; n <= degree; ++n) {
      for (std::size_t k = 1; k <= n && k < b.size(); ++k) a[n] -= complex_product(b[k], a[n - k]);
      a[n] = complex_product(a[n], inverse);
    }
    return a;
  }

 private:
  std::array<Vector<S>, degree + 1> terms_;
};

}  // namespace rotor
