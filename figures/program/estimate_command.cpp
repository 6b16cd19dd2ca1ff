#include "figures/program/commands.hpp"
#include "figures/results/json.hpp"
#include "figures/results/laws.hpp"
#include "figures/results/remarks.hpp"

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
      for (const char* replaced : {"start_speed_Hz", "start_speed_rpm", "mass_loss_time"})
        numbers.erase(replaced);
      numbers.emplace("start_speed_" + unit, at_loss.mapped());
      at_loss_speed.stated.loses_mass = true;
    }
  auto runs = Json::array();
  std::vector<std::string> failures;
  bool in_rpm = false;
  RunUps none;
  const Scene scene = scene_of(at_loss_speed, none);
  const bool one_of_many = scene.runs.size() > 1;
  for (const SceneRun& run : scene.runs) {
    Json row;
    if (one_of_many) row["run"] = run.name;
    try {
      row.update(laws(run.scenario));
    } catch (const std::exception& error) {  // the other runs are not affected
      failures.push_back(fmt::format("{}{}{}", options.scene.empty() ? "" : options.scene + ": ",
                                     one_of_many ? run.name + ": " : "", error.what()));
      continue;
    }
    row["remarks"] = Json::array();
    for (const Remark& remark : remarks_on_rotor(run.scenario, row["law_speed_at_loss_Hz"]))
      row["remarks"].push_back(
          (options.json ? remark.message : as_stated(remark.message, run.stated)).text());
    row["equations"] = name_of(run.scenario.equations);
    in_rpm = in_rpm || run.stated.states_rpm();
    runs.push_back(row);
  }
  if (options.json && !runs.empty())
    fmt::print("{}\n", (one_of_many ? Json{{"runs", runs}} : runs.front()).dump(2));
  else if (options.all)
    for (const Json& row : runs) print_all(row, stdout);
  else if (!runs.empty())
    print_laws(runs, in_rpm, stdout);
  if (!runs.empty()) say_what_is_assumed(scene);
  report_failures(failures);
}

}  // namespace rotor
