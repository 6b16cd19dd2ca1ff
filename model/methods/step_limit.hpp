/// When a run is refused because it takes too many steps, or is bound to.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "model/phases/rotor_system.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// A rate at which a motion changes, and how it follows from the inputs.
template <class S>
struct NamedRate {
  S per_s;
  std::string_view formula;

  bool operator<(const NamedRate& other) const { return per_s < other.per_s; }
  std::string text() const {
    return fmt::format("{:.3g} 1/s = {}", static_cast<double>(per_s), formula);
  }
};

/// At most the fastest rate of the supports' own motion. In contact there is one as fast, because
/// neither a stiffer spring nor another damper leaves less.
template <class S>
NamedRate<S> support_rate(const RotorSystem<S>& rotor) {
  return std::max<NamedRate<S>>(
      {rotor.support_frequency(), "sqrt(support_stiffness / mass)"},
      {rotor.acting.supports.damping / (2 * rotor.body.mass), "support_damping / (2 mass)"});
}

/// The fastest rate of supports, rotation, the weight's moment and, at an indentation, the contact.
template <class S>
NamedRate<S> fastest_rate(const RotorSystem<S>& rotor, const S& speed,
                          const std::optional<S>& indentation) {
  using std::abs, std::max;
  const auto& [mass, inertia, eccentricity] = rotor.body;
  const NamedRate<S> in_flight =
      std::max({support_rate(rotor),
                {abs(speed), "2 pi times the rotation speed"},
                {natural_frequency(S(mass * rotor.acting.weight.gravity * eccentricity), inertia),
                 "sqrt(mass gravity eccentricity / inertia)"}});
  if (!indentation) return in_flight;
  const Ring<S>& ring = rotor.ring;
  const S stiffness = max(ring.typical_stiffness(), ring.law.tangent_stiffness(*indentation));
  return std::max({in_flight,
                   {natural_frequency(stiffness, mass), "sqrt(contact_stiffness / mass)"},
                   {ring.law.damping() / (2 * mass), "contact_damping / (2 mass)"}});
}

/// Looks now and then at what a run's steps have achieved.
template <class S>
class StepLimit {
 public:
  /// Over the fastest rate, the greatest step that does not make a decaying motion grow: of the
  /// stepper Verner87 5.86.
  static constexpr double longest_stable = 6;

  explicit StepLimit(const S& tolerance) : tolerance_(tolerance) {}

  struct Position {
    S now_s, until_s;
    S speed;                       ///< rad/s
    std::optional<S> indentation;  ///< m, unless the rotor is clear of the ring
  };

  /// Why a step failed that is as short as the rounding of the time.
  std::string at_rounding(const RotorSystem<S>& rotor, const Position& at, bool is_finite) const {
    if (!is_finite) return "the motion is not finite, however short the step; " + cause(rotor, at);
    return fmt::format(
        "no step is short enough: times are rounded to {:.2g} s then; {}; tolerance = {}",
        static_cast<double>(at.now_s * std::numeric_limits<S>::epsilon()), cause(rotor, at),
        static_cast<double>(tolerance_));
  }

  /// What is wrong, to be called after each step.
  std::optional<std::string> fault(const RotorSystem<S>& rotor, const Counters& counters,
                                   const Position& at, const BasicObserver<S>& observer) {
    if (counters.steps % seldom != 0) return std::nullopt;
    const S progress_s = at.now_s - looked_at_s_;
    std::optional<std::string> found;
    if (counters.steps > most)
      found = fmt::format("{} steps have been taken, which is more than any run should need; {}",
                          most, cause(rotor, at));
    else if (!observer.may_stop_early())
      found = hopeless(rotor, counters, at);
    if (!found && progress_s < least_progress * (at.until_s - at.now_s))
      found =
          fmt::format("it makes no progress: the last {} steps took it only {:.3g} s further; {}",
                      seldom, static_cast<double>(progress_s), cause(rotor, at));
    looked_at_s_ = at.now_s;
    events_ = counters.located_events;
    return found;
  }

 private:
  static std::string cause(const RotorSystem<S>& rotor, const Position& at) {
    return "of its supports, rotation and contact the fastest rate is " +
           fastest_rate(rotor, at.speed, at.indentation).text();
  }

  static constexpr long most = 20'000'000;  // exceeded only if something is wrong
  static constexpr long seldom = 1L << 12;  // a hundredth of a second's work in double precision
  /// Of the remaining time, in that many steps: a run with this pace would take 10^13 of them.
  static constexpr double least_progress = seldom / 1e13;
  /// Over the fastest rate, a mean step with an error far below rounding. The least over 3,000
  /// random rotors with a linear ring is four times as long.
  static constexpr double useless = 0.01;

  /// Why a run that must not stop before its end has no hope of getting there.
  std::optional<std::string> hopeless(const RotorSystem<S>& rotor, const Counters& counters,
                                      const Position& at) const {
    const S left_s = at.until_s - at.now_s;
    const S mean_s = (at.now_s - looked_at_s_) / S(static_cast<double>(seldom));
    const NamedRate<S> slow = support_rate(rotor);
    // If nothing moves the supports, steps are longer than they would allow.
    const bool follows_supports = mean_s * slow.per_s < longest_stable;
    if (follows_supports && left_s * slow.per_s > longest_stable * most)
      return fmt::format(
          "the {:.6g} s to come would take at least {:.2g} steps, and a run takes at most {}: no "
          "step is longer than {:.2g} s, because the supports respond at {}; shorten the run "
          "(until, mass_loss_time) or slow down the supports",
          static_cast<double>(left_s), static_cast<double>(left_s * slow.per_s / longest_stable),
          most, static_cast<double>(longest_stable / slow.per_s), slow.text());
    const bool has_smooth_contact =
        at.indentation && rotor.ring.law.is_linear() && counters.located_events == events_;
    const NamedRate<S> fast = fastest_rate(rotor, at.speed, at.indentation);
    if (has_smooth_contact && mean_s * fast.per_s < useless && left_s > mean_s * most)
      return fmt::format(
          "tolerance = {}, relative to clearance = {:.4g} m, is below the rounding of this motion: "
          "at {:.2g} s a step, the {:.6g} s to come would take {:.2g} steps, and a run takes at "
          "most {}; raise tolerance or clearance",
          static_cast<double>(tolerance_), static_cast<double>(rotor.ring.clearance),
          static_cast<double>(mean_s), static_cast<double>(left_s),
          static_cast<double>(left_s / mean_s), most);
    return std::nullopt;
  }

  S tolerance_;
  S looked_at_s_{0};
  long events_ = 0;  ///< located up to looked_at_s_
};

}  // namespace rotor
