/// A run to a guaranteed number of significant digits, compared with exact arithmetic for the
/// decimals that were stated: it is computed several times in one precision, so that each
/// computation shows the errors of the others.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>

#include "model/run/estimates.hpp"

namespace rotor {

/// Called after every step with the time of the run; the run ends if it returns false.
using ShouldContinue = std::function<bool(double time_s)>;

/// Runs the finest computation, at a hundredth of the tolerance, and those that show its errors:
/// one at the tolerance; the same with every number disturbed by more than rounding (left out in
/// the highest precision); and one with another disturbance, at a quarter of the tolerance and by
/// another stepper, because short flights are one step at any tolerance. Two also have shorter
/// first steps. Returns nothing if `should_continue` ended a run. Throws as `run` does.
template <class S>
std::optional<Comparison> compare(const Scenario& scenario, double tolerance,
                                  const ShouldContinue& should_continue);

/// The largest relative error of the values of a summary, estimated by another run at a hundredth
/// of the tolerance, disturbed by more than rounding. 1 if that run takes another course.
double estimated_relative_error(const Scenario& scenario, const Summary& summary,
                                const ShouldContinue& should_continue);

/// The cheapest comparison that reaches so many digits: the first is in double precision, and its
/// errors determine the next. If none reaches them, the last one. Empty if none was finished.
std::optional<Comparison> run_to_digits(const Scenario& scenario, int digits,
                                        const ShouldContinue& should_continue);

/// Thrown in programs that are not linked with `certified`, whose compilation takes longest, by
/// run_to_digits(), estimated_relative_error() and require_certified().
struct NotCertified : std::logic_error {
  NotCertified() : logic_error("this program is built without runs to guaranteed digits") {}
};

/// To be called before any output of a command that needs these functions.
void require_certified();

}  // namespace rotor
