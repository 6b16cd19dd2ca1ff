/// The significant digits of a run, estimated by computing it twice, the second time at a hundredth
/// of the tolerance: digits in which both agree, with a margin, are taken as those of exact
/// arithmetic for the decimals that were stated. What is proven is in verification/proof.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "model/results/summary.hpp"

namespace rotor {

/// The arithmetic of a computation.
enum class Precision { double_, quadruple };

/// Decimal digits that a double can hold.
constexpr int most_digits = std::numeric_limits<double>::digits10;

/// A value of the finer computation, and its estimated error: infinite if nothing is known.
struct NamedEstimate {
  std::string_view name;
  std::optional<double> value{};  ///< empty if it does not exist
  double error = 0;
  double size = 0;  ///< reference of its digits: its own magnitude, or that of its vector

  /// How many significant digits it has.
  int digits() const {
    int most = most_digits;
    while (most > 0 && value && !(error <= 0.5 * std::pow(10, -most) * size)) --most;
    return most;
  }
};

/// The rotor at an event, or at the end.
struct EventEstimate {
  Event event;
  std::vector<NamedEstimate> values;  ///< time and state
};

/// What both computations together tell.
struct Comparison {
  static constexpr int finer = 100;  ///< by this factor is the second tolerance smaller

  Precision precision{};
  double tolerance = 0;  ///< of the coarser one
  std::vector<NamedEstimate> summary;
  std::vector<EventEstimate> events;  ///< as far as both agree on them; then the end
  bool same_course = false;           ///< whether they agree on all events, and on the outcome
  /// Whether they do, and no event is so near to another, to the end, or to not happening at all,
  /// that its error could change the course.
  bool is_course_sure = false;
  Summary values;  ///< of the finer one
  Counters counters;

  /// Whether all values have so many digits, and the course is sure.
  bool has_digits(int digits) const {
    const auto have = [digits](const std::vector<NamedEstimate>& of) {
      return std::all_of(of.begin(), of.end(),
                         [digits](const NamedEstimate& value) { return value.digits() >= digits; });
    };
    return is_course_sure && have(summary) &&
           std::all_of(events.begin(), events.end(),
                       [&](const EventEstimate& event) { return have(event.values); });
  }
};

/// Called after every step with the time of the run; the run ends if it returns false.
using ShouldContinue = std::function<bool(double time_s)>;

/// Returns nothing if `should_continue` ended a run. Throws as `run` does.
std::optional<Comparison> compare(Precision precision, const Scenario& scenario, double tolerance,
                                  const ShouldContinue& should_continue);

/// The comparison in double precision if all values have so many digits there, otherwise that in
/// quadruple precision, or the last one that was finished.
using RunToDigits = std::optional<Comparison>(const Scenario& scenario, int digits,
                                              const ShouldContinue& should_continue);

/// Null in programs that are not linked with `digits`, which takes long to compile.
extern RunToDigits* const run_to_digits;

}  // namespace rotor
