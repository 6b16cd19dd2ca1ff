#include "figures/program/summary_json.hpp"

#include "figures/scenes/scene.hpp"

namespace rotor {

nlohmann::ordered_json to_json(const Summary& summary, const RunEnd& end,
                               const Scenario& scenario) {
  nlohmann::ordered_json json;
  const auto put = [&json](const char* key, const std::optional<double>& value) {
    if (value)
      json[key] = *value;
    else
      json[key] = nullptr;
  };
  put("first_contact_s", summary.first_contact_s);
  json["collisions"] = summary.collisions;
  put("rolling_onset_s", summary.rolling_onset_s);
  put("rolling_onset_speed_Hz", summary.rolling_onset_speed_Hz);
  put("rolling_onset_force_N", summary.rolling_onset_force_N);
  put("peak_normal_force_N", summary.peak_normal_force_N);
  put("peak_time_s", summary.peak_time_s);
  put("max_displacement_m", summary.max_displacement_m);
  put("motor_off_s", summary.motor_off_s);
  put("speed_at_separation_Hz", summary.speed_at_separation_Hz);
  put("final_speed_Hz", summary.final_speed_Hz);
  put("final_kinetic_energy_J", summary.final_kinetic_energy_J);
  put("final_q1_m", summary.final_q1_m);
  put("final_q2_m", summary.final_q2_m);
  json["right_hand_sides"] = end.counters.right_hand_sides;
  json["contact_evaluations"] = end.counters.contact_evaluations;
  json["steps"] = end.counters.steps;
  json["located_events"] = end.counters.located_events;
  json["equations"] = name_of(scenario.equations);
  json["velocity_jump"] = name_of(scenario.equations.velocity_jump);
  json["gravity_moment"] = name_of(scenario.equations.gravity_moment);
  json["method"] = name_of(scenario.method);
  if (scenario.method == Method::event)
    json["tolerance"] = scenario.tolerance;
  else
    json["tolerance"] = nullptr;
  if (end.stopped) json["cut_short_at_s"] = end.last.time_s;
  return json;
}

}  // namespace rotor
