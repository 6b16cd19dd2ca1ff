/// What the rounding of the printed inputs leaves of each reading: see reference-data/policy.md.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "verification/paper/readings.hpp"

namespace rotor {

/// What the digits of an input allow: a row of printed-inputs.csv.
struct InputRange {
  std::string input;
  double least, greatest;
};
std::vector<InputRange> read_input_ranges(const std::filesystem::path& printed_inputs);

enum class Rounded { times, everything };  ///< the instants of the mass loss alone, or all inputs

/// Draws of each reading: its values in the order of the draws, NaN where there is none.
using Draws = std::map<std::string, std::vector<double>>;

/// Readings at so many points, by so many threads. The same whatever their number. `told` hears
/// how many are done.
struct Points {
  long count;
  std::function<PaperInputs(long)> at;
};
Draws evaluate(
    const std::vector<std::string>& readings, const Points& points, int threads,
    const std::function<void(long)>& told = [](long) {});

/// The same over so many draws from the first one of Sobol's sequence on.
Draws draw(
    const std::vector<std::string>& readings, const std::filesystem::path& printed_inputs,
    Rounded rounded, const Equations& equations, long count, int threads,
    const std::function<void(long)>& told = [](long) {});

/// A stored ensemble of one reading.
struct Spread {
  long draws = 0;
  double median = 0, low = 0, high = 0;  ///< 50, 5 and 95 % quantiles of the values there are
  double share = 0;                      ///< of the draws in which the claim holds
};

/// Of the values that hold by a predicate.
Spread spread(std::vector<double> values, const std::function<bool(double)>& holds);

/// The readings of the largest force after each of the text's losses that lead to contact, kN.
/// There is none if the rotor stays clear of the ring.
const std::vector<std::string>& forces_of_accidents();

/// Stored ensembles of these, over every printed digit, by the names of reading and equations.
/// Their share is that of the draws with contact.
using Accidents = std::map<std::pair<std::string, std::string>, Spread>;
Accidents read_accidents(const std::filesystem::path& table);

/// Rows of accidents.csv.
std::string accidents_csv(const Draws& published, const Draws& consistent);

}  // namespace rotor
