/// The paper's figures as their scene files state them.
#pragma once

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "figures/input/scene.hpp"

namespace rotor {

struct Figure {
  int number;
  double from_s, until_s;  ///< the window; in a figure from the onset of rolling on, its length
  bool from_rolling_onset;
  std::vector<std::string> columns;
  std::vector<std::pair<std::string, Scenario>> runs;  ///< by their names
};

inline void PrintTo(const Figure& figure, std::ostream* out) { *out << "Fig. " << figure.number; }

inline std::vector<Figure> paper_figures() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(ROTOR_SCENES))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<Figure> figures;
  for (const auto& file : files) {
    const Scene scene = read_scene(file);
    const Window& window = scene.window;
    const double from_s = window.from_rolling_onset ? 0 : window.from_s;
    Figure figure{.number = std::stoi(file.stem().string().substr(3)),
                  .from_s = from_s,
                  .until_s = from_s + window.length_s,
                  .from_rolling_onset = window.from_rolling_onset,
                  .columns = {},
                  .runs = {}};
    for (const Column* column : scene.columns) figure.columns.emplace_back(column->name);
    for (const SceneRun& run : scene.runs) figure.runs.emplace_back(run.name, run.scenario);
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace rotor
