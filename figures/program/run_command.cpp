#include <fmt/format.h>
#include <fmt/ranges.h>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/summary_json.hpp"
#include "figures/scenes/audience.hpp"
#include "figures/scenes/event_log.hpp"
#include "figures/scenes/provenance.hpp"
#include "figures/scenes/recorder.hpp"
#include "figures/scenes/scene.hpp"
#include "model/simulation/simulation.hpp"

namespace rotor {
namespace {

/// The scene with the one run that is asked for.
Scene scene_of(const RunOptions& options) {
  if (options.scene.empty())
    return {.title = "", .window = {}, .columns = {}, .runs = {{"run", {}}}};
  Scene scene = read_scene(options.scene);
  for (const SceneRun& run : scene.runs)
    if (run.name == options.run_name || (options.run_name.empty() && scene.runs.size() == 1)) {
      scene.runs = {SceneRun(run)};
      return scene;
    }
  std::vector<std::string> names;
  for (const SceneRun& run : scene.runs) names.push_back(run.name);
  throw InputError(fmt::format("{}: choose one of its runs with --run: {}", options.scene,
                               fmt::join(names, ", ")));
}

/// The same, with what the options state beside it.
Scene requested_scene(const RunOptions& options) {
  Scene result = scene_of(options);
  Scenario& scenario = result.runs.front().scenario;
  for (const auto& [quantity, value] : options.numbers) quantity->in(scenario) = value;
  if (options.no_separation) scenario.parameters.separates = false;
  options.apply_to(scenario);
  check(scenario);
  if (!options.events.empty() && scenario.method == Method::rk4)
    throw InputError("--events: only --method event locates events");
  if (!options.columns.empty()) result.columns = parse_columns(options.columns);
  if (result.columns.empty())
    for (const Column& column : all_columns()) result.columns.push_back(&column);
  if (options.from_s) {
    if (!(*options.from_s >= 0 && *options.from_s < scenario.until))
      throw InputError(fmt::format("--from {}: must lie inside the run, from 0 s to {} s",
                                   *options.from_s, scenario.until));
    result.window = {.from_s = *options.from_s};
  }
  return result;
}

void print_summary(const nlohmann::ordered_json& summary, bool as_json) {
  if (as_json) {
    fmt::print("{}\n", summary.dump(2));
  } else {
    for (const auto& [key, value] : summary.items())
      fmt::print("{:<24} {}\n", key, value.is_null() ? "-" : value.dump());
  }
}

}  // namespace

void CommonOptions::apply_to(Scenario& scenario) const {
  if (!equations.empty()) scenario.equations = parse_equations(equations);
  if (!method.empty()) scenario.method = parse_method(method);
}

void run_rotor(const RunOptions& options) {
  Scene scene = requested_scene(options);
  const auto& [name, scenario] = scene.runs.front();
  Recorder trace(scene.window, scene.columns, scenario, sampling);
  EventLog events(scenario);
  SummaryObserver summary(scenario);
  Audience audience;
  audience.add(summary);
  if (!options.trace.empty()) audience.add(trace);
  if (!options.events.empty()) audience.add(events);
  const RunEnd end = run(scenario, audience);

  FileTransaction files;
  if (!options.trace.empty() && trace.table().rows() == 0)
    throw InputError(
        fmt::format("--trace {}: nothing of the run lies in the window", options.trace));
  if (!options.trace.empty())
    files.write(options.trace, to_csv(provenance("Trace of a run", scene),
                                      headings("run", scene.columns), {{name, trace.table()}}));
  if (!options.events.empty()) {
    scene.columns = EventLog::columns();
    files.write(options.events, to_csv(provenance("Events of a run", scene),
                                       headings("event", scene.columns), events.tables()));
  }
  files.commit();
  print_summary(to_json(summary.summary(), end.counters, scenario), options.json);
}

}  // namespace rotor
