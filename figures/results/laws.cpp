#include "figures/results/laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "figures/input/names.hpp"
#include "model/theory/accident.hpp"

namespace rotor {
namespace {

/// The closed forms for a rotor, what they say of its outcome, and why that may be wrong.
struct Prediction {
  double speed;  ///< at the mass loss, rad/s
  Accident law;
  bool rolls;
  std::vector<std::string> doubts;  ///< empty in the tested region
};

double speed_at_loss(const Scenario& scenario) {
  if (scenario.mass_loss_speed_Hz) return two_pi * *scenario.mass_loss_speed_Hz;
  const Parameters& p = scenario.parameters;
  if (p.drive == Drive::constant_speed) return two_pi * scenario.start_speed_Hz;
  const double start = two_pi * scenario.start_speed_Hz;
  const double off = two_pi * p.motor_off_Hz;
  return std::max(start, std::min(off, start + p.torque / p.inertia * p.mass_loss_time));
}

double ring_damping_ratio(const Parameters& p) {
  const double mass = MassLoss<double>(p).after.mass;
  const auto [stiffness, damping] = Ring<double>(p).law.required_linear();
  return damping / (2 * std::sqrt(stiffness * mass));
}

/// Which conditions of the tested region a rotor does not fulfil. "The tested region" in
/// model/theory/README.md has their reasons.
std::vector<std::string> doubts_about(const Scenario& scenario, double speed, const Accident& law) {
  const Parameters& p = scenario.parameters;
  const Body<double> body = MassLoss<double>(p).after;
  const Ring<double> ring(p);
  std::vector<std::string> doubts;
  const auto above = [&](std::string_view quantity, double value, double limit) {
    if (!(value > limit))
      doubts.push_back(fmt::format("{} is {:.3g}, tested above {:.3g}", quantity, value, limit));
  };
  const auto below = [&](std::string_view quantity, double value, double limit) {
    if (!(value < limit))
      doubts.push_back(fmt::format("{} is {:.3g}, tested below {:.3g}", quantity, value, limit));
  };
  if (p.drive == Drive::constant_speed) doubts.emplace_back("a drive holds the speed");
  if (scenario.start) doubts.emplace_back("the rotor does not start in steady response");
  const double critical = critical_speed(p);
  above("the ratio of the speed at the loss to the critical speed", speed / critical, 1.5);
  if (two_pi * scenario.start_speed_Hz < critical && critical < speed)
    below("the ratio of the displacement in the run-up to the clearance",
          run_up_displacement(p) / ring.clearance, 0.75);
  if (speed > 0 && speed < two_pi * p.motor_off_Hz)
    below("the share of its speed that the motor adds in a natural period",
          p.torque / (body.inertia * speed) * two_pi / critical, 0.06);
  if (!law.contact_s) return doubts;
  const auto [limit, consequence] =
      std::max({std::pair(law.lasting_friction(), "forward rub may last instead"),
                std::pair(*law.whirl_friction, "rebounds may lead to no backward whirl"),
                std::pair(*law.first_friction, "one impact may lead to no backward whirl")});
  if (std::isinf(limit))
    doubts.emplace_back("forward rub can last at any friction");
  else if (!(ring.friction > limit))
    doubts.push_back(
        fmt::format("friction {:.3g} is below {:.3g}, so {}", ring.friction, limit, consequence));
  below("friction", ring.friction, 1);
  above("the ratio of friction to that of dry whip", ring.friction / Whirl(p).whip_friction(), 200);
  below("the ring's damping ratio", ring_damping_ratio(p), 0.1);
  if (law.rolling_force) {
    below("the share of the unbalance", *law.unbalance_share, 0.06);
    below("the ratio of the forces of first contact and rolling",
          *law.impact_force / *law.rolling_force, 0.1);
  } else
    doubts.emplace_back("the closed forms give no rolling for this rotor");
  return doubts;
}

Prediction prediction_of(const Scenario& scenario) {
  const double speed = speed_at_loss(scenario);
  const Accident law(scenario.parameters, scenario.equations, speed);
  const double friction = scenario.parameters.friction;
  return {speed, law,
          law.rolling_speed && friction > *law.whirl_friction && friction > law.lasting_friction(),
          doubts_about(scenario, speed, law)};
}

struct Law {
  std::string_view key, meaning;
  Json (*of)(const Prediction& predicted);
};

const std::vector<Law>& all_laws() {
  using P = Prediction;
  static const std::vector<Law> all = {
      {"law_outcome",
       "no_contact, rolling (law_rolling_speed_Hz exists, and the friction is above "
       "law_whirl_friction and the lesser limit of forward rub), or undecided",
       [](const P& p) {
         return Json(name_of(!p.law.contact_s ? Outcome::no_contact
                             : p.rolls        ? Outcome::rolling
                                              : Outcome::undecided));
       }},
      {"law_speed_at_loss_Hz", "rotation speed at the mass loss, for a motor without resistance",
       [](const P& p) { return json_of(p.speed, two_pi); }},
      {"law_contact_speed_Hz",
       "rough speed from which a rotor well above its critical speed touches the ring, null if "
       "below the critical speed after the loss; (1)",
       [](const P& p) { return json_of(p.law.contact_speed, two_pi); }},
      {"law_reach_m", "largest displacement without a ring, if the speed stays that at the loss",
       [](const P& p) { return json_of(p.law.reach); }},
      {"law_contact_after_loss_s", "first contact, after the mass loss",
       [](const P& p) { return json_of(p.law.contact_s); }},
      {"law_impact_force_N", "largest normal force of the first contact",
       [](const P& p) { return json_of(p.law.impact_force); }},
      {"law_whirl_friction", "friction above which rebounds may lead to backward whirl; (2)",
       [](const P& p) { return json_of(p.law.whirl_friction); }},
      {"law_forward_friction",
       "friction up to which there is forward rub; null: up to any, unless it is unstable",
       [](const P& p) { return json_of(p.law.forward_friction); }},
      {"law_stable_forward_friction",
       "friction up to which forward rub at constant speed returns after a small disturbance; "
       "null: wherever there is forward rub",
       [](const P& p) { return json_of(p.law.stable_forward_friction); }},
      {"law_rolling_speed_Hz", "rotation speed at the onset of rolling, if the rotor rolls; (3)",
       [](const P& p) { return json_of(p.law.rolling_speed, two_pi); }},
      {"law_whirl_frequency_Hz",
       "whirl frequency at the onset of rolling, negative against the rotation",
       [](const P& p) { return json_of(p.law.whirl_rate, -two_pi); }},
      {"law_peak_force_N",
       "largest normal force up to the first maximum in rolling, if the rotor rolls; (4)",
       [](const P& p) { return json_of(p.law.peak_force()); }},
      {"law_unbalance_share", "kappa e_x1/(mu r); neglected by (3), (4)",
       [](const P& p) { return json_of(p.law.unbalance_share); }},
      {"law_trusted",
       "whether the rotor is in the tested region; model/theory/README.md has the share of random "
       "rotors there whose outcome is right, and speed and force within 10 %",
       [](const P& p) { return Json(p.doubts.empty()); }}};
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

std::vector<Remark> remarks_on_laws(const Scenario& scenario) {
  const Prediction predicted = prediction_of(scenario);
  std::vector<Remark> all = remarks_on_rotor(scenario, predicted.speed / two_pi);
  if (!predicted.doubts.empty())
    all.push_back(
        {fmt::format("these numbers may be far off: the rotor is outside the tested region, "
                     "since {}",
                     fmt::join(predicted.doubts, "; "))});
  return all;
}

std::string meanings_of_laws() {
  std::string lines;
  for (const Law& law : all_laws()) lines += fmt::format("  {:<27}  {}\n", law.key, law.meaning);
  return lines;
}

}  // namespace rotor
