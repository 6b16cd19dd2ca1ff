/// The lowest supercritical speed at which a mass loss leads to contact.
#pragma once

#include <boost/math/tools/roots.hpp>

#include "verification/support/summary_of.hpp"

namespace rotor {

/// In Hz, to 0.005 Hz: the motor drives, and a later loss is at a higher speed.
inline double onset_speed_Hz(const Equations& equations) {
  Scenario scenario{.equations = equations, .tolerance = 1e-8};
  const auto touches = [&](double mass_loss_time) {
    scenario.parameters.mass_loss_time = mass_loss_time;
    scenario.until = mass_loss_time + 0.1;  // the first swing out, a period of the supports
    return summary_of(scenario).first_contact_s.has_value() ? 1. : -1.;
  };
  const auto close = [](double a, double b) { return b - a < 1e-3; };
  const auto [from, until] = boost::math::tools::bisect(touches, 5., 28., close);
  scenario.parameters.mass_loss_time = until;
  scenario.until = until + 1e-3;
  return *summary_of(scenario).speed_at_mass_loss_Hz;
}

}  // namespace rotor
