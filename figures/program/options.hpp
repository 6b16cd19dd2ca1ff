/// What can be stated on the command line. Empty: not stated.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/input/scenario_spec.hpp"

namespace rotor {

/// Options of several commands.
struct CommonOptions {
  ScenarioSpec equations_and_method;
};

struct FigureOptions : CommonOptions {
  std::vector<int> numbers;  ///< all if empty
  std::string out = "build/figures";
  std::string scenes;  ///< folder with figNN.toml
};

struct PlotOptions : CommonOptions {
  std::string file;  ///< a scene, a sweep, or a sweep's results
  std::string out;   ///< the file's name with .svg, if empty
  std::optional<double> from_s, until_s;
  bool spectrum = false;
  std::string column;  ///< of a sweep; empty: the largest normal force
};

struct SweepOptions {
  std::string file, out;
  int jobs = 0;  ///< threads; 0: as many as there are cores
  bool dry_run = false;
};

/// The case to run or estimate.
struct CaseOptions : CommonOptions {
  std::string scene, run_name;
  ScenarioSpec numbers;  ///< and whether mass is lost
  bool json = false;
};

struct RunOptions : CaseOptions {
  std::string trace, events;  ///< files to write
  std::vector<std::string> columns;
  std::optional<double> from_s;
  std::optional<double> every_s;  ///< equal intervals; adaptive if neither this nor rows is stated
  std::optional<long> rows;
  std::optional<StopOn> stop_on;
  bool json_schema = false;
  static constexpr double usual_budget_s = 300;
  std::optional<double> budget_s;  ///< of each run with guaranteed digits
  bool estimate_error = false;
  bool energy = false;        ///< by cause, in the summary
  bool keep_partial = false;  ///< keep what was computed before an interruption
};

}  // namespace rotor
