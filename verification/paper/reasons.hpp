/// The paper's reasons for the accident, and its sentences on what matters, tested on many rotors.
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
  touches,   ///< the same for touching the ring
  force,     ///< applies if it rolls at both, holds if the largest force in rolling is not less
  harmless,  ///< the second is the operating speed: applies if it touches at the first one,
             ///< holds if it does not roll there
  decides,   ///< holds if it rolls at both or at neither: how often the quantity decides that
};

/// How a pair of values is drawn from a range; its ends are a pair of their own.
enum class Spacing { linear, log, ends };

struct Reason {
  std::string id, place, says, quantity;
  double from, until;  ///< of the quantity, from the least to the most risky value, SI
  Spacing spacing;
  std::optional<double> most_friction;  ///< of the rotors on which it is tried
  Criterion judged;
  std::string named;  ///< first or second among what governs the onset of rolling, or not

  /// Of policy.md: trend or ranking; empty for what the text does not state.
  std::string rule() const;
};

/// The rows of reference-data/reasons.csv.
std::vector<Reason> read_reasons(const std::filesystem::path& table);

/// Results of a statement on random rotors, each with a random pair of values.
struct Trial {
  long pairs = 0, apply = 0, violate = 0;
  std::vector<double> sizes{};  ///< of each violation: the force at the riskier value, relative to
                                ///< that at the other one; harmless: the other way round
  std::string example{};        ///< the first violation, as options of `rotor run`

  double share() const;  ///< violations over applicable pairs
  double standard_error() const;
  std::optional<double> median_size() const;
};
using Trials = std::map<std::string, Trial>;  ///< by reason

/// The verdict by the rules of policy.md: holds, mostly holds or refuted, and whether that is
/// narrow; empty for what the text does not state.
std::string verdict_on(const Reason& reason, const std::vector<Reason>& all, const Trials& trials);

/// Tries statements on draws of reasons.toml, with numbers of four digits.
Trials tried(const std::vector<Reason>& reasons, Equations equations, long draws, int threads);

/// The largest normal force of a run until its outcome, and while it rolls, N; 0 if there is none.
struct Forces {
  double largest, in_rolling;
};
Forces forces_of(const ScenarioSpec& spec);

/// What `make reasons` writes.
std::string to_csv(const std::vector<Reason>& reasons, const Trials& published,
                   const Trials& consistent);

/// Of each reason, by its id and the equations: the verdict, how often the riskier value is at
/// least as severe, and the median ratio of forces where it is not; or how often a quantity
/// decides. From reasons-tried.csv in the folder of reference data.
std::map<std::pair<std::string, std::string>, std::string> read_trials_in_words(
    const std::filesystem::path& folder);

}  // namespace rotor
