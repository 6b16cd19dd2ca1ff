/// What the page states about a run: options of `rotor run` and their texts, so that the page is
/// interpreted, and refused, exactly like the command line.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "figures/input/scenario_spec.hpp"

namespace rotor {

/// Keys are the names of options without leading dashes. The text of a flag is empty.
using Options = std::map<std::string, std::string>;

struct Settings {
  ScenarioSpec spec;
  std::optional<double> from_s;  ///< start of the trace
};

/// Throws InputError with the messages of the command line.
Settings settings_of(const Options& options);

}  // namespace rotor
