#include "verification/report/engine/explorer.hpp"

#include <algorithm>

#include "figures/record/columns.hpp"
#include "figures/results/event_log.hpp"
#include "figures/results/run_result.hpp"

namespace rotor {
namespace {

/// The time before the mass loss that a picture shows, s.
constexpr double shown_before_loss_s = 0.02;

/// What can be seen of a run.
const std::vector<const Column*>& columns_of_picture() {
  static const auto all = parse_columns({"time_s", "normal_force_N", "friction_force_N", "speed_Hz",
                                         "x_a_m", "y_a_m", "q3_rad", "contact_state"});
  return all;
}

/// Throws InputError.
ScenarioSpec spec_of(const Options& options) {
  ScenarioSpec spec;
  for (const auto& [option, text] : options) {
    std::string name = option;
    std::replace(name.begin(), name.end(), '-', '_');
    if (const InputQuantity* number = find_input_quantity(name))
      state_number(spec, number->quantity, text);
    else if (const NamedInput* choice = find_named_input(name))
      choice->state(spec, text);
    else
      throw InputError("{}: there is no such input", shown(option));
  }
  return spec;
}

}  // namespace

Picture Explorer::run(const Options& options, double closeness) {
  const Scenario scenario = scenario_of(spec_of(options), run_ups_);
  const double loss_s = scenario.parameters.mass_loss_time,
               from_s = std::max(0., loss_s - shown_before_loss_s);
  const auto& columns = columns_of_picture();
  Picture picture{{}, Table(columns.size())};
  Recorder motion({.from_s = from_s}, columns, scenario, closeness,
                  [&](auto row) { picture.motion.add(row); });
  auto happened = Json::array();
  EventLog events(scenario, [&](std::string_view event, auto row) {
    Json& entry = happened.emplace_back();
    entry["event"] = event;
    for (std::size_t i = 0; i < row.size(); ++i) entry[EventLog::columns()[i]->name] = row[i];
  });
  Observer nobody;
  ObserverGroup observers = {&motion, &events};
  const RunResult result = complete_run(run_ups_.checkpoint_before(scenario, nobody, from_s),
                                        scenario, std::nullopt, observers);
  Json& about = picture.metadata;
  about["summary"] = to_json(result);
  about["events"] = happened;
  about["from_s"] = from_s;
  about["until_s"] = scenario.until;
  about["mass_loss_s"] = loss_s;
  for (const Column* column : columns) about["motion"].push_back(column->name);
  return picture;
}

}  // namespace rotor
