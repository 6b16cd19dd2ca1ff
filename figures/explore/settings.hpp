/// What a page with knobs states of a run: options of `rotor run` and their texts, so that the page
/// is understood, and refused, as the command line is.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// By the names of the options, without the dashes in front of them. The text of a flag is empty.
using Options = std::map<std::string, std::string>;

struct Settings {
  ScenarioSpec spec;
  std::optional<double> from_s;  ///< where the trace begins
};

/// Throws InputError in the words of the command line.
Settings settings_of(const Options& options);

/// The same settings with their printed inputs drawn from what the printed digits allow: the rows
/// of reference-data/printed-inputs.csv whose printed value is the one in effect. What somebody has
/// set to another value is meant literally.
Sweep over_printed_digits(const ScenarioSpec& spec, const std::vector<CsvRow>& printed_inputs,
                          long count);

}  // namespace rotor
