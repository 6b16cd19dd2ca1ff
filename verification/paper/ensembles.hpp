/// Readings over the populations of reference-data/policy.md.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "verification/paper/populations.hpp"

namespace rotor {

/// The sets of equations in which claims are judged.
struct Set {
  const char* name;
  Equations equations;
};
inline const std::array<Set, 2> sets = {
    {{"published", Equations::published}, {"corrected", Equations::corrected}}};

/// Draws of each reading: its values in the order of the draws, NaN if there is none.
using Draws = std::map<std::string, std::vector<double>>;

/// Works on `count` items in threads. `report` is called with the number of finished ones.
void in_parallel(
    long count, int threads, const std::function<void(long)>& work_on,
    const std::function<void(long)>& report = [](long) {});

/// Readings at `count` points. The result does not depend on the number of threads.
Draws evaluate(
    const std::vector<std::string>& readings, long count,
    const std::function<PaperInputs(long)>& at, int threads,
    const std::function<void(long)>& report = [](long) {});

/// The distribution of a reading over draws.
struct Spread {
  long draws = 0;
  double valued = 0;                     ///< share of the draws that have a value
  double median = 0, low = 0, high = 0;  ///< 50, 5 and 95 % quantiles of those

  bool is_in_range(double value) const { return low <= value && value <= high; }
};
Spread spread(std::vector<double> values);

/// A stored spread, and the share of all draws in which the claim holds.
struct Stored {
  Spread spread;
  double holds = 0;
};

/// By set, population (a, b), number and reading: the rows of ensembles.csv.
using Ensembles = std::map<std::array<std::string, 4>, Stored>;
Ensembles read_ensembles(const std::filesystem::path& table);

}  // namespace rotor
