/// The speeds at which a mass loss begins, or ceases, to lead to contact.
#pragma once

#include <boost/math/tools/roots.hpp>
#include <limits>
#include <map>

#include "model/mechanics/mass_loss.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/place_of_loss.hpp"
#include "verification/support/refined.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {

/// The speed at a loss in the run-up between two times, of which one leads to contact within
/// `swing_s`. In Hz, to 0.005 Hz: the motor drives, and a later loss is at a higher speed.
inline double border_in_run_up_Hz(const Equations& equations, double from_s, double until_s,
                                  double swing_s) {
  Scenario scenario{.equations = equations, .tolerance = 1e-8};
  const auto touches = [&](double mass_loss_time) {
    scenario.parameters.mass_loss_time = mass_loss_time;
    scenario.until = mass_loss_time + swing_s;
    return summary_of(scenario).first_contact_s.has_value() ? 1. : -1.;
  };
  const auto close = [](double a, double b) { return b - a < 1e-3; };
  const auto [from, until] = boost::math::tools::bisect(touches, from_s, until_s, close);
  scenario.parameters.mass_loss_time = until;
  scenario.until = until + 1e-3;
  return *summary_of(scenario).speed_at_mass_loss_Hz;
}

/// The lowest speed with contact well above resonance, after one period of the supports; and the
/// highest one near resonance, where the swing grows for longer.
inline double onset_speed_Hz(const Equations& equations) {
  return border_in_run_up_Hz(equations, 5, 28, 0.1);
}
inline double near_resonance_Hz(const Equations& equations) {
  return border_in_run_up_Hz(equations, 1.8, 5, 4);
}

/// The lowest speed well above resonance at which the loss of the paper's piece, in steady motion,
/// leads to contact, from a point of the rim at an angle from opposite to the unbalance.
inline double onset_speed_Hz(const Equations& equations, double angle) {
  Scenario scenario{.equations = equations, .until = 0.1, .tolerance = 1e-8};
  scenario.parameters.torque = 0;
  const PlaceOfLoss place(scenario.parameters, angle,
                          MassLoss<double>(scenario.parameters).lost_mass);
  const auto touches = [&](double speed_Hz) {
    scenario.start_speed_Hz = speed_Hz;
    Instant at = place.lose_mass(start_of(scenario), equations);
    at.motor_on = false;
    SummaryObserver summary(scenario);
    follow(scenario, at, scenario.until, summary);
    return summary.summary().touch_downs > 0 ? 1. : -1.;
  };
  const auto close = [](double a, double b) { return b - a < 2e-3; };
  return boost::math::tools::bisect(touches, 40., 140., close).second;
}

/// The least and the greatest one over all points of the rim, to 0.02 %.
struct OnsetSpeeds {
  double least_Hz, greatest_Hz;
};
inline OnsetSpeeds onset_speeds_by_place(const Equations& equations) {
  std::map<double, double> known;
  const auto extreme = [&](double sign) {
    return refined(
        [&](long places) {
          double greatest = -std::numeric_limits<double>::infinity();
          for (long n = 0; n < places; ++n) {
            const double angle = two_pi * static_cast<double>(n) / static_cast<double>(places);
            const auto found = known.find(angle);
            const double speed_Hz =
                found != known.end()
                    ? found->second
                    : known.emplace(angle, onset_speed_Hz(equations, angle)).first->second;
            greatest = std::max(greatest, sign * speed_Hz);
          }
          return sign * greatest;
        },
        24, 2e-4);
  };
  return {extreme(-1), extreme(1)};
}

}  // namespace rotor
