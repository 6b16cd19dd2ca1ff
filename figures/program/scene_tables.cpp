#include <deque>

#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"
#include "figures/runs/production.hpp"

namespace rotor {
namespace {

/// Limit for all curves together: more rows make a black picture of hundreds of megabytes.
constexpr long most_rows = 2'000'000;

}  // namespace

std::map<int, SceneData> compute(const std::map<int, Scene>& scenes) {
  std::map<int, SceneData> data;
  long rows = 0;
  std::deque<Recorder> recorders;
  std::deque<SummaryObserver> summaries;
  std::deque<ObserverGroup> observers;
  std::vector<Request> requests;
  for (const auto& [number, scene] : scenes) {
    auto& own = data[number].curves;
    own.reserve(scene.runs.size());  // the recorders refer to them
    for (const SceneRun& run : scene.runs) {
      if (run.stated.digits)
        throw InputError("{}: digits: are not estimated for curves; state a tolerance to draw them",
                         scene.file.string());
      const Scenario& scenario = run.scenario;
      Table& table = own.emplace_back(NamedTable{run.name, Table(scene.columns.size())}).table;
      const auto add_row = [&table, &rows](auto row) {
        if (++rows > most_rows)
          throw InputError(
              "more than {} rows are too many to draw; a shorter window has fewer, and rotor run "
              "--trace writes any number",
              most_rows);
        table.add(row);
      };
      ObserverGroup& both = observers.emplace_back();
      both.add(summaries.emplace_back(scenario));
      both.add(recorders.emplace_back(scene.window, scene.columns, scenario, sampling, add_row));
      requests.push_back({scenario, &both, scene.file.string() + ": " + run.name});
    }
  }
  Interruptible interruptible;
  produce(std::move(requests), interruptible);
  if (is_interrupted()) throw Interrupted();
  auto summary = summaries.begin();
  for (auto& [number, own] : data)
    for (NamedTable& table : own.curves) {
      own.results.push_back((summary++)->summary());
      if (table.table.rows() == 0)
        throw InputError("{}: no part of the run \"{}\" lies in the window",
                         scenes.at(number).file.string(), table.name);
      table.table = thinned(table.table, thinning - sampling);
    }
  return data;
}

}  // namespace rotor
