#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/scenes/production.hpp"
#include "figures/scenes/provenance.hpp"
#include "figures/scenes/recorder.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

std::string csv(int number, const Scene& scene, const std::vector<Recorder>& recorders) {
  std::vector<NamedTable> tables;
  for (std::size_t i = 0; i < recorders.size(); ++i) {
    if (recorders[i].table().rows() == 0)
      throw InputError(fmt::format("figure {}: nothing of the run \"{}\" lies in the window",
                                   number, scene.runs[i].name));
    tables.push_back({scene.runs[i].name, thinned(recorders[i].table(), thinning)});
  }
  return to_csv(provenance(fmt::format("Fig. {}: {}", number, scene.title), scene),
                headings("run", scene.columns), tables);
}

/// The scene files of a folder, by the number of the figure.
std::map<int, fs::path> scene_files(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw InputError(fmt::format("--scenes {}: there is no such folder", folder.string()));
  std::map<int, fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    int number = 0;
    std::from_chars(name.data() + std::min(name.size(), std::size_t{3}), name.data() + name.size(),
                    number);
    if (name == fmt::format("fig{:02}.toml", number)) files[number] = entry.path();
  }
  return files;
}

/// Those that are asked for. A scene may state equations and methods of its own.
std::map<int, Scene> read_scenes(const FigureOptions& options) {
  const std::map<int, fs::path> files = scene_files(options.scenes);
  std::vector<int> all;
  for (const auto& [number, file] : files) all.push_back(number);
  Scenario defaults;
  options.apply_to(defaults);
  std::map<int, Scene> scenes;
  for (const int number : options.numbers.empty() ? all : options.numbers) {
    if (!files.contains(number))
      throw InputError(fmt::format("figure {}: there is no {}; the figures are {}", number,
                                   (fs::path(options.scenes) / "figNN.toml").string(),
                                   fmt::join(all, ", ")));
    scenes.emplace(number, read_scene(files.at(number), defaults));
  }
  return scenes;
}

}  // namespace

void write_figures(const FigureOptions& options) {
  const std::map<int, Scene> scenes = read_scenes(options);

  std::map<int, std::vector<Recorder>> recorders;
  std::vector<Request> requests;
  for (const auto& [number, scene] : scenes) {
    auto& own = recorders[number];
    own.reserve(scene.runs.size());  // the requests refer to them
    for (const SceneRun& scene_run : scene.runs) {
      Recorder& recorder =
          own.emplace_back(scene.window, scene.columns, scene_run.scenario, sampling);
      requests.push_back({scene_run.scenario, recorder});
    }
  }
  const ProductionReport report = produce(requests);

  FileTransaction files;
  for (const auto& [number, scene] : scenes)
    files.write(fs::path(options.out) / fmt::format("fig{:02}.csv", number),
                csv(number, scene, recorders.at(number)));
  files.commit();
  fmt::print(stderr,
             "data of {} figure(s): {} run-up(s) in {:.3f} s, {} run(s) after it in {:.3f} s, {} "
             "right-hand sides\n",
             scenes.size(), report.run_ups, report.run_up_s, report.runs, report.rub_s,
             report.cost.right_hand_sides);
}

}  // namespace rotor
