/// The results of a run whose digits are estimated.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/input/names.hpp"
#include "figures/results/json.hpp"
#include "figures/results/run_result.hpp"
#include "model/digits/digits.hpp"

namespace rotor {

template <>
inline constexpr auto names_of<Precision> = std::to_array<Named<Precision>>(
    {{"double", Precision::double_}, {"quadruple", Precision::quadruple}});

/// Time for the digits of a run, if none is stated.
inline constexpr double usual_budget_s = 300;

/// Throws InputError, with the name, if that is no budget.
void require_budget(std::string_view name, double budget_s);

/// A value with fewer digits than were asked for.
struct ShortOfDigits {
  std::string value;
  int digits;
};
std::vector<ShortOfDigits> short_of_digits(const Comparison& comparison, int digits);

/// The comparison that a run to so many digits ends with. Throws Interrupted, and
/// std::runtime_error if the monitor's budget ends before the first comparison.
Comparison comparison_to_digits(const Scenario& scenario, int digits, const Interruptible& monitor,
                                const std::function<void(double time_s)>& on_step = {});

/// Which of the digits that were asked for are missing then, and why; empty if none is.
std::string complaint(const Comparison& comparison, int digits, const Interruptible& monitor);

/// The result of the finer computation.
RunResult result_of(const Comparison& comparison, const Scenario& scenario);

/// Like that of a RunResult, but with the errors of its numbers, and with the events.
Json to_json(const Comparison& comparison, const Scenario& scenario, int digits);

/// A number with so many significant digits, including trailing zeros.
std::string rounded_to(double value, int digits);

/// Printed for a number without a digit.
inline constexpr std::string_view no_digit = "?";

/// At most so many digits of a number, and only those that do not change within its error.
std::string text_within(double value, double error, int digits);

/// The digits of a number of a summary, in a unit, that do not change within its error; nothing if
/// none are estimated.
std::optional<std::string> sure_text(const Json& summary, const std::string& key, double unit = 1);

}  // namespace rotor
