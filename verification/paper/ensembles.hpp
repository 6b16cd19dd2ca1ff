/// What the rounding of the printed inputs leaves of each reading: see reference-data/policy.md.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "verification/paper/readings.hpp"

namespace rotor {

enum class Rounded { times, everything };  ///< the instants of the mass loss alone, or all inputs

/// Draws of one reading: its values in the order of the draws, NaN where there is none.
using Draws = std::map<std::string, std::vector<double>>;

/// The readings that runs decide, over so many draws from the first one of Sobol's sequence on, by
/// so many threads. The same draws whatever their number. `told` hears how many are done.
Draws draw(
    const std::filesystem::path& printed_inputs, Rounded rounded, long count, int threads,
    const std::function<void(long)>& told = [](long) {});

/// A stored ensemble of one reading.
struct Spread {
  long draws = 0;
  double median = 0, low = 0, high = 0;  ///< 50, 5 and 95 % quantiles of the values there are
  double share = 0;                      ///< of the draws in which the claim holds
};

/// Of the values that hold by a predicate.
Spread spread(std::vector<double> values, const std::function<bool(double)>& holds);

}  // namespace rotor
