/// Scene files: the runs, columns and window of a figure, or of any other run.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/input/scenario_spec.hpp"
#include "figures/record/recorder.hpp"
#include "figures/runs/run_ups.hpp"

namespace rotor {

/// One run of a scene, named in the first column of its data.
struct SceneRun {
  std::string name;
  Scenario scenario;
  ScenarioSpec stated{};  ///< by the scene and by options
};

struct Scene {
  std::string title;
  Window window;
  std::vector<const Column*> columns;
  std::vector<SceneRun> runs;
  std::filesystem::path file{};  ///< empty if there is none
};

/// What takes precedence over a scene file.
struct Overrides {
  ScenarioSpec of_parameters;  ///< over [parameters]; a [[run]] takes precedence
  ScenarioSpec of_runs;
  std::string run{};  ///< the only run that is kept, unless empty
};

/// Reads a TOML scene file. Throws InputError. Run-ups to a stated speed are left in `run_ups`.
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides, RunUps& run_ups);
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// The scene files of a folder's figures, figNN.toml, by their numbers.
std::map<int, std::filesystem::path> figure_files(const std::filesystem::path& folder);

/// From shortly before the first mass loss to the ends of the runs; from the start if one has none.
Window window_about_loss(const std::vector<SceneRun>& runs);

/// The window with the options --from and --until applied. Throws InputError if it is not inside
/// every run.
Window stated_window(Window window, std::optional<double> from_s, std::optional<double> until_s,
                     const std::vector<SceneRun>& runs);

/// The columns with those names. Throws InputError, listing all columns, if one does not exist.
std::vector<const Column*> parse_columns(const std::vector<std::string>& names);

}  // namespace rotor
