#include "verification/proof/ball.hpp"

#include <arb_mat.h>
#include <mpfr.h>

#include <algorithm>
#include <array>

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

Matrix inverse(Matrix a) {
  const auto n = static_cast<long>(a.size());
  arb_mat_t matrix;
  arb_mat_init(matrix, n, n);
  const auto for_entries = [&](const auto& action) {
    for (long i = 0; i < n * n; ++i)
      action(arb_mat_entry(matrix, i / n, i % n),
             a[static_cast<std::size_t>(i / n)][static_cast<std::size_t>(i % n)].get());
  };
  for_entries([](arb_ptr to, arb_ptr from) { arb_set(to, from); });
  const bool regular = arb_mat_inv(matrix, matrix, Ball::bits) != 0;
  for_entries([](arb_ptr from, arb_ptr to) { arb_set(to, from); });
  arb_mat_clear(matrix);
  if (!regular) throw Undecided("whether a matrix is singular");
  return a;
}

Matrix orthonormal(const Matrix& a, const Row& sizes, const Row& scales) {
  const std::size_t n = a.size();
  Matrix columns(n, Row(n)), result = columns;
  std::vector<std::pair<Ball, std::size_t>> order;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) columns[j][i] = (a[i][j] / scales[i]).middle();
    order.emplace_back(sizes[j] * sizes[j] * dot(columns[j], columns[j]), j);
  }
  std::sort(order.begin(), order.end(), [](const auto& x, const auto& y) {
    return (x.first.middle() - y.first.middle()).is_positive();
  });
  for (std::size_t k = 0; k < n; ++k) {
    Row& column = columns[order[k].second];
    const auto share_left = [&] {  // of its length, when those before are removed
      const Ball before = sqrt(dot(column, column));
      for (int pass = 0; pass < 2; ++pass)  // the second removes what rounding left
        for (std::size_t l = 0; l < k; ++l) {
          const Row& other = columns[order[l].second];
          const Ball along = dot(column, other).middle();
          for (std::size_t i = 0; i < n; ++i) column[i] = (column[i] - along * other[i]).middle();
        }
      return (sqrt(dot(column, column)) / before).middle();
    };
    Ball least = power_of_two(-Ball::bits / 2);  // below it is rounding: then any other will do
    for (std::size_t unit = 0; !(share_left() - least).is_positive() && unit < n; ++unit) {
      column = Row(n);
      column[unit] = 1;
      least = 1e-3;
    }
    const Ball length = sqrt(dot(column, column));
    for (std::size_t i = 0; i < n; ++i) column[i] = (column[i] / length).middle();
  }
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
