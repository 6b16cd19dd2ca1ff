/// Ball arithmetic: a real number known to lie within a radius of a midpoint. A thin wrapper of
/// Arb's arb_t, so that formulas read like formulas. Every operation encloses the exact result.
#pragma once

#include <arb.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace proof {

/// What cannot be decided: neither that something happens, nor that it does not.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Ball {
 public:
  /// Bits of the midpoints that operations round to.
  static inline long bits = 128;

  Ball() { arb_init(a_); }
  Ball(long n) : Ball() { arb_set_si(a_, n); }   // NOLINT: numbers in formulas
  Ball(int n) : Ball(static_cast<long>(n)) {}    // NOLINT
  Ball(double x) : Ball() { arb_set_d(a_, x); }  // NOLINT: exact
  /// A number as printed, such as "0.15e-3". Throws std::invalid_argument if it is none.
  explicit Ball(const std::string& decimal);
  Ball(const Ball& b) : Ball() { arb_set(a_, b.a_); }
  Ball(Ball&& b) noexcept : Ball() { arb_swap(a_, b.a_); }
  Ball& operator=(Ball b) noexcept {
    arb_swap(a_, b.a_);
    return *this;
  }
  ~Ball() { arb_clear(a_); }

  arb_ptr get() { return a_; }
  arb_srcptr get() const { return a_; }

  Ball& operator+=(const Ball& b) { return arb_add(a_, a_, b.a_, bits), *this; }
  Ball& operator-=(const Ball& b) { return arb_sub(a_, a_, b.a_, bits), *this; }
  Ball& operator*=(const Ball& b) { return arb_mul(a_, a_, b.a_, bits), *this; }
  Ball& operator/=(const Ball& b) { return arb_div(a_, a_, b.a_, bits), *this; }
  friend Ball operator+(Ball a, const Ball& b) { return std::move(a += b); }
  friend Ball operator-(Ball a, const Ball& b) { return std::move(a -= b); }
  friend Ball operator*(Ball a, const Ball& b) { return std::move(a *= b); }
  friend Ball operator/(Ball a, const Ball& b) { return std::move(a /= b); }
  friend Ball operator-(Ball a) { return arb_neg(a.a_, a.a_), std::move(a); }

  /// Whether every number of the ball is.
  bool is_positive() const { return arb_is_positive(a_) != 0; }
  bool is_negative() const { return arb_is_negative(a_) != 0; }
  bool is_exactly_zero() const { return arb_is_zero(a_) != 0; }
  bool is_finite() const { return arb_is_finite(a_) != 0; }
  bool contains(const Ball& b) const { return arb_contains(a_, b.a_) != 0; }

  Ball middle() const {
    return made([&](arb_ptr r) { arb_get_mid_arb(r, a_); });
  }
  Ball radius() const {
    return made([&](arb_ptr r) { arb_get_rad_arb(r, a_); });
  }
  /// The ends, which are exact, and lie outside by rounding.
  Ball lower() const {
    return made([&](arb_ptr r) { arb_get_lbound_arf(arb_midref(r), a_, bits); });
  }
  Ball upper() const {
    return made([&](arb_ptr r) { arb_get_ubound_arf(arb_midref(r), a_, bits); });
  }
  /// The greatest absolute value.
  Ball size() const {
    return made([&](arb_ptr r) { arb_get_abs_ubound_arf(arb_midref(r), a_, bits); });
  }
  double to_double() const { return arf_get_d(arb_midref(a_), ARF_RND_NEAR); }

  /// The ball of both, and one of what both contain. Throws std::logic_error if that is nothing:
  /// then one of them is wrong.
  friend Ball hull(const Ball& a, const Ball& b) {
    return made([&](arb_ptr r) { arb_union(r, a.a_, b.a_, bits); });
  }
  friend Ball common(const Ball& a, const Ball& b);
  friend Ball sqrt(const Ball& a) {
    return made([&](arb_ptr r) { arb_sqrt(r, a.a_, bits); });
  }
  friend Ball sin(const Ball& a) {
    return made([&](arb_ptr r) { arb_sin(r, a.a_, bits); });
  }
  friend Ball cos(const Ball& a) {
    return made([&](arb_ptr r) { arb_cos(r, a.a_, bits); });
  }
  static Ball pi() {
    return made([](arb_ptr r) { arb_const_pi(r, bits); });
  }
  /// All numbers from -size to size.
  static Ball within(const Ball& size) {
    return made([&](arb_ptr r) { arb_add_error(r, size.a_); });
  }

 private:
  template <class Make>
  static Ball made(const Make& make) {
    Ball result;
    make(result.a_);
    return result;
  }

  arb_t a_;
};

static_assert(sizeof(Ball) == sizeof(arb_struct), "rows of balls are rows of arb_t");

/// The sum of the products a[i] b[k - i], i = first ... last.
Ball convolution(const Ball* a, const Ball* b, long first, long last, long k);

/// 2^n.
inline Ball power_of_two(long n) {
  Ball x(1);
  arb_mul_2exp_si(x.get(), x.get(), n);
  return x;
}

using Row = std::vector<Ball>;
using Matrix = std::vector<Row>;

/// The sum of the products.
Ball dot(const Row& a, const Row& b);

/// Encloses the inverse. Throws Undecided if there may be none.
Matrix inverse(Matrix a);
/// About orthonormal columns that span what the first, the first two, ... columns of `a` span, the
/// longest first: each is stretched by its size. Lengths and angles are those of rows in units of
/// their scales. The result has exact entries.
Matrix orthonormal(const Matrix& a, const Row& sizes, const Row& scales);

/// Both ends as decimals with that many digits, rounded outwards.
std::pair<std::string, std::string> decimal_ends(const Ball& a, int digits);

}  // namespace proof
