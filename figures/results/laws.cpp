#include "figures/results/laws.hpp"

#include "figures/input/names.hpp"
#include "figures/results/run_result.hpp"
#include "model/theory/accident.hpp"

namespace rotor {
namespace {

/// The closed forms for a rotor, and what they say of its outcome.
struct Prediction {
  double speed;  ///< at the mass loss, rad/s
  Accident law;
  bool rolls;
};

double speed_at_loss(const Scenario& scenario) {
  if (scenario.mass_loss_speed_Hz > 0) return two_pi * scenario.mass_loss_speed_Hz;
  const Parameters& p = scenario.parameters;
  const double start = two_pi * scenario.start_speed_Hz;
  const double off = two_pi * p.motor_off_Hz;
  return std::max(start, std::min(off, start + p.torque / p.inertia * p.mass_loss_time));
}

Prediction prediction_of(const Scenario& scenario) {
  const double speed = speed_at_loss(scenario);
  const Accident law(scenario.parameters, scenario.equations, speed);
  const double friction = scenario.parameters.friction;
  return {speed, law,
          law.rolling_speed && friction > *law.whirl_friction && friction > law.forward_friction};
}

/// Below this share of the unbalance (3) and (4) hold to 10 % for about nine of ten rotors.
constexpr double trusted_share = 0.1;

struct Law {
  std::string_view key, meaning;
  Json (*of)(const Prediction& predicted);
};

Json json_of(const std::optional<double>& value, double unit = 1) {
  return value && std::isfinite(*value) ? Json(*value / unit) : Json();
}

const std::vector<Law>& all_laws() {
  using P = Prediction;
  static const std::vector<Law> all = {
      {"law_outcome", "no_contact, rolling (above both frictions below), or undecided",
       [](const P& p) {
         return Json(name_of(!p.law.contact_s ? Outcome::no_contact
                             : p.rolls        ? Outcome::rolling
                                              : Outcome::undecided));
       }},
      {"law_speed_at_loss_Hz", "rotation speed at the mass loss, for a motor without resistance",
       [](const P& p) { return json_of(p.speed, two_pi); }},
      {"law_contact_speed_Hz",
       "speed above which an overcritical rotor touches the ring, null if below the critical one; "
       "(1)",
       [](const P& p) { return json_of(p.law.contact_speed, two_pi); }},
      {"law_reach_m", "largest displacement without a ring",
       [](const P& p) { return json_of(p.law.reach); }},
      {"law_contact_after_loss_s", "first contact, after the mass loss",
       [](const P& p) { return json_of(p.law.contact_s); }},
      {"law_impact_force_N", "largest normal force of the first contact",
       [](const P& p) { return json_of(p.law.impact_force); }},
      {"law_whirl_friction", "friction above which rebounds lead to backward whirl; (2)",
       [](const P& p) { return json_of(p.law.whirl_friction); }},
      {"law_forward_friction", "friction up to which forward rub can last; null: up to any",
       [](const P& p) { return json_of(p.law.forward_friction); }},
      {"law_rolling_speed_Hz", "rotation speed at the onset of rolling, if the rotor rolls; (3)",
       [](const P& p) { return json_of(p.law.rolling_speed, two_pi); }},
      {"law_whirl_frequency_Hz",
       "whirl frequency at the onset of rolling, negative against the rotation",
       [](const P& p) { return json_of(p.law.whirl_rate, -two_pi); }},
      {"law_peak_force_N", "largest normal force, if the rotor rolls; (4)",
       [](const P& p) { return json_of(p.law.peak_force()); }},
      {"law_unbalance_share",
       "moment of the unbalance over that of friction; neglected by (3), (4)",
       [](const P& p) { return json_of(p.law.unbalance_share); }},
      {"law_trusted", "no contact, or rolling with a small unbalance share", [](const P& p) {
         return Json(!p.law.contact_s || (p.rolls && *p.law.unbalance_share < trusted_share));
       }}};
  return all;
}

}  // namespace

Json laws(const Scenario& scenario) {
  if (!scenario.parameters.loses_mass) throw InputError("the closed forms need a mass loss");
  const Prediction predicted = prediction_of(scenario);
  Json json;
  for (const Law& law : all_laws()) json[std::string(law.key)] = law.of(predicted);
  return json;
}

Json laws_or_nulls(const Scenario& scenario) {
  if (scenario.parameters.loses_mass) {
    try {
      return laws(scenario);
    } catch (const std::domain_error&) {  // supports that do not vibrate
    }
  }
  Json nulls;
  for (const Law& law : all_laws()) nulls[std::string(law.key)] = nullptr;
  return nulls;
}

std::vector<std::string> remarks_on_laws(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  const Prediction predicted = prediction_of(scenario);
  const double force = predicted.rolls ? *predicted.law.rolling_force : 0;
  std::vector<std::string> all = remarks_on_indentation(force / p.contact_stiffness, p);
  const double critical = std::sqrt(p.support_stiffness / p.mass);
  const bool runs_up = two_pi * scenario.start_speed_Hz < critical && critical < predicted.speed;
  const double displacement = run_up_displacement(p);
  if (runs_up && displacement > p.stator_radius - p.rotor_radius)
    all.push_back(fmt::format(
        "in the run-up the displacement is at most about {:.2g} m, and the clearance is "
        "less; the closed forms hold for rotors that have not touched the ring before",
        displacement));
  return all;
}

std::string meanings_of_laws() {
  std::string lines;
  for (const Law& law : all_laws()) lines += fmt::format("  {:<25} {}\n", law.key, law.meaning);
  return lines;
}

}  // namespace rotor
