#include "verification/report/engine/explorer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "figures/results/event_log.hpp"
#include "figures/results/provenance.hpp"
#include "figures/results/run_result.hpp"

namespace rotor {
namespace {

/// The time before the mass loss that a picture shows by default, s.
constexpr double shown_before_loss_s = 0.02;

/// Runs of a sample need only the printed digits, and coarser curves.
constexpr double tolerance_of_draws = 1e-8, closeness_of_draws = 5e-3;

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
const std::vector<const Column*>& columns_of_draw() {
  static const auto all = parse_columns({"time_s", "normal_force_N", "speed_Hz"});
  return all;
}

/// Start of the trace. Throws InputError.
double beginning(const Settings& settings, const Scenario& scenario) {
  if (settings.from_s) return stated_window({}, settings.from_s, {}, {{"run", scenario}}).from_s;
  const double loss_s = scenario.parameters.mass_loss_time;
  return scenario.loses_mass() ? std::max(0., loss_s - shown_before_loss_s) : 0;
}

Json headings_of(const std::vector<const Column*>& columns) {
  auto names = Json::array();
  for (const Column* column : columns) names.push_back(column->name);
  return names;
}

}  // namespace

Picture Explorer::picture(const Shot& shot, Observer& monitor) {
  const Scenario& scenario = shot.scenario;
  Picture picture{{}, Table(shot.columns.size()), Table(works.size())};
  Recorder motion({.from_s = shot.from_s}, shot.columns, scenario, shot.closeness, [&](auto row) {
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
  WorkLog work_log(energy, shot.from_s);
  const bool knows_energy = scenario.method == Method::event;  // the motion between its steps
  ObserverGroup observers = {&monitor, &motion, &events};
  if (knows_energy) {
    observers.add(energy);
    observers.add(work_log);
  }

  const RunResult result = finish(run_ups_.checkpoint_before(scenario, monitor, shot.from_s),
                                  scenario, std::nullopt, observers);
  if (result.early.interrupted) throw Interrupted();
  picture.works = work_log.table;
  picture.metadata["summary"] = to_json(result);
  if (knows_energy) picture.metadata["summary"]["energy_J"] = to_json(energy);
  picture.metadata["events"] = happened;
  picture.metadata["from_s"] = shot.from_s;
  picture.metadata["until_s"] = scenario.until;
  picture.metadata["mass_loss_s"] = nullptr;
  if (scenario.loses_mass()) picture.metadata["mass_loss_s"] = scenario.parameters.mass_loss_time;
  picture.metadata["motion"] = headings_of(shot.columns);
  picture.metadata["works"] = works;
  return picture;
}

Picture Explorer::run(const Options& options, Observer& monitor, double closeness) {
  const Settings settings = settings_of(options);
  const Scenario scenario = scenario_of(settings.spec, run_ups_);
  return picture({scenario, beginning(settings, scenario), closeness, columns_of_picture()},
                 monitor);
}

Picture Explorer::draw(const Options& options, long n, long count, Observer& monitor) {
  const Settings settings = settings_of(options);
  const Scenario stated = scenario_of(settings.spec, run_ups_);
  const Sweep sweep = over_printed_digits(settings.spec, printed_inputs_, count);
  ScenarioSpec drawn = SweepPoints(sweep)(n).spec;
  drawn.numbers.emplace("tolerance", tolerance_of_draws);
  Scenario scenario = scenario_of(drawn, run_ups_);
  // The same part of the run, relative to its own mass loss.
  const double later_s = stated.loses_mass()
                             ? scenario.parameters.mass_loss_time - stated.parameters.mass_loss_time
                             : 0;
  scenario.until = stated.until + later_s;
  const double from_s = std::max(0., beginning(settings, stated) + later_s);
  Picture result = picture({scenario, from_s, closeness_of_draws, columns_of_draw()}, monitor);
  result.metadata["drawn"] = Json::array();
  for (const Draw& draw : sweep.sample.over)
    result.metadata["drawn"].push_back(
        {{"quantity", draw.quantity}, {"from", draw.a}, {"to", draw.b}});
  return result;
}

std::string Explorer::trace(const Options& options, Observer& monitor) {
  const Settings settings = settings_of(options);
  const Scenario scenario = scenario_of(settings.spec, run_ups_);
  const std::string name = "run";
  const Scene scene{.title = "",
                    .window = {.from_s = beginning(settings, scenario)},
                    .columns = every_column(),
                    .runs = {{name, scenario}}};
  std::string csv = csv_head("Trace of a run", scene, name);
  std::size_t rows = 0;
  Recorder recorder(scene.window, scene.columns, scenario, sampling, [&](auto row) {
    require_room(rows++);
    csv += csv_row(name, row);
  });
  ObserverGroup observers = {&monitor, &recorder};
  const RunResult result =
      finish(run_ups_.checkpoint_before(scenario, monitor, scene.window.from_s), scenario,
             std::nullopt, observers);
  if (result.early.interrupted) throw Interrupted();
  return csv;
}

Json Explorer::describe_numbers() const {
  auto all = Json::array();
  for (const auto& [quantity, instead_of] : input_quantities()) {
    Json& entry = all.emplace_back();
    entry["name"] = quantity.name;
    entry["symbol"] = quantity.symbol;
    entry["unit"] = quantity.unit;
    entry["meaning"] = quantity.meaning;
    entry["paper"] = nullptr;
    if (quantity.in) entry["paper"] = quantity.of(Scenario{});
    for (const CsvRow& row : printed_inputs_)
      if (row["input"] == quantity.name)
        entry["paper"] = static_cast<double>(row.number("printed"));
  }
  return all;
}

}  // namespace rotor
