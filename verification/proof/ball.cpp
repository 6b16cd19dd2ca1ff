#include "verification/proof/ball.hpp"

#include <arb_mat.h>
#include <mpfr.h>

#include <algorithm>
#include <array>

namespace proof {

std::pair<std::string, std::string> Ball::decimal_ends(int digits) const {
  if (arb_is_int(a_)) {
    const std::string count = std::to_string(arf_get_si(arb_midref(a_), ARF_RND_NEAR));
    return {count, count};
  }
  std::array<char, 300> low{}, high{};
  mpfr_t lower, upper;
  mpfr_inits2(bits, lower, upper, nullptr);
  arb_get_interval_mpfr(lower, upper, a_);
  mpfr_snprintf(low.data(), low.size(), "%.*RDe", digits - 1, lower);
  mpfr_snprintf(high.data(), high.size(), "%.*RUe", digits - 1, upper);
  mpfr_clears(lower, upper, nullptr);
  return {low.data(), high.data()};
}

Ball dot(const Ball* a, const Ball* b, std::size_t count, long b_step) {
  Ball sum;
  if (count > 0)
    arb_dot(sum.get(), nullptr, 0, a->get(), 1, b->get(), b_step, static_cast<long>(count),
            Ball::bits);
  return sum;
}

Matrix inverse(const Matrix& a) {
  const std::size_t n = a.size();
  Matrix result(n, Row(n));
  arb_mat_t matrix;
  arb_mat_init(matrix, static_cast<long>(n), static_cast<long>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) arb_set(&matrix->rows[i][j], a[i][j].get());
  const bool regular = arb_mat_inv(matrix, matrix, Ball::bits) != 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) arb_set(result[i][j].get(), &matrix->rows[i][j]);
  arb_mat_clear(matrix);
  if (!regular) throw Undecided("whether a matrix is singular");
  return result;
}

Matrix orthonormal(Matrix columns) {  // by Gram and Schmidt, with pivoting
  const std::size_t n = columns.size();
  const auto square = [](const Row& column) { return dot(column, column).middle(); };
  const auto shorter = [&](const Row& a, const Row& b) { return square(a) < square(b); };
  // A column of which only rounding is left is replaced by a longer unit vector.
  const Ball longest = square(*std::max_element(columns.begin(), columns.end(), shorter));
  const Ball length =
      sqrt(longest) * Ball::power_of_two(-Ball::bits / 2) + Ball::power_of_two(-4 * Ball::bits);
  for (std::size_t i = 0; i < n; ++i) columns.emplace_back(n)[i] = length;
  for (auto column = columns.begin(); column != columns.begin() + static_cast<long>(n); ++column) {
    std::swap(*column, *std::max_element(column, columns.end(), shorter));
    const Ball norm = sqrt(square(*column));
    for (Ball& x : *column) x = (x / norm).middle();
    for (auto other = column + 1; other != columns.end(); ++other) {
      const Ball along = dot(*column, *other);
      for (std::size_t i = 0; i < n; ++i)
        (*other)[i] = ((*other)[i] - along * (*column)[i]).middle();
    }
  }
  columns.resize(n);
  return columns;
}

}  // namespace proof
