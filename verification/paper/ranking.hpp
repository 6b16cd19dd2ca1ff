/// Which input decides each number of the text, over what the printed digits leave open.
#pragma once

#include "verification/paper/ensembles.hpp"

namespace rotor {

/// Readings with one input at the least and the greatest value that its digits allow, all others as
/// printed: draws 2n and 2n + 1 are those of the n-th input.
Draws one_at_a_time(const std::vector<std::string>& readings, const std::vector<InputRange>& ranges,
                    int threads);

/// An estimate with the ends of its interval of 95 % confidence.
struct Estimate {
  double value, low, high;
};

/// What an input does to a reading: one at a time, and Sobol's indices, which are shares of the
/// variance over the rounding of all inputs: by it alone, and with whatever it takes part in.
struct Influence {
  std::string reading, input;
  double at_least, at_greatest;
  Estimate first, total;
};
std::vector<Influence> read_ranking(const std::filesystem::path& ranking);

/// Those of a reading, the one with the greatest total index first.
std::vector<Influence> ranked(const std::vector<Influence>& all, const std::string& reading);

}  // namespace rotor
