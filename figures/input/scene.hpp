/// Scene files: what a figure, or any other run, consists of.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/input/names.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/record/recorder.hpp"

namespace rotor {

/// One run of a scene, named in the first column of its data.
struct SceneRun {
  std::string name;
  Scenario scenario;
  bool states_equations = false;
  std::optional<int> digits{};  ///< that are asked for
  bool states_end = false;      ///< in its scene

  /// Of a rotor that is not the paper's nobody can know which equations are meant.
  bool leaves_equations_open() const;
};

struct Scene {
  std::string title;
  Window window;
  std::vector<const Column*> columns;
  std::vector<SceneRun> runs;
  std::filesystem::path file{};  ///< that states it, if one does
};

/// The lines above a scene file.
struct Overrides {
  ScenarioSpec of_parameters;  ///< but not what a [[run]] states itself
  ScenarioSpec of_runs;
  std::string run{};  ///< all runs but this one are left out, if it is stated
};

/// Reads a TOML scene file. Throws InputError.
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// The scenes of a folder's figures, figNN.toml, by their numbers.
std::map<int, std::filesystem::path> figure_files(const std::filesystem::path& folder);

/// From shortly before the first mass loss of the runs to their ends; all of a run without one.
Window window_about_loss(const std::vector<SceneRun>& runs);

/// The same window with what the options --from and --until state. Throws InputError if it is not
/// inside every run.
Window stated_window(Window window, std::optional<double> from_s, std::optional<double> until_s,
                     const std::vector<SceneRun>& runs);

/// The columns of those names. Throws InputError, naming all columns, for one that does not exist.
std::vector<const Column*> parse_columns(const std::vector<std::string>& names);

}  // namespace rotor
