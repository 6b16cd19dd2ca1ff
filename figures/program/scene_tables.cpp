#include "figures/program/commands.hpp"
#include "figures/results/run_result.hpp"

namespace rotor {
namespace {

/// Limit for all curves together: more rows make a black picture of hundreds of megabytes.
constexpr long most_rows = 2'000'000;

}  // namespace

std::map<int, SceneData> compute(const std::map<int, Scene>& scenes) {
  std::map<int, SceneData> data;
  long rows = 0;
  RunUps run_ups;
  Interruptible monitor;
  for (const auto& [number, scene] : scenes)
    for (const SceneRun& run : scene.runs) {
      const std::string place = scene.file.string() + ": ";
      if (run.stated.digits)
        throw InputError("{}digits: are not estimated for curves; state a tolerance to draw them",
                         place);
      Table table(scene.columns.size());
      const auto add_row = [&](auto row) {
        if (++rows > most_rows)
          throw InputError(
              "more than {} rows are too many to draw; a shorter window has fewer, and rotor run "
              "--trace writes any number",
              most_rows);
        table.add(row);
      };
      try {
        Recorder recorder(scene.window, scene.columns, run.scenario, sampling, add_row);
        ObserverGroup observers = {&monitor, &recorder};
        const double latest_s = scene.window.from_rolling_onset
                                    ? std::numeric_limits<double>::infinity()
                                    : scene.window.from_s;
        RunUpCheckpoint run_so_far = run_ups.checkpoint_before(run.scenario, monitor, latest_s);
        data[number].results.push_back(
            finish(std::move(run_so_far), run.scenario, std::nullopt, observers).summary);
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(place + run.name + ": " + error.what());
      }
      if (is_interrupted()) throw Interrupted();
      if (table.rows() == 0)
        throw InputError("{}no part of the run \"{}\" lies in the window", place, run.name);
      data[number].curves.push_back({run.name, thinned(table, thinning - sampling)});
    }
  return data;
}

}  // namespace rotor
