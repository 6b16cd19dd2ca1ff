/// All maxima of a function of time in an interval. Nothing is searched where bounds exclude a
/// maximum above a threshold; an interval that may have several is halved.
#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

#include "model/integration/crossing.hpp"

namespace rotor {

/// Calls found(at) for the maxima of a positive function above a threshold, from a sample of it to
/// another. `f(time)` returns a sample, at any time from the first to a little after the last.
/// Curvatures are estimated, as where events have no bound. A maximum at the end belongs to the
/// interval, one at the beginning does not. Where the function is constant to rounding, its
/// greatest sample is a maximum.
template <class S, class Function, class Found>
class MaximaSearch {
 public:
  using Sample = ValueAndSlope<S>;

  /// `look_ahead`: the time over which the slope's own slope at an end is taken as a difference.
  MaximaSearch(const S& threshold, const S& look_ahead, const Function& f, const Found& found)
      : threshold_(threshold), look_ahead_(look_ahead), f_(f), found_(found) {}

  void operator()(const Sample& a, const Sample& b) const {
    if (!are_excluded(a, b) && !are_excluded_by_slopes(a.time, b.time)) search(a, b, 0);
    // Slopes that contradict the values are no more than errors of the motion.
    if (a.slope > 0 && b.slope > 0 && b.value < a.value) report(a);
    if (a.slope < 0 && b.slope < 0 && b.value > a.value) report(b);
  }

 private:
  /// Whether the function stays below the threshold, or its slope keeps its sign.
  bool are_excluded(const Sample& a, const Sample& b) const {
    using std::abs;
    const auto missing = [&](const Sample& at) -> Sample {
      return {at.time, threshold_ - at.value, -at.slope};
    };
    const S curvature = estimated_curvature(a, b);
    if (stays_clear(missing(a), missing(b), curvature)) return true;
    const bool have_one_sign = (a.slope > 0 && b.slope > 0) || (a.slope < 0 && b.slope < 0);
    return have_one_sign && abs(a.slope + b.slope) > curvature * (b.time - a.time);
  }

  /// Whether the slope keeps its sign, or rises, by its own slopes at both ends.
  bool are_excluded_by_slopes(const S& from, const S& until) const {
    const auto slope_at = [&](const S& time) -> Sample {
      const S here = f_(time).slope, later = f_(time + look_ahead_).slope;
      return {time, here, (later - here) / look_ahead_};
    };
    const auto negative = [](const Sample& at) -> Sample {
      return {at.time, -at.value, -at.slope};
    };
    const Sample first = slope_at(from), last = slope_at(until);
    const S bend = estimated_curvature(first, last);
    return first.slope + last.slope > bend * (until - from) || stays_clear(first, last, bend) ||
           stays_clear(negative(first), negative(last), bend);
  }

  void search(const Sample& a, const Sample& b, int depth) const {
    using std::abs;
    const S h = b.time - a.time;
    const Sample middle = f_(a.time + h / 2);
    // The slope as a parabola through all three: the mean of its slope, and twice the change of it.
    const S rise = b.slope - a.slope, bend = 4 * abs(a.slope - 2 * middle.slope + b.slope);
    if (rise > bend) return;
    if (rise < -bend) {
      if (a.slope > 0 && b.slope <= 0) locate(a, b);
      return;
    }
    // Rounding is what the ends do not tell of the middle, and halving does not make small beside
    // the change.
    constexpr int enough = 3, most = 20;
    const S change = h * (abs(a.slope) + 2 * abs(middle.slope) + abs(b.slope)) / 4,
            untold = abs(middle.value - (a.value + b.value) / 2 - h * (a.slope - b.slope) / 8);
    if (change < 64 * std::numeric_limits<S>::epsilon() * middle.value || depth == most ||
        (depth >= enough && change < 8 * untold)) {
      report(std::max({a, middle, b}, [](const Sample& one, const Sample& other) {
        return one.value < other.value;
      }));
      return;
    }
    if (!are_excluded(a, middle)) search(a, middle, depth + 1);
    if (!are_excluded(middle, b)) search(middle, b, depth + 1);
  }

  /// In an interval that is curved downwards: by values, because slopes may come from equations
  /// that the function fulfils to a tolerance.
  void locate(const Sample& a, const Sample& b) const {
    constexpr int bits = std::numeric_limits<S>::digits / 2;  // a maximum is flat
    const S h = b.time - a.time;
    const auto [share, least] = boost::math::tools::brent_find_minima(
        [&](const S& part) { return S(-f_(a.time + part * h).value); }, S(0), S(1), bits);
    report({a.time + share * h, -least, S(0)});
  }

  void report(const Sample& at) const {
    if (at.value > threshold_) found_(at);
  }

  S threshold_, look_ahead_;
  const Function& f_;
  const Found& found_;
};

}  // namespace rotor
