/// Shows an observer what it wants to see of a step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/integration/maxima.hpp"
#include "model/phases/phase.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// The number of arcs into which to divide a step, so that each is curved like a cubic.
template <class Phase, class S>
long arcs(const Phase& phase, const typename Phase::Unknowns& x, const S& duration) {
  return 1 + static_cast<long>(phase.phase_swing(x, duration));
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

/// Shows an observer those of some maxima that exceed its thresholds, in order.
template <class S>
void show_in_order(std::vector<BasicMaximum<S>> found, BasicObserver<S>& observer) {
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.at.time_s < b.at.time_s; });
  for (const BasicMaximum<S>& maximum : found) {
    const S& time_s = maximum.at.time_s;
    if (maximum.value > observer.threshold(maximum.of, time_s, time_s))  // the last may raise it
      observer.on_maximum(maximum);
  }
}

/// The maxima of a step that an observer wants to see, in order.
template <class S, class Step>
void show_maxima(Step& step, const BasicInstant<S>& start, const S& until_s,
                 BasicObserver<S>& observer) {
  const auto& phase = step.system().phase();
  const S duration = until_s - start.time_s;
  const auto threshold = [&](Extreme of, const S& from, const S& until) {
    return observer.threshold(of, start.time_s + from, start.time_s + until);
  };
  using Phase = std::remove_cvref_t<decltype(phase)>;
  constexpr auto& kinds = Phase::extremes_of;
  std::array<bool, kinds.size()> may_exceed;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    may_exceed[i] = step.bounds().upper_bounds[i] > threshold(kinds[i], S(0), duration);
  if (std::none_of(may_exceed.begin(), may_exceed.end(), [](bool may) { return may; })) return;

  const auto at = [&](const S& time) {
    // Near the ends along the tangents: many steps then need no dense output.
    for (const auto* end : {&step.start(), &step.stop()})
      if (const S by = time - end->time; by >= 0 && by <= step.look_ahead()) {
        const auto x = end->ahead(by);
        auto rates = end->rates;
        if (by > 0 && Phase::extremes_take_rates) step.system()(x, rates, S(0));
        return phase.extremes(x, rates);
      }
    const auto& curve = step.dense_output();
    if constexpr (Phase::extremes_take_rates)
      return phase.extremes(curve(time), curve.rates(time));
    else
      return phase.extremes(curve(time), {});
  };
  const DenseOutputOf<S, Step> motion(start, until_s, step);
  std::vector<BasicMaximum<S>> found;
  S from(0);
  auto left = phase.extremes(step.start().x, step.start().rates);
  for (long n = 1; n <= motion.arcs; ++n) {
    const bool last = n == motion.arcs;
    const S until = last ? duration : duration * S(n) / S(motion.arcs);
    const auto right = last ? phase.extremes(step.stop().x, step.stop().rates) : at(until);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (!may_exceed[i]) continue;
      const auto sample = [i](const S& time, const auto& extremes) -> ValueAndSlope<S> {
        return {time, extremes[i].square, extremes[i].rate};
      };
      const auto f = [&](const S& time) { return sample(time, at(time)); };
      const auto add = [&](const ValueAndSlope<S>& top) {
        using std::min, std::sqrt;
        found.push_back(
            {kinds[i], sqrt(top.value), motion.at(min(until_s, S(start.time_s + top.time)))});
      };
      const S least = threshold(kinds[i], from, until);
      MaximaSearch(least * least, step.look_ahead(), f, add)(sample(from, left),
                                                             sample(until, right));
    }
    from = until;
    left = right;
  }
  show_in_order(std::move(found), observer);
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
