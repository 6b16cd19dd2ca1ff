/// Ball arithmetic: a real number known to lie within a radius of a midpoint. A thin wrapper of
/// Arb's arb_t, so that formulas read like formulas. Every operation encloses the exact result.
#pragma once

#include <arb.h>

#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace proof {

/// Something that cannot be decided: neither that it is true, nor that it is false.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws std::logic_error, for a wrong use of the prover.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

class Ball {
 public:
  /// Bits to which operations round midpoints.
  static inline long bits = 128;

  Ball() { arb_init(a_); }
  Ball(std::integral auto n) : Ball() { arb_set_si(a_, static_cast<long>(n)); }  // NOLINT
  Ball(double x) : Ball() { arb_set_d(a_, x); }  // NOLINT: numbers in formulas, exact
  /// A number as printed, such as "0.15e-3". Throws std::invalid_argument if it is not a number.
  explicit Ball(const std::string& decimal) : Ball() {
    if (arb_set_str(a_, decimal.c_str(), bits) != 0)
      throw std::invalid_argument("not a number: " + decimal);
  }
  Ball(const Ball& b) : Ball() { arb_set(a_, b.a_); }
  Ball(Ball&& b) noexcept : Ball() { arb_swap(a_, b.a_); }
  Ball& operator=(Ball b) noexcept {
    arb_swap(a_, b.a_);
    return *this;
  }
  ~Ball() { arb_clear(a_); }

  arb_ptr get() { return a_; }
  arb_srcptr get() const { return a_; }

  friend Ball operator+(const Ball& a, const Ball& b) { return made(arb_add, a.a_, b.a_, bits); }
  friend Ball operator-(const Ball& a, const Ball& b) { return made(arb_sub, a.a_, b.a_, bits); }
  friend Ball operator*(const Ball& a, const Ball& b) { return made(arb_mul, a.a_, b.a_, bits); }
  friend Ball operator/(const Ball& a, const Ball& b) { return made(arb_div, a.a_, b.a_, bits); }
  friend Ball operator-(const Ball& a) { return made(arb_neg, a.a_); }
  friend Ball sqrt(const Ball& a) { return made(arb_sqrt, a.a_, bits); }
  friend Ball sin(const Ball& a) { return made(arb_sin, a.a_, bits); }
  friend Ball cos(const Ball& a) { return made(arb_cos, a.a_, bits); }
  friend Ball pow(const Ball& a, std::size_t n) { return made(arb_pow_ui, a.a_, n, bits); }
  static Ball pi() { return made(arb_const_pi, bits); }
  static Ball power_of_two(long n) { return made(arb_mul_2exp_si, Ball(1).a_, n); }

  /// Whether it holds for all numbers of both. Overlapping balls are neither less nor greater, nor
  /// is NaN: only a comparison that returns true is certain.
  friend bool operator<(const Ball& a, const Ball& b) { return arb_lt(a.a_, b.a_) != 0; }
  friend bool operator>(const Ball& a, const Ball& b) { return b < a; }
  bool contains(const Ball& b) const { return arb_contains(a_, b.a_) != 0; }
  bool is_finite() const { return arb_is_finite(a_) != 0; }

  /// Exact: the midpoint; and rounded outwards: the radius, the ends, the greatest absolute value.
  Ball middle() const { return made(arb_get_mid_arb, a_); }
  Ball radius() const { return made(arb_get_rad_arb, a_); }
  Ball lower() const { return end(arb_get_lbound_arf); }
  Ball upper() const { return end(arb_get_ubound_arf); }
  Ball size() const { return end(arb_get_abs_ubound_arf); }
  double to_double() const { return arf_get_d(arb_midref(a_), ARF_RND_NEAR); }

  friend Ball max(const Ball& a, const Ball& b) { return made(arb_max, a.a_, b.a_, bits); }
  /// A ball that contains both.
  friend Ball hull(const Ball& a, const Ball& b) { return made(arb_union, a.a_, b.a_, bits); }
  /// All numbers from -size to size.
  static Ball within(const Ball& size) { return made(arb_add_error, size.a_); }

 private:
  static Ball made(const auto& function, const auto&... arguments) {
    Ball result;
    function(result.a_, arguments...);
    return result;
  }
  Ball end(const auto& function) const {
    Ball result;
    function(arb_midref(result.a_), a_, bits);
    return result;
  }

  arb_t a_;
};

static_assert(sizeof(Ball) == sizeof(arb_struct), "rows of balls are rows of arb_t");

using Row = std::vector<Ball>;
using Matrix = std::vector<Row>;

/// The sum of the products a[i] b[i], i = 0 ... count - 1; of b[-i] if the step is -1.
inline Ball dot(const Ball* a, const Ball* b, std::size_t count, long b_step = 1) {
  Ball sum;
  arb_dot(sum.get(), nullptr, 0, a->get(), 1, b->get(), b_step, static_cast<long>(count),
          Ball::bits);
  return sum;
}
inline Ball dot(const Row& a, const Row& b) {
  require(a.size() == b.size(), "an inner product of rows of different lengths");
  return dot(a.data(), b.data(), a.size());
}

}  // namespace proof
