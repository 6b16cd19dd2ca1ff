/// What several computations of one run say together: its values, and how far they may be from
/// those of exact arithmetic.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

/// The arithmetic of a computation. Not every processor has the extended one.
enum class Precision { double_, extended, quadruple };

/// A number, and how far it may be from the truth: infinitely far if nothing is known about it.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// A value with its error and the sources of the error.
struct NamedEstimate {
  std::string_view name;
  std::optional<Estimate> estimate{};  ///< empty if the value does not exist
  double size = 0;          ///< reference of its digits: its own magnitude, or that of its vector
  double of_tolerance = 0;  ///< the part of the error that a finer tolerance reduces
  double of_rounding = 0;   ///< the part that a higher precision reduces

  /// The error that a number with so many digits may have.
  double allowed_error(int digits) const { return 0.5 * std::pow(10, -digits) * size; }
  bool has_finite_error() const { return estimate && std::isfinite(estimate->error); }
};

/// The rotor at an event, or at the end.
struct EventEstimate {
  Event event;
  std::vector<NamedEstimate> values;  ///< time and state
};

struct Comparison {
  /// The tolerances of two computations are smaller by these factors.
  static constexpr int finest = 100, other = 4;

  Precision precision = Precision::double_;
  double tolerance = 0;
  std::vector<NamedEstimate> summary;
  std::vector<EventEstimate> events;  ///< as far as the computations agree on them; then the end
  bool same_course = false;           ///< whether they agree on all of them, and on the outcome
  /// Positive quantities, of which one would change sign if the course changed: see margins_of().
  std::vector<NamedEstimate> margins;
  /// Growth of a disturbance from the first contact to the end, or as far as computations agree.
  std::optional<double> amplification;
  Summary values;  ///< of the finest computation
  RunEnd end;

  /// Whether counts and outcome are those of exact arithmetic.
  bool is_course_sure() const;
  /// Makes the errors of all but exact values infinite, as another course may change them at will.
  void invalidate_path_dependent_values();
};

/// Decimal digits that a double can hold.
constexpr int most_digits = std::numeric_limits<double>::digits10;

/// How many significant digits of a value are certain.
int sure_digits(const NamedEstimate& value);

/// Whether the digits are reached: every value has them, and the course is certain.
bool has_digits(const Comparison& comparison, int digits);

}  // namespace rotor
