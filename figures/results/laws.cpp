#include "figures/results/laws.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figures/input/names.hpp"

namespace rotor {
namespace {

double speed_at_loss(const Scenario& scenario) {
  if (const auto speed_Hz = scenario.stated_mass_loss_speed_Hz()) return two_pi * *speed_Hz;
  const Parameters& p = scenario.parameters;
  if (p.drive == Drive::constant_speed) return two_pi * scenario.start_speed_Hz;
  const double start = two_pi * scenario.start_speed_Hz;
  const double off = two_pi * p.motor_off_Hz;
  const double moment = ActingLoads<double>(p, scenario.equations).constant_moment(true);
  return std::max(start, std::min(off, start + moment / p.inertia * p.mass_loss_time));
}

}  // namespace

const std::vector<Law>& all_laws() {
  constexpr std::string_view at_speed = "if the speed stays that at the loss",
                             in_rolling = "if it rolls, and nothing drives it";
  using L = AccidentAtSpeed;
  static const std::vector<Law> all = {
      {"law_contact", "contact", "whether the rotor touches the ring", at_speed,
       [](const L& l) { return Json(l.law.contact_s.has_value()); }},
      {"law_speed_at_loss_Hz", "speed at the mass loss", "rotation speed at the mass loss",
       "if nothing resists the motor", [](const L& l) { return json_of(l.speed, two_pi); }},
      {"law_contact_speed_Hz", "lowest speed with contact",
       "speed from which the rotor touches the ring (1)", "if it turns many times in a swing",
       [](const L& l) { return json_of(l.law.contact_speed, two_pi); }},
      {"law_reach_m", "displacement without a ring", "largest displacement without a ring",
       at_speed, [](const L& l) { return json_of(l.law.reach); }},
      {"law_contact_after_loss_s", "first contact after the loss",
       "first contact, after the mass loss", at_speed,
       [](const L& l) { return json_of(l.law.contact_s); }},
      {"law_impact_force_N", "largest force of this contact",
       "largest normal force of the first contact", at_speed,
       [](const L& l) { return json_of(l.law.impact_force); }},
      {"law_whirl_friction", "least friction, backward whirl",
       "friction above which backward whirl grows (2)", "if rebounds alone drive it",
       [](const L& l) { return json_of(l.law.whirl_friction); }},
      {"law_forward_friction", "largest friction, forward rub",
       "friction up to which there is forward rub", "if the indentation is small",
       [](const L& l) { return json_of(l.law.forward_friction); }, "any"},
      {"law_stable_forward_friction", "largest friction, stable rub",
       "friction up to which forward rub returns after a small disturbance", at_speed,
       [](const L& l) { return json_of(l.law.stable_forward_friction); }, "any"},
      {"law_rolling_speed_Hz", "speed at the onset of rolling",
       "rotation speed at the onset of rolling (3)", in_rolling,
       [](const L& l) { return json_of(l.law.rolling_speed, two_pi); }},
      {"law_whirl_frequency_Hz", "whirl at the onset of rolling",
       "whirl frequency at the onset of rolling, negative against the rotation", in_rolling,
       [](const L& l) { return json_of(l.law.whirl_rate, -two_pi); }},
      {"law_peak_force_N", "largest normal force",
       "largest normal force up to the first maximum in rolling (4)", in_rolling,
       [](const L& l) { return json_of(l.law.peak_force()); }},
      {"law_unbalance_share", "share of the unbalance", "kappa e_x1/(mu r)", "neglected in rolling",
       [](const L& l) { return json_of(l.law.unbalance_share); }}};
  return all;
}

Json laws(const Scenario& scenario) {
  if (!scenario.parameters.loses_mass) throw InputError("the closed forms need a mass loss");
  const double speed = speed_at_loss(scenario);
  const AccidentAtSpeed accident{speed, {scenario.parameters, scenario.equations, speed}};
  Json json;
  for (const Law& law : all_laws()) json[std::string(law.key)] = law.of(accident);
  return json;
}

Json laws_or_nulls(const Scenario& scenario) {
  if (scenario.parameters.loses_mass) {
    try {
      return laws(scenario);
    } catch (const std::domain_error&) {  // such as supports that do not vibrate
    }
  }
  Json nulls;
  for (const Law& law : all_laws()) nulls[std::string(law.key)] = nullptr;
  return nulls;
}

std::string meanings_of_laws() {
  std::string lines;
  for (const Law& law : all_laws())
    lines +=
        fmt::format("  {:<27}  {}, {}{}{}\n", law.key, law.meaning, law.assumption,
                    law.none == no_value ? "" : "; null: ", law.none == no_value ? "" : law.none);
  return lines + std::string(assumption_of_laws);
}

}  // namespace rotor
