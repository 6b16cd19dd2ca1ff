/// The populations of reference-data/policy.md over which readings are drawn.
#pragma once

#include <filesystem>
#include <vector>

#include "figures/sweep/sweep.hpp"
#include "verification/paper/paper_runs.hpp"

namespace rotor {

/// The range that an input's digits allow: a row of printed-inputs.csv.
struct InputRange {
  std::string input;
  double least, greatest;
};
std::vector<InputRange> read_input_ranges(const std::filesystem::path& printed_inputs);

enum class Population {
  a,  ///< inputs as printed, the instants of the mass loss over their rounding
  b,  ///< all inputs over their rounding, as far as the paper's arithmetic prints the same
};

/// The draws of a population, by their numbers from 0 on, in any order.
class PopulationDraws {
 public:
  /// Finds `count` draws of (b). Throws std::runtime_error if hardly any proposal is accepted.
  PopulationDraws(Population population, const std::filesystem::path& reference_data, long count,
                  unsigned seed = 1);

  /// The inputs of a draw; torque and times depend on the run-up, and so on the set of equations.
  PaperInputs operator()(long n, const Equations& equations) const;

  /// For (b): proposals tried per draw, and the position of a draw within their ranges, as shares.
  double proposals_a_draw() const { return proposals_a_draw_; }
  std::map<std::string, double> proposed_shares(long n) const;

 private:
  Sweep sweep_;
  std::vector<long> accepted_;  ///< points of the sweep; empty for (a), which takes all
  double proposals_a_draw_ = 1;
};

}  // namespace rotor
