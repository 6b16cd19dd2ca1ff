/// Where a function of time first becomes negative. With a bound on the function's curvature the
/// search misses no crossing: an interval counts as clear only if the function cannot reach zero in
/// it. Without a bound the curvature is estimated, generously.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace rotor {

/// A function at one time.
template <class S>
struct ValueAndSlope {
  S time{}, value{}, slope{};
};

/// Twice the largest |f''| of the cubic through a and b: an estimate for functions as smooth as
/// error control makes them within a step.
template <class S>
S estimated_curvature(const ValueAndSlope<S>& a, const ValueAndSlope<S>& b) {
  using std::abs, std::max;
  const S h = b.time - a.time, rise = 6 * (b.value - a.value) / h;
  return 2 * max(abs(rise - 4 * a.slope - 2 * b.slope), abs(rise - 2 * a.slope - 4 * b.slope)) / h;
}

/// Whether f is nowhere negative between a and b if |f''| <= curvature. The parabolas of that
/// curvature through both ends are lower bounds, and the least value that both allow is where they
/// meet.
template <class S>
bool stays_clear(const ValueAndSlope<S>& a, const ValueAndSlope<S>& b, const S& curvature) {
  if (!(a.value >= 0 && b.value >= 0)) return false;
  const S h = b.time - a.time, bend = curvature * h;  // change of the parabolas' slopes
  if (a.slope >= bend || -b.slope >= bend) return true;
  const S meet = (a.value - b.value + (b.slope + bend / 2) * h) / (bend + b.slope - a.slope);
  if (!(meet > 0 && meet < h)) return true;
  return a.value + meet * (a.slope - curvature * meet / 2) > 0;
}

/// The last zero of a function that falls from a to b: Newton's method from b on the cubic through
/// both. Arbitrary if the cubic has none.
template <class S>
S estimated_zero(const ValueAndSlope<S>& a, const ValueAndSlope<S>& b) {
  const S h = b.time - a.time, rise = b.value - a.value, from = a.slope * h, to = b.slope * h;
  const S square = 3 * rise - 2 * from - to, cube = from + to - 2 * rise;
  S u(1);
  for (int n = 0; n < 6; ++n)
    u -=
        (a.value + u * (from + u * (square + u * cube))) / (from + u * (2 * square + 3 * u * cube));
  return a.time + h * u;
}

/// The first time between a and b after which f < 0, to within `resolution` and on the negative
/// side. A function that is zero at a, to rounding, has crossed there if it is negative right
/// after; if it is positive for a while, it may cross later. `f(time)` returns a ValueAndSlope;
/// `curvature` bounds |f''|, if there is a bound. Where f is not finite, nothing is searched.
template <class S, class Function>
std::optional<S> first_crossing(ValueAndSlope<S> a, ValueAndSlope<S> b, const S& resolution,
                                const std::optional<S>& curvature, const Function& f) {
  using std::abs;
  if (a.value <= 0 && a.slope <= 0) {
    if (b.value >= 0) return std::nullopt;
    ValueAndSlope<S> left = b;
    while (left.value <= 0) {
      if (left.time - a.time <= resolution) return a.time;
      left = f(a.time + (left.time - a.time) / 2);
    }
    a = left;
  }
  // A function that is negative at the start only by rounding counts as zero there, not as crossed:
  // it becomes positive in a small part of the interval. In a short step, the rounding may take
  // more time than the resolution.
  constexpr int small_part = 1024;
  if (a.value < 0 && a.value + a.slope * (b.time - a.time) / small_part > 0) a.value = 0;
  // Nor has a function crossed zero that rises, and is positive a little later.
  const auto is_negative = [&](const ValueAndSlope<S>& at) {
    return at.value < 0 && !(at.value + 16 * at.slope * resolution > 0);
  };
  for (int slow = 0;;) {
    const S h = b.time - a.time;
    const bool crosses = is_negative(b);
    if (h <= resolution) return crosses ? std::optional(b.time) : std::nullopt;
    const S bound = curvature ? *curvature : estimated_curvature(a, b);
    if (!crosses && stays_clear(a, b, bound)) return std::nullopt;
    if (crosses && abs(b.value) <= -b.slope * resolution &&
        stays_clear(a, {b.time, S(0), b.slope}, bound))
      return b.time;

    S time = a.time + h / 2;
    if (crosses && slow < 2)
      if (const S zero = estimated_zero(a, b) + resolution / 2; zero > a.time && zero < b.time)
        time = zero;
    const ValueAndSlope<S> middle = f(time);
    if (!(middle.value - middle.value + middle.slope - middle.slope == 0))  // it is not finite
      return crosses ? std::optional(b.time) : std::nullopt;
    if (is_negative(middle)) {
      b = middle;
    } else if (const auto earlier = first_crossing(a, middle, resolution, curvature, f)) {
      return earlier;
    } else {
      a = middle;
    }
    slow = b.time - a.time > h / 2 ? slow + 1 : 0;
  }
}

}  // namespace rotor
