/// A sweep: a scenario with some quantities that vary over axes, at random, or both.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "figures/input/scenario_spec.hpp"

namespace rotor {

/// A linear or logarithmic range.
struct Range {
  double from, until;
  long points;
  bool logarithmic;

  double at(long n) const;  ///< the ends exactly
};

/// A quantity and its values, one after the other: names, or numbers, or those of a range.
struct Axis {
  std::string quantity;
  std::vector<std::string> names{};
  std::vector<double> numbers{};
  Range range{};

  long points() const;
  double number(long n) const;
  /// The least number and the greatest.
  std::pair<double, double> ends() const;
};

enum class Distribution { uniform, log_uniform, normal };

/// A quantity that is drawn.
struct Draw {
  std::string quantity;
  Distribution distribution;
  double a, b;  ///< the ends; or mean and deviation

  /// The number below which a share, between 0 and 1, of all draws lies.
  double quantile(double share) const;
  /// Those between which a sample of so many draws lies; of normal ones in 999 of 1000 cases.
  std::pair<double, double> ends(long count) const;
};

enum class Sampling { sobol, random };

/// A sample, with the same draws at each point of the axes.
struct Sample {
  long count = 1;
  unsigned long seed = 0;
  Sampling method = Sampling::sobol;
  std::vector<Draw> over;
};

/// The columns of results if none are selected.
std::vector<std::string> usual_columns(bool with_section = false);

struct Sweep {
  std::string title;
  std::string text;  ///< of the file, which determines the results
  ScenarioSpec base;
  std::vector<Axis> axes;  ///< the last one varies fastest, after the sample
  Sample sample;
  std::vector<std::string> columns = usual_columns();  ///< of the results
  std::optional<double> budget_s = {};  ///< time for each point; if empty, none, or the usual
  std::optional<long> section_turns{};  ///< of the section of each point

  long points() const;
  std::vector<std::string> quantities() const;  ///< the ones that vary
};

/// Reads a TOML sweep file. Throws InputError, also if a corner of the axes is not physical.
Sweep read_sweep(const std::filesystem::path& file);
/// The same for the content of one that messages refer to by `name`.
Sweep read_sweep(const std::string& name, const std::string& content);

/// A point of a sweep.
struct SweepPoint {
  ScenarioSpec spec;
  std::vector<std::string> values;  ///< of what varies, as texts
};

/// The points of a sweep, by their numbers from 0 on, in any order.
class SweepPoints {
 public:
  explicit SweepPoints(const Sweep& sweep);

  SweepPoint operator()(long n) const;

 private:
  std::vector<double> shares(long draw) const;

  const Sweep& sweep_;
  std::vector<std::uint64_t> shifts_;  ///< of each coordinate, from the seed
};

}  // namespace rotor
