/// The paper's reasons for the accident, and its sentences on trends: how often each holds on
/// random rotors.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "figures/input/scenario_spec.hpp"

namespace rotor {

/// How a statement is judged on a rotor at two values of a quantity, the second one being riskier.
enum class Criterion {
  rolls,     ///< applies if it rolls at the first one, holds if it does at the second
  touches,   ///< the same for touching the ring
  force,     ///< applies if it rolls at both, holds if the largest force in rolling is not less
  harmless,  ///< at one value: applies if it touches, holds if it does not roll there
};

/// A row of reference-data/reasons.csv.
struct Reason {
  std::string id, quantity;
  double from, until;  ///< of the quantity, from the least to the most risky value, SI
  bool is_logarithmic;
  double most_friction;  ///< of the rotors on which it is tried
  Criterion judged;
};
std::vector<Reason> read_reasons(const std::filesystem::path& table);

/// Random rotors, each with a random pair of values.
struct Trial {
  long pairs = 0, apply = 0, hold = 0;

  Trial& operator+=(const Trial& other);
  double share() const { return static_cast<double>(hold) / static_cast<double>(apply); }
};

/// Tries each reason on draws of reasons.toml.
std::vector<Trial> tried(const std::vector<Reason>& reasons, const Equations& equations, long seed,
                         long draws, int threads);

/// A run until its outcome.
struct RubEnd {
  bool touches, rolls;
  double largest_N, in_rolling_N;  ///< normal force; 0 if there is none
};
RubEnd end_of(const ScenarioSpec& spec);

/// Of one pair, the second value being riskier.
Trial trial_of(Criterion judged, const RubEnd& at_first, const RubEnd& at_second);

}  // namespace rotor
