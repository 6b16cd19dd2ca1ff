/// Compares the results of `rotor run --digits` with more accurate ones.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/certified/comparison.hpp"

namespace rotor {

/// By the names of for_each_named, and the counts among them; empty if the run has no such value.
/// What is not among them is not known.
using KnownValues = std::map<std::string, std::optional<double>>;

/// A run with its values.
struct KnownRun {
  Scenario scenario;
  KnownValues values;
};

/// Random runs, and from the thirty-first on those on which earlier rules failed: steps that all
/// computations share, a touch-down just before the end, a velocity of O that is a small difference
/// from that of the rim.
std::vector<KnownRun> known_runs(const std::filesystem::path& file);
constexpr std::size_t count_of_random_runs = 30;

/// What is wrong in a run with guaranteed digits: an error that is too small, or a wrong printed
/// digit; empty if nothing is. `worst` is raised to the largest true error relative to the claimed
/// one.
std::string falsehood(const Comparison& found, int digits, const KnownValues& known, double& worst);

/// The largest true relative error of a summary; 1 if a value is missing or superfluous.
double true_error(const Summary& summary, const Parameters& p, const KnownValues& known);

/// The values of a summary, of each event, and of the end, by name.
template <class Action>
void for_each_named(const Comparison& found, const Action& action) {
  for (const NamedEstimate& value : found.summary) action(std::string(value.name), value);
  for (std::size_t i = 0; i < found.events.size(); ++i) {
    const bool is_end = found.events[i].event == Event::none;
    const std::string where = is_end ? "end." : "event" + std::to_string(i) + ".";
    for (const NamedEstimate& value : found.events[i].values)
      action(where + std::string(value.name), value);
  }
}

}  // namespace rotor
