#include "figures/results/laws.hpp"

#include "figures/input/names.hpp"
#include "model/theory/accident.hpp"

namespace rotor {
namespace {

double speed_at_loss(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  const double start = two_pi * scenario.start_speed_Hz;
  const double off = two_pi * p.motor_off_Hz;
  return std::max(start, std::min(off, start + p.torque / p.inertia * p.mass_loss_time));
}

/// Below this share of the unbalance (3) and (4) hold to 10 % for about nine of ten rotors.
constexpr double trusted_share = 0.1;

}  // namespace

Json laws(const Scenario& scenario) {
  if (!scenario.parameters.loses_mass) throw InputError("the closed forms need a mass loss");
  const double speed = speed_at_loss(scenario);
  const Accident law(scenario.parameters, scenario.equations, speed);
  Json json;
  const auto put = [&json](const char* key, const std::optional<double>& value, double unit = 1) {
    if (value && std::isfinite(*value))
      json[key] = *value / unit;
    else
      json[key] = nullptr;
  };
  const double friction = scenario.parameters.friction;
  const bool rolls =
      law.rolling_speed && friction > *law.whirl_friction && friction > law.forward_friction;
  json["law_outcome"] = name_of(!law.contact_s ? Outcome::no_contact
                                : rolls        ? Outcome::rolling
                                               : Outcome::undecided);
  put("law_speed_at_loss_Hz", speed, two_pi);
  put("law_contact_speed_Hz", law.contact_speed, two_pi);
  put("law_reach_m", law.reach);
  put("law_contact_after_loss_s", law.contact_s);
  put("law_impact_force_N", law.impact_force);
  put("law_whirl_friction", law.whirl_friction);
  put("law_forward_friction", law.forward_friction);
  put("law_rolling_speed_Hz", law.rolling_speed, two_pi);
  put("law_whirl_frequency_Hz", law.whirl_rate, two_pi);
  put("law_peak_force_N", law.peak_force());
  put("law_unbalance_share", law.unbalance_share);
  json["law_trusted"] = !law.contact_s || (rolls && *law.unbalance_share < trusted_share);
  return json;
}

}  // namespace rotor
