#include "figures/results/scene_data.hpp"

#include <algorithm>
#include <deque>

#include "figures/results/run_result.hpp"

namespace rotor {
namespace {

/// Limit for all curves together: more rows make a black picture of hundreds of megabytes.
constexpr long most_rows = 2'000'000;

/// A run, and what it records for the scenes that need it.
struct Job {
  Scenario scenario;
  std::string name;
  ObserverGroup recorders{};
  double from_s = std::numeric_limits<double>::infinity();  ///< from which it is recorded
  Summary summary{};
};

}  // namespace

std::map<int, SceneData> compute_data(const std::map<int, Scene>& scenes) {
  long rows = 0;
  std::deque<Table> tables;  // of each run of a scene, in their order
  std::deque<Recorder> recorders;
  std::deque<Job> jobs;
  std::vector<const Job*> job_of;
  for (const auto& [number, scene] : scenes)
    for (const SceneRun& run : scene.runs) {
      const std::string place = scene.file.string() + ": ";
      if (run.stated.digits)
        throw InputError("{}digits: are not estimated for curves; state a tolerance to draw them",
                         place);
      Table& table = tables.emplace_back(scene.columns.size());
      const auto add_row = [&table, &rows](auto row) {
        if (++rows > most_rows)
          throw InputError(
              "more than {} rows are too many to draw; a shorter window has fewer, and rotor run "
              "--trace writes any number",
              most_rows);
        table.add(row);
      };
      const auto same = std::find_if(jobs.begin(), jobs.end(),
                                     [&](const Job& job) { return job.scenario == run.scenario; });
      Job& job =
          same != jobs.end() ? *same : jobs.emplace_back(Job{run.scenario, place + run.name});
      job.recorders.add(
          recorders.emplace_back(scene.window, scene.columns, run.scenario, sampling, add_row));
      if (!scene.window.from_rolling_onset) job.from_s = std::min(job.from_s, scene.window.from_s);
      job_of.push_back(&job);
    }
  RunUps run_ups;
  Interruptible monitor;
  for (Job& job : jobs) {
    try {
      ObserverGroup observers = {&monitor, &job.recorders};
      job.summary = complete_run(run_ups.checkpoint_before(job.scenario, monitor, job.from_s),
                                 job.scenario, std::nullopt, observers)
                        .summary;
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(job.name + ": " + error.what());
    }
    if (is_interrupted()) throw Interrupted();
  }
  std::map<int, SceneData> data;
  std::size_t n = 0;
  for (const auto& [number, scene] : scenes)
    for (const SceneRun& run : scene.runs) {
      if (tables[n].rows() == 0)
        throw InputError("{}: no part of the run \"{}\" lies in the window{}", scene.file.string(),
                         run.name, scene.window.from_rolling_onset ? ": it does not roll" : "");
      data[number].curves.push_back({run.name, thinned(tables[n], thinning - sampling)});
      data[number].results.push_back(job_of[n++]->summary);
    }
  return data;
}

}  // namespace rotor
