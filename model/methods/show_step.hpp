/// Shows an observer what it wants to see of a step.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "model/phases/phase.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// The number of arcs into which to divide a step, so that each has at most one maximum.
template <class Phase, class S>
long arcs(const Phase& phase, const typename Phase::Unknowns& x, const S& duration) {
  return 1 + static_cast<long>(phase.phase_swing(x, duration));
}

/// An upper bound of an arc that is curved to one side.
template <class S>
S where_tangents_meet(const ExtremeValue<S>& a, const ExtremeValue<S>& b, const S& h) {
  return a.value + a.rate * (b.value - a.value - b.rate * h) / (a.rate - b.rate);
}

/// A step up to a time, as an observer sees it.
template <class S, class Step>
class DenseOutputOf : public BasicDenseOutput<S> {
 public:
  DenseOutputOf(const BasicInstant<S>& start, const S& until, Step& step)
      : BasicDenseOutput<S>(start.time_s, until,
                            arcs(step.system().phase(), step.start().x, S(until - start.time_s))),
        start_(start),
        step_(step) {}

  BasicInstant<S> at(const S& time_s) const override {
    BasicInstant<S> instant = start_;
    instant.time_s = time_s;
    const auto& chart = step_.system().phase().chart;
    instant.state = time_s == this->until_s  // where it costs nothing
                        ? chart.state(step_.stop().x)
                        : chart.state(step_.dense_output()(time_s - start_.time_s));
    return instant;
  }

 private:
  const BasicInstant<S>& start_;
  Step& step_;
};

/// The maxima that an observer wants to see, in order.
template <class S, class Step>
void show_maxima(Step& step, const BasicInstant<S>& start, const S& until_s,
                 BasicObserver<S>& observer) {
  using Point = typename Step::Point;
  using Unknowns = typename Step::Unknowns;
  const auto& phase = step.system().phase();
  const S duration = until_s - start.time_s;
  const auto threshold = [&](Extreme of, const S& from, const S& until) {
    return observer.threshold(of, start.time_s + from, start.time_s + until);
  };
  using Phase = std::remove_cvref_t<decltype(phase)>;
  constexpr auto& kinds = Phase::extremes_of;
  const auto& upper_bounds = step.bounds().upper_bounds;
  bool is_beyond_reach = true;
  for (std::size_t i = 0; i < kinds.size() && is_beyond_reach; ++i)
    is_beyond_reach = threshold(kinds[i], S(0), duration) >= upper_bounds[i];
  if (is_beyond_reach) return;
  long parts = arcs(phase, step.start().x, duration);
  // In contact at loose tolerances most steps are long, and each point inside costs an
  // interpolation.
  if constexpr (Phase::bounds_vibration)
    if (parts > 1) {
      const auto vibration = phase.vibration_reach(step.start(), step.stop());
      bool stays_below = true;
      for (std::size_t i = 0; i < kinds.size(); ++i)
        stays_below = stays_below && vibration[i] <= threshold(kinds[i], S(0), duration);
      if (stays_below) parts = 1;
    }
  std::vector<BasicMaximum<S>> found;
  Point left = step.start();
  for (long n = 1; n <= parts; ++n) {
    const Point right = n == parts ? step.stop() : step.at(duration * S(n) / S(parts));
    const auto at_left = phase.extremes(left.x, left.rates);
    const auto at_right = phase.extremes(right.x, right.rates);
    for (std::size_t i = 0; i < at_left.size(); ++i) {
      const ExtremeValue<S>&l = at_left[i], &r = at_right[i];
      if (!(l.rate > 0 && r.rate < 0)) continue;
      using std::min;
      const S bound = min(upper_bounds[i], where_tangents_meet(l, r, S(right.time - left.time)));
      if (bound <= threshold(kinds[i], left.time, right.time)) continue;
      const auto rate = [&](const Unknowns& x) {
        Unknowns rates{};
        if (phase.extreme_takes_rates(i)) step.system()(x, rates, S(0));
        return phase.extremes(x, rates)[i].rate;
      };
      const Point maximum = step.zero(rate, {left.time, l.rate}, {right.time, r.rate});
      BasicMaximum<S> next{kinds[i], bound, start};
      next.at.time_s = min(until_s, S(start.time_s + maximum.time));
      next.at.state = phase.chart.state(maximum.x);
      const auto later =
          std::upper_bound(found.begin(), found.end(), next,
                           [](const auto& a, const auto& b) { return a.at.time_s < b.at.time_s; });
      found.insert(later, next);
    }
    left = right;
  }
  for (const BasicMaximum<S>& maximum : found) {
    const S& time_s = maximum.at.time_s;
    if (maximum.bound > observer.threshold(maximum.of, time_s, time_s))  // the last may raise it
      observer.on_maximum(maximum);
  }
}

/// Shows an observer what it wants to see of a step from an instant to a time.
template <class S, class Step>
void show_step(Step& step, const BasicInstant<S>& start, const S& until_s,
               BasicObserver<S>& observer) {
  show_maxima(step, start, until_s, observer);
  if (observer.wants_dense_output(start.time_s, until_s))
    observer.on_step(DenseOutputOf<S, Step>(start, until_s, step));
}

}  // namespace rotor
