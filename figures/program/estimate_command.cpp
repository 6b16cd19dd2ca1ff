#include "figures/program/commands.hpp"
#include "figures/results/json.hpp"
#include "figures/results/laws.hpp"

namespace rotor {

Scene scene_of(const CaseOptions& options, RunUps& run_ups) {
  if (options.scene.empty()) {
    const std::vector<SceneRun> runs = {
        {"run", scenario_of(options.stated, run_ups), options.stated}};
    return {.title = "", .window = window_about_loss(runs), .columns = {}, .runs = runs};
  }
  return read_scene(options.scene,
                    {.of_parameters = {}, .of_runs = options.stated, .run = options.run_name},
                    run_ups);
}

void estimate_rotor(const CaseOptions& options) {
  if (options.stated.loses_mass == false)
    throw InputError("--no-mass-loss: the closed forms need a mass loss");
  CaseOptions at_loss_speed = options;
  auto& numbers = at_loss_speed.stated.numbers;
  for (const std::string unit : {"hz", "rpm"})
    if (auto at_loss = numbers.extract("mass_loss_speed_" + unit)) {  // reached without a run-up
      for (const char* replaced : {"start_speed_hz", "start_speed_rpm", "mass_loss_time"})
        numbers.erase(replaced);
      numbers.emplace("start_speed_" + unit, at_loss.mapped());
      at_loss_speed.stated.loses_mass = true;
    }
  auto runs = Json::array();
  std::vector<std::string> failures;
  RunUps none;
  const Scene scene = scene_of(at_loss_speed, none);
  for (const SceneRun& run : scene.runs) {
    Json row;
    const bool one_of_many = scene.runs.size() > 1;
    const std::string of_run = one_of_many ? run.name + ": " : "";
    if (one_of_many) row["run"] = run.name;
    try {
      row.update(laws(run.scenario));
    } catch (const std::exception& error) {  // the other runs are not affected
      failures.push_back(fmt::format("{}{}{}", options.scene.empty() ? "" : options.scene + ": ",
                                     of_run, error.what()));
      continue;
    }
    row["equations"] = name_of(run.scenario.equations);
    runs.push_back(row);
    for (const Remark& remark : remarks_on_laws(run.scenario))
      print_message("rotor: " + of_run + remark.sentence);
  }
  if (options.json && !runs.empty())
    fmt::print("{}\n", (scene.runs.size() == 1 ? runs.front() : Json{{"runs", runs}}).dump(2));
  for (const Json& row : runs)
    if (!options.json) print_all(row, stdout);
  if (!runs.empty()) say_what_is_assumed(scene.runs);
  report_failures(failures);
}

}  // namespace rotor
