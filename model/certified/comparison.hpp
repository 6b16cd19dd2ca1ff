/// A run computed several times in one precision, so that each computation shows the
/// errors of the others.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

/// What numbers are computed with. Not every processor has the second.
enum class Precision { double_, extended, quadruple };

/// A number, and how far it may be from the truth: infinitely far if nothing is known of it.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// A value with its error, and where that comes from.
struct NamedEstimate {
  std::string_view name;
  std::optional<Estimate> estimate{};  ///< empty if the value does not exist
  double size = 0;          ///< of which its digits are counted: its own, or that of its vector
  double of_tolerance = 0;  ///< the part of the error that a finer tolerance makes smaller
  double of_rounding = 0;   ///< that which more digits of the numbers make smaller
};

/// The rotor at an event, or at the end.
struct EventEstimate {
  Event event;
  std::vector<NamedEstimate> values;  ///< time and state
};

struct Comparison {
  /// By how much the tolerances of two computations are less than that of the others.
  static constexpr int finest = 100, other = 4;

  Precision precision = Precision::double_;
  double tolerance = 0;
  std::vector<NamedEstimate> summary;
  std::vector<EventEstimate> events;  ///< as far as the computations agree on them; then the end
  bool same_course = false;           ///< whether they agree on all of them, and on the outcome
  /// What is positive, and would change its sign with the course: by how much near misses miss and
  /// touch-downs hit.
  std::vector<NamedEstimate> margins;
  /// Of a disturbance, from the first contact to the end, or as far as computations agree.
  std::optional<double> amplification;
  Summary values;  ///< of the finest computation
  RunEnd end;

  /// Whether counts and outcome are those of exact arithmetic.
  bool is_course_sure() const;
  /// Of what is not exact nobody knows by how much another course would change it.
  void invalidate_path_dependent_values();
};

/// Asked after every step whether to go on, at that time of the run.
using GoesOn = std::function<bool(double time_s)>;

/// The finest computation, with a hundredth of the tolerance, and those that show its errors: one
/// with the tolerance; the same one disturbed, every number being changed by more than rounding (in
/// the last precision it is left out); and one disturbed otherwise, with a quarter of the tolerance
/// and by another stepper, as short flights are one step at any tolerance. Their first steps
/// differ, too: nothing is the same in all of them. Empty if it was not to go on. Throws as `run`
/// does.
template <class S>
std::optional<Comparison> compare(const Scenario& scenario, double tolerance,
                                  const GoesOn& goes_on);

/// The largest relative error of the values of a summary, as shown by another run, with a hundredth
/// of the tolerance, and disturbed by more than rounding. 1 if it takes another course.
double estimated_relative_error(const Scenario& scenario, const Summary& summary,
                                const GoesOn& goes_on);

}  // namespace rotor
