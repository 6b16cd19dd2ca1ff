#include "verification/proof/ball.hpp"

#include <arb_mat.h>
#include <mpfr.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace proof {

Ball::Ball(const std::string& decimal) : Ball() {
  if (arb_set_str(a_, decimal.c_str(), bits) != 0)
    throw std::invalid_argument("not a number: " + decimal);
}

Ball common(const Ball& a, const Ball& b) {
  return Ball::made([&](arb_ptr r) {
    if (arb_intersection(r, a.a_, b.a_, Ball::bits) == 0)
      throw std::logic_error("two enclosures of one number have nothing in common");
  });
}

Ball convolution(const Ball* a, const Ball* b, long first, long last, long k) {
  Ball sum;
  if (first <= last)
    arb_dot(sum.get(), nullptr, 0, a[first].get(), 1, b[k - first].get(), -1, last - first + 1,
            Ball::bits);
  return sum;
}

Ball dot(const Row& a, const Row& b) {
  Ball sum;
  if (!a.empty())
    arb_dot(sum.get(), nullptr, 0, a[0].get(), 1, b[0].get(), 1, static_cast<long>(a.size()),
            Ball::bits);
  return sum;
}

Matrix inverse(const Matrix& a) {
  const auto n = static_cast<long>(a.size());
  arb_mat_t matrix, result;
  arb_mat_init(matrix, n, n);
  arb_mat_init(result, n, n);
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < n; ++j)
      arb_set(arb_mat_entry(matrix, i, j),
              a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get());
  const bool regular = arb_mat_inv(result, matrix, Ball::bits) != 0;
  Matrix inverse = a;
  for (long i = 0; i < n; ++i)
    for (long j = 0; j < n; ++j)
      arb_set(inverse[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get(),
              arb_mat_entry(result, i, j));
  arb_mat_clear(matrix);
  arb_mat_clear(result);
  if (!regular) throw Undecided("whether a matrix is singular");
  return inverse;
}

Matrix orthonormal(const Matrix& a, const Row& sizes, const Row& scales) {
  const std::size_t n = a.size();
  Matrix columns(n, Row(n));  // as rows
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) columns[j][i] = (a[i][j] / scales[i]).middle();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  const auto size = [&](std::size_t j) {
    return (sizes[j] * sizes[j] * dot(columns[j], columns[j])).middle();
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return (size(i) - size(j)).is_positive(); });
  for (std::size_t k = 0; k < n; ++k) {
    Row& column = columns[order[k]];
    const auto length_left = [&] {  // as a share of what it was before the others were removed
      const Ball before = sqrt(dot(column, column));
      for (int pass = 0; pass < 2; ++pass)  // the second removes what rounding left
        for (std::size_t l = 0; l < k; ++l) {
          const Row& other = columns[order[l]];
          const Ball along = dot(column, other).middle();
          for (std::size_t i = 0; i < n; ++i) column[i] = (column[i] - along * other[i]).middle();
        }
      return (sqrt(dot(column, column)) / before).middle();
    };
    Ball least(1);  // below it is rounding
    arb_mul_2exp_si(least.get(), least.get(), -Ball::bits / 2);
    for (std::size_t unit = 0; !(length_left() - least).is_positive() && unit < n; ++unit) {
      column = Row(n);
      column[unit] = 1;
      least = 1e-3;
    }
    const Ball length = sqrt(dot(column, column));
    for (std::size_t i = 0; i < n; ++i) column[i] = (column[i] / length).middle();
  }
  Matrix result(n, Row(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) result[i][j] = (columns[j][i] * scales[i]).middle();
  return result;
}

std::pair<std::string, std::string> decimal_ends(const Ball& a, int digits) {
  mpfr_t lower, upper;
  mpfr_init2(lower, Ball::bits);
  mpfr_init2(upper, Ball::bits);
  arb_get_interval_mpfr(lower, upper, a.get());
  std::array<char, 300> low{}, high{};
  mpfr_snprintf(low.data(), low.size(), "%.*RDe", digits - 1, lower);
  mpfr_snprintf(high.data(), high.size(), "%.*RUe", digits - 1, upper);
  mpfr_clear(lower);
  mpfr_clear(upper);
  return {low.data(), high.data()};
}

}  // namespace proof
