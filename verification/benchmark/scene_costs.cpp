/// What each figure costs: that nothing is computed which its scene does not need, and that what
/// figures have in common is computed once.
#include <fmt/format.h>

#include <chrono>
#include <deque>

#include "figures/data/thinning.hpp"
#include "figures/input/scene.hpp"
#include "figures/record/recorder.hpp"
#include "figures/runs/production.hpp"
#include "verification/support/program.hpp"
#include "verification/support/sines.hpp"

namespace rotor {
namespace {

struct Cost {
  ProductionCost of;
  long pairs{};  ///< of sine and cosine
  std::size_t samples{}, kept{};
  double time_s =
      std::numeric_limits<double>::infinity();  ///< least of some runs, of computing alone
};

/// Of the data of some scenes in one production.
Cost cost(const std::vector<const Scene*>& scenes) {
  constexpr int runs = 5;
  Cost cost;
  for (int run = 0; run < runs; ++run) {
    std::deque<Recorder> recorders;
    std::deque<Table> tables;
    std::vector<Request> requests;
    for (const Scene* scene : scenes)
      for (const SceneRun& scene_run : scene->runs)
        requests.push_back(
            {scene_run.scenario,
             recorders.emplace_back(scene->window, scene->columns, scene_run.scenario, sampling,
                                    [&table = tables.emplace_back(scene->columns.size())](
                                        auto row) { table.add(row); })});
    const long pairs_before = sine_cosine_pairs();
    const auto begin = std::chrono::steady_clock::now();
    cost.of = produce(requests);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    cost.time_s = std::min(cost.time_s, time.count());
    cost.pairs = sine_cosine_pairs() - pairs_before;
    cost.samples = cost.kept = 0;
    for (const Table& table : tables) {
      cost.samples += table.rows();
      cost.kept += thinned(table, thinning - sampling).rows();
    }
  }
  return cost;
}

void print(const std::string& name, const Cost& cost) {
  const Counters& counted = cost.of.counters;
  fmt::print("{:<22} {:>4} {:>4} {:>9} {:>9} {:>9} {:>6} {:>9} {:>8} {:>7} {:>7.1f}\n", name,
             cost.of.run_ups, cost.of.runs, counted.steps, counted.right_hand_sides,
             counted.contact_evaluations, counted.located_events, cost.pairs, cost.samples,
             cost.kept, 1e3 * cost.time_s);
  std::fflush(stdout);
}

int main(const Arguments& arguments) {
  if (arguments.size() != 1) throw std::runtime_error("needs: FOLDER with figNN.toml");
  fmt::print("{:<22} {:>4} {:>4} {:>9} {:>9} {:>9} {:>6} {:>9} {:>8} {:>7} {:>7}\n", "data of",
             "ups", "runs", "steps", "rhs", "contact", "events", "pairs", "samples", "kept", "ms");
  std::map<int, Scene> scenes;
  for (const auto& [number, file] : figure_files(arguments[0])) scenes[number] = read_scene(file);
  std::vector<const Scene*> all, located;
  for (const auto& [number, scene] : scenes) {
    print(fmt::format("Fig. {}", number), cost({&scene}));
    all.push_back(&scene);
    if (std::ranges::all_of(
            scene.runs, [](const SceneRun& run) { return run.scenario.method == Method::event; }))
      located.push_back(&scene);
  }
  print("all in one", cost(all));
  print("all but the published", cost(located));
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("scene-costs", rotor::main, argc, argv);
}
