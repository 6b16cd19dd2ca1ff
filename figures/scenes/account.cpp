#include "figures/scenes/account.hpp"

#include <fmt/format.h>

#include <cmath>

#include "figures/scenes/audience.hpp"
#include "figures/scenes/names.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

constexpr int schema = 2;  // 1 had neither outcome nor parameters

double critical_speed_Hz(const Parameters& p) {
  return in_Hz(std::sqrt(p.support_stiffness / p.mass));
}

}  // namespace

Account finish(Departure way, const Scenario& scenario, std::optional<StopOn> stop_on,
               Observer& others) {
  Simulation& simulation = way.simulation;
  SummaryObserver& summary = way.summary;
  Audience audience;
  audience.add(others);
  std::optional<StopObserver> stop;
  if (stop_on) audience.add(stop.emplace(*stop_on, scenario));
  audience.on_instant(simulation.instant());
  audience.add(summary);  // which has seen it
  if (!simulation.stopped()) simulation.finish(audience);
  const RunEnd end{simulation.instant(), simulation.counters(), simulation.stopped()};
  const bool stop_reached = stop && stop->is_reached();
  return {scenario, summary.summary(), end, {stop_on, stop_reached, end.stopped && !stop_reached}};
}

nlohmann::ordered_json to_json(const Account& account) {
  const auto& [scenario, summary, end, early, estimated_error] = account;
  const Parameters& p = scenario.parameters;
  nlohmann::ordered_json json;
  const auto put = [&json](const char* key, const std::optional<double>& value) {
    if (value && std::isfinite(*value))
      json[key] = *value;
    else
      json[key] = nullptr;
  };
  json["outcome"] = name_of(summary.outcome);
  put("first_contact_s", summary.first_contact_s);
  json["collisions"] = summary.collisions;
  put("rolling_onset_s", summary.rolling_onset_s);
  put("rolling_onset_speed_Hz", summary.rolling_onset_speed_Hz);
  put("rolling_onset_force_N", summary.rolling_onset_force_N);
  put("rolling_until_s", summary.rolling_until_s);
  put("peak_normal_force_N", summary.peak_normal_force_N);
  put("peak_time_s", summary.peak_time_s);
  put("max_displacement_m", summary.max_displacement_m);
  json["collisions_before_loss"] = summary.collisions_before_loss;
  put("peak_normal_force_before_loss_N", summary.peak_normal_force_before_loss_N);
  put("max_displacement_before_loss_m", summary.max_displacement_before_loss_m);
  put("contact_time_s", summary.contact_time_s);
  put("peak_bearing_force_N", summary.peak_bearing_force_N);
  put("whirl_frequency_Hz", summary.whirl_frequency_Hz);
  put("whirl_from_s", summary.whirl_from_s);
  put("whirl_until_s", summary.whirl_until_s);
  put("motor_off_s", summary.motor_off_s);
  put("speed_at_separation_Hz", summary.speed_at_separation_Hz);
  const double critical = critical_speed_Hz(p);
  put("speed_ratio_at_separation", summary.speed_at_separation_Hz
                                       ? std::optional(*summary.speed_at_separation_Hz / critical)
                                       : std::nullopt);
  put("final_time_s", end.last.time_s);
  put("final_speed_Hz", summary.final_speed_Hz);
  put("final_kinetic_energy_J", summary.final_kinetic_energy_J);
  put("final_q1_m", summary.final_q1_m);
  put("final_q2_m", summary.final_q2_m);
  put("critical_speed_Hz", critical);
  const MassLoss<double> loss(p);
  put("lost_mass_kg", p.separates ? std::optional(loss.lost_mass) : std::nullopt);
  put("inertia_after_loss_kg_m2", p.separates ? std::optional(loss.after.inertia) : std::nullopt);
  json["mass_loss_reached"] = end.last.separated;
  json["motor_off_reached"] = !end.last.motor_on;
  if (early.stop_on)
    json["stop_on"] = name_of(*early.stop_on);
  else
    json["stop_on"] = nullptr;
  json["stop_reached"] = early.stop_reached;
  json["remarks"] = nlohmann::ordered_json::array();
  for (const Remark& remark : remarks(account)) json["remarks"].push_back(remark.sentence);
  json["right_hand_sides"] = end.counters.right_hand_sides;
  json["contact_evaluations"] = end.counters.contact_evaluations;
  json["steps"] = end.counters.steps;
  json["located_events"] = end.counters.located_events;
  json["equations"] = name_of(scenario.equations);
  json["velocity_jump"] = name_of(scenario.equations.velocity_jump);
  json["gravity_moment"] = name_of(scenario.equations.gravity_moment);
  json["method"] = name_of(scenario.method);
  put("tolerance",
      scenario.method == Method::event ? std::optional(scenario.tolerance) : std::nullopt);
  put("estimated_relative_error", estimated_error);
  nlohmann::ordered_json inputs;
  for (const Quantity& quantity : quantities())
    inputs[std::string(quantity.name)] = quantity.of(scenario);
  inputs["no_separation"] = !p.separates;
  json["inputs"] = inputs;
  json["version"] = ROTOR_VERSION;
  json["schema"] = schema;
  if (early.interrupted) json["cut_short_at_s"] = end.last.time_s;
  return json;
}

nlohmann::ordered_json to_json(const EnergyObserver& energy) {
  const auto of = [](const EnergyBalance& b) -> nlohmann::ordered_json {
    return {{"initial", b.initial},
            {"motor", b.motor},
            {"gravity", b.gravity},
            {"support_damping", b.support_damping},
            {"contact_damping", b.contact_damping},
            {"friction", b.friction},
            {"mass_loss", b.mass_loss},
            {"kinetic", b.kinetic},
            {"support_springs", b.support_springs},
            {"contact_spring", b.contact_spring},
            {"residual", b.residual()}};
  };
  nlohmann::ordered_json json;
  json["until_rolling"] = nullptr;
  if (energy.until_rolling()) json["until_rolling"] = of(*energy.until_rolling());
  json["until_end"] = nullptr;
  if (energy.has_begun()) json["until_end"] = of(energy.balance());
  return json;
}

std::vector<Remark> remarks(const Account& account) {
  constexpr bool missed = true;
  const auto& [scenario, summary, end, early, estimated_error] = account;
  const Parameters& p = scenario.parameters;
  std::vector<Remark> all;
  if (p.separates && !end.last.separated)
    all.push_back({fmt::format("the mass loss at {} s was not reached; the run ends at {} s",
                               p.separation_time, end.last.time_s),
                   missed});
  if (early.stop_on && !early.stop_reached)
    all.push_back({fmt::format("{}, at which the run was to stop, was not reached until {} s",
                               name_of(*early.stop_on), end.last.time_s),
                   missed});
  if (summary.collisions_before_loss > 0 && p.separates)
    all.push_back({fmt::format("the rotor touched the ring {} times before the mass loss",
                               summary.collisions_before_loss)});
  // The contact is linear and the ring round: both want indentations that are small.
  constexpr double large = 0.1;
  const double clearance = p.stator_radius - p.rotor_radius;
  const double displacement =
      std::max(summary.max_displacement_m.value_or(0), summary.max_displacement_before_loss_m);
  for (const auto& [length, name] :
       {std::pair(clearance, "clearance"), std::pair(p.rotor_radius, "rotor's radius")})
    if (displacement - clearance > large * length)
      all.push_back(
          {fmt::format("the ring is indented by {:.2g} of the {}: the model's linear "
                       "contact is meant for less",
                       (displacement - clearance) / length, name)});
  return all;
}

}  // namespace rotor
