/// What the page states about a run: options of `rotor run` and their texts, so that the page is
/// interpreted, and refused, exactly like the command line.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// Keys are the names of options without leading dashes. The text of a flag is empty.
using Options = std::map<std::string, std::string>;

struct Settings {
  ScenarioSpec spec;
  std::optional<double> from_s;  ///< start of the trace
};

/// Throws InputError with the messages of the command line.
Settings settings_of(const Options& options);

/// The same settings with their printed inputs drawn from their rounding: the rows of
/// reference-data/printed-inputs.csv whose printed value is the one in effect. Values that were
/// changed are kept.
Sweep over_printed_digits(const ScenarioSpec& spec, const std::vector<CsvRow>& printed_inputs,
                          long count);

}  // namespace rotor
