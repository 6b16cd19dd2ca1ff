/// The real numbers of a run by name, and what their digits are relative to.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "model/results/summary.hpp"

namespace rotor {

template <class S>
struct NamedValue {
  std::string_view name;
  std::optional<S> value;
  S size{0};              ///< least reference of its digits
  bool is_exact = false;  ///< stated, not computed
};

/// A value that is less than the clearance, or a radian, by this factor is negligible: digits are
/// relative to that limit instead.
constexpr long negligible = 1'000'000;

/// Those of a summary.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicSummary<S>& summary, const Parameters& p) {
  const S length = Ring<S>(p).clearance / negligible,
          force = as_typed<S>(p.support_stiffness) * length;
  std::vector<NamedValue<S>> all;
  for (const SummaryField<S>& field : summary_fields<S>) {
    const S size = field.scale == ErrorScale::length  ? length
                   : field.scale == ErrorScale::force ? force
                                                      : S(0);
    const auto add = [&](const std::optional<S>& value) {
      all.push_back({field.key, value, size, field.scale == ErrorScale::exact});
    };
    if (const auto* always = std::get_if<S BasicSummary<S>::*>(&field.value))
      add(summary.**always);
    else if (const auto* perhaps = std::get_if<std::optional<S> BasicSummary<S>::*>(&field.value))
      add(summary.**perhaps);
  }
  return all;
}

/// Time and state. Digits of a vector's components are relative to its length; those of the rates
/// in the rotating axes, which nearly cancel in synchronous motion, to that of the velocity of O.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicInstant<S>& at, const Scenario& scenario) {
  using std::abs, std::max;
  const State<S>& q = at.state;
  const Motion<S> m = at.motion();
  const S least = Ring<S>(scenario.parameters).clearance / negligible, angle = S(1) / negligible;
  const S length = max(least, S(m.displacement.norm()));
  const S velocity = max(S(least * abs(m.speed)), S(m.velocity.norm()));
  const bool is_stated = at.event == Event::none ||  // the end
                         (at.event == Event::mass_loss && !scenario.mass_loss_speed_Hz);
  return {{"time_s", at.time_s, S(0), is_stated},
          {"q1_m", q[0], length},
          {"q2_m", q[1], length},
          {"q3_rad", q[2], angle},
          {"q1_rate_m_per_s", q[3], velocity},
          {"q2_rate_m_per_s", q[4], velocity},
          {"q3_rate_rad_per_s", q[5]}};
}

}  // namespace rotor
