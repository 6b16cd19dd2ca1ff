#include "verification/report/engine/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "figures/record/columns.hpp"
#include "figures/results/event_log.hpp"
#include "figures/results/run_result.hpp"

namespace rotor {
namespace {

/// The time before the mass loss that a picture shows by default, s.
constexpr double shown_before_loss_s = 0.02;

constexpr std::array works = {"time_s",          "motor",    "gravity",  "support_damping",
                              "contact_damping", "friction", "mass_loss"};

/// Limits of a page's memory.
constexpr std::size_t most_rows = 1'000'000;

/// Throws InputError if there are too many rows.
void require_room(std::size_t rows) {
  if (rows == most_rows)
    throw InputError("--from, --until: the trace would have more than {} rows; show a shorter part",
                     most_rows);
}

/// Lists the works after each step in the window. To be added after the observer of the energy.
class WorkLog : public Observer {
 public:
  WorkLog(const EnergyObserver& energy, double from_s) : energy_(energy), from_s_(from_s) {}

  void on_instant(const Instant& at) override { add(at.time_s); }
  bool should_continue(const Progress& now) override { return add(now.time_s), true; }

  Table table{works.size()};

 private:
  void add(double time_s) {
    if (time_s < from_s_) return;
    const EnergyBalance& b = energy_.balance();
    require_room(table.rows());
    table.add(std::array{time_s, b.motor, b.gravity, b.support_damping, b.contact_damping,
                         b.friction, b.mass_loss});
  }

  const EnergyObserver& energy_;
  double from_s_;
};

/// What can be seen of a run.
const std::vector<const Column*>& columns_of_picture() {
  static const auto all = parse_columns(
      {"time_s", "normal_force_N", "friction_force_N", "speed_Hz", "x_a_m", "y_a_m", "q3_rad",
       "contact_state", "kinetic_energy_J", "support_energy_J", "contact_energy_J"});
  return all;
}

/// Start of the trace. Throws InputError.
double beginning(const Settings& settings, const Scenario& scenario) {
  if (settings.from_s) return stated_window({}, settings.from_s, {}, {{"run", scenario}}).from_s;
  const double loss_s = scenario.parameters.mass_loss_time;
  return scenario.loses_mass() ? std::max(0., loss_s - shown_before_loss_s) : 0;
}

}  // namespace

Picture Explorer::run(const Options& options, Observer& monitor, double closeness) {
  const Settings settings = settings_of(options);
  const Scenario scenario = scenario_of(settings.spec, run_ups_);
  const double from_s = beginning(settings, scenario);
  const auto& columns = columns_of_picture();
  Picture picture{{}, Table(columns.size()), Table(works.size())};
  Recorder motion({.from_s = from_s}, columns, scenario, closeness, [&](auto row) {
    require_room(picture.motion.rows());
    picture.motion.add(row);
  });
  auto happened = Json::array();
  EventLog events(scenario, [&](std::string_view event, auto row) {
    Json& entry = happened.emplace_back();
    entry["event"] = event;
    for (std::size_t i = 0; i < row.size(); ++i) entry[EventLog::columns()[i]->name] = row[i];
  });
  EnergyObserver energy(scenario);
  WorkLog work_log(energy, from_s);
  const bool knows_energy = scenario.method == Method::event;  // the motion between its steps
  ObserverGroup observers = {&monitor, &motion, &events};
  if (knows_energy) {
    observers.add(energy);
    observers.add(work_log);
  }

  const RunResult result = finish(run_ups_.checkpoint_before(scenario, monitor, from_s), scenario,
                                  std::nullopt, observers);
  if (result.early.interrupted) throw Interrupted();
  picture.works = work_log.table;
  picture.metadata["summary"] = to_json(result);
  if (knows_energy) picture.metadata["summary"]["energy_J"] = to_json(energy);
  picture.metadata["events"] = happened;
  picture.metadata["from_s"] = from_s;
  picture.metadata["until_s"] = scenario.until;
  picture.metadata["mass_loss_s"] = nullptr;
  if (scenario.loses_mass()) picture.metadata["mass_loss_s"] = scenario.parameters.mass_loss_time;
  for (const Column* column : columns) picture.metadata["motion"].push_back(column->name);
  picture.metadata["works"] = works;
  return picture;
}

Json Explorer::describe_numbers() {
  auto all = Json::array();
  for (const auto& [quantity, instead_of] : input_quantities()) {
    Json& entry = all.emplace_back();
    entry["name"] = quantity.name;
    entry["symbol"] = quantity.symbol;
    entry["unit"] = quantity.unit;
    entry["meaning"] = quantity.meaning;
    entry["paper"] = nullptr;
    if (quantity.in) entry["paper"] = quantity.of(Scenario{});
  }
  return all;
}

}  // namespace rotor
