/// What can be stated on the command line. What is not stated is empty.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/scenes/statement.hpp"

namespace rotor {

/// Options that every command has.
struct CommonOptions {
  Statement equations_and_method;
};

struct FigureOptions : CommonOptions {
  std::vector<int> numbers;  ///< all if there are none
  std::string out = "build/figures";
  std::string scenes;  ///< folder with figNN.toml
};

struct PlotOptions : CommonOptions {
  std::string scene;
  std::string out;  ///< the scene's name with .svg, if empty
};

struct SweepOptions {
  std::string file, out;
  int jobs = 0;  ///< threads; 0: as many as there are cores
  bool dry_run = false;
};

struct RunOptions : CommonOptions {
  std::string scene, run_name;
  Statement numbers;          ///< and whether mass is lost
  std::string trace, events;  ///< files to write
  std::vector<std::string> columns;
  std::optional<double> from_s;
  std::optional<double> every_s;  ///< equal distances; adaptive if neither is stated
  std::optional<long> rows;
  std::optional<StopOn> stop_on;
  bool json = false, json_schema = false;
  static constexpr double usual_budget_s = 300;
  std::optional<double> budget_s;  ///< of each run whose digits are asked for
  bool estimate_error = false;
  bool energy = false;        ///< by cause, in the summary
  bool keep_partial = false;  ///< what was computed when the run is interrupted
};

}  // namespace rotor
