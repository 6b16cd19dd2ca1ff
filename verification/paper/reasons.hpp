/// The paper's reasons for the accident, and its sentences on what matters, tried on many rotors.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figures/input/scenario_spec.hpp"

namespace rotor {

/// How a statement is judged on a rotor at two values of a quantity, the second one being riskier.
enum class Criterion {
  rolls,     ///< applies if it rolls at the first one, holds if it does at the second
  touches,   ///< the same of touching the ring
  force,     ///< applies if it rolls at both, holds if the largest force in rolling is not less
  harmless,  ///< the second one being the operating speed: applies if it touches at the first one,
             ///< holds if it does not roll there
  decides,   ///< holds if it rolls at both or at neither: how often the quantity decides that
};

struct Reason {
  std::string id, place, says, quantity;
  double from, until;  ///< of the quantity, from the least to the most risky value, SI
  bool logarithmic;
  std::optional<double> most_friction;  ///< of the rotors on which it is tried
  Criterion judged;
};

/// The rows of reference-data/reasons.csv.
std::vector<Reason> read_reasons(const std::filesystem::path& table);

/// How a statement fares on random rotors, with a random pair of values on each.
struct Trial {
  long pairs = 0, apply = 0, violate = 0;
  std::vector<double> sizes;  ///< of each violation: the force at the riskier value, relative to
                              ///< that at the other one; harmless: the other way round
  std::string example;        ///< the first violation, as options of `rotor run`

  double share() const;  ///< of those to which it applies, that violate it
  double standard_error() const;
  std::optional<double> median_size() const;
};
using Trials = std::map<std::string, Trial>;  ///< by reason

/// Over so many draws of reasons.toml, numbers to four digits, by so many threads.
Trials tried(const std::vector<Reason>& reasons, Equations equations, long draws, int threads);

/// The largest normal force of a run until its outcome, and that while it rolls, N; 0 if there is
/// none.
struct Forces {
  double largest, in_rolling;
};
Forces forces_of(const ScenarioSpec& spec);

/// What `make reasons` writes.
std::string to_csv(const std::vector<Reason>& reasons, const Trials& published,
                   const Trials& consistent);

/// Of each reason, by its id and the equations: with which probability the riskier value is not
/// worse, and by how much the force differs at the median where it is; or how often a quantity
/// decides. From reasons-tried.csv in the folder of reference data.
std::map<std::pair<std::string, std::string>, std::string> read_trials_in_words(
    const std::filesystem::path& folder);

}  // namespace rotor
