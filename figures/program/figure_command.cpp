#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/results/provenance.hpp"
#include "figures/results/scene_data.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// The scenes that were requested. A scene may state its own equations and methods.
std::map<int, Scene> read_scenes(const FigureOptions& options) {
  std::error_code error;
  if (!fs::is_directory(options.scenes, error))
    throw InputError("--scenes {}: there is no such folder", shown(options.scenes));
  const std::map<int, fs::path> files = figure_files(options.scenes);
  if (files.empty())
    throw InputError("--scenes {}: there is no figNN.toml in this folder", shown(options.scenes));
  std::vector<int> all;
  for (const auto& [number, file] : files) all.push_back(number);
  std::map<int, Scene> scenes;
  for (const int number : options.numbers.empty() ? all : options.numbers) {
    if (!files.contains(number))
      throw InputError("figure {}: there is no {}; the figures are {}", number,
                       (fs::path(options.scenes) / fmt::format("fig{:02}.toml", number)).string(),
                       fmt::join(all, ", "));
    scenes.emplace(number, read_scene(files.at(number), {options.stated, {}}));
  }
  return scenes;
}

}  // namespace

void write_figures(const FigureOptions& options) {
  const std::map<int, Scene> scenes = read_scenes(options);
  const auto data = compute_data(scenes);
  FileTransaction files;
  for (const auto& [number, scene] : scenes) {
    const std::string file = (fs::path(options.out) / fmt::format("fig{:02}", number)).string();
    files.write(file + ".csv",
                csv_head(fmt::format("Fig. {}: {}", number, scene.title), scene, "run") +
                    csv_rows(data.at(number).curves));
    files.write(file + ".var", variables(scene, data.at(number).results));
  }
  files.commit();
  print_message(fmt::format("data of {} figure(s) written", scenes.size()));
}

}  // namespace rotor
