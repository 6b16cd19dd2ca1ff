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

/// What becomes of a loss that the text lets lead to an accident, over every printed digit: a row
/// of accidents.csv.
struct Accident {
  Spread force;      ///< the largest one, kN, of the draws with contact, which are its share
  double rolls = 0;  ///< share of the draws in which the rotor comes to roll
};

/// Such a loss, by its instant, and the readings that tell what becomes of it.
struct LossOfAccident {
  std::string at, force, rolls;
};
const std::vector<LossOfAccident>& losses_of_accidents();
/// All of their readings.
std::vector<std::string> readings_of_accidents();

/// By the instant of the loss and the name of the equations.
using Accidents = std::map<std::pair<std::string, std::string>, Accident>;
Accidents read_accidents(const std::filesystem::path& table);

/// Of draws in one set of equations.
Accident accident(const LossOfAccident& loss, const Draws& draws);

/// Rows of accidents.csv.
std::string accidents_csv(const Draws& published, const Draws& consistent);

}  // namespace rotor
