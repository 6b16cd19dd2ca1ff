/// What can be stated on the command line. What is not stated is empty.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/simulation/scenario.hpp"

namespace rotor {

/// Options that every command has.
struct CommonOptions {
  std::string equations;
  std::string method;

  void apply_to(Scenario& scenario) const;
};

struct FigureOptions : CommonOptions {
  std::vector<int> numbers;  ///< all if there are none
  std::string out = "build/figures";
  std::string scenes;  ///< folder with figNN.toml
};

struct RunOptions : CommonOptions {
  std::string scene, run_name;
  std::map<const Quantity*, double> numbers;
  bool no_separation = false;
  std::string trace, events;  ///< files to write
  std::vector<std::string> columns;
  std::optional<double> from_s;
  bool json = false;
  bool keep_partial = false;  ///< what was computed when the run is interrupted
};

}  // namespace rotor
