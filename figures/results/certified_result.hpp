/// The results of a run with guaranteed digits.
#pragma once

#include <string>
#include <vector>

#include "figures/input/names.hpp"
#include "figures/results/json.hpp"
#include "figures/results/run_result.hpp"
#include "model/run/estimates.hpp"

namespace rotor {

template <>
inline constexpr auto names_of<Precision> =
    std::to_array<Named<Precision>>({{"double", Precision::double_},
                                     {"extended", Precision::extended},
                                     {"quadruple", Precision::quadruple}});

/// A value with fewer certain digits than were asked for.
struct ShortOfDigits {
  std::string value;
  int digits;
};
std::vector<ShortOfDigits> short_of_digits(const Comparison& comparison, int digits);

/// Why digits that were asked for are not certain; empty if all are.
std::string complaint(const Comparison& comparison, int digits);

/// The result of the finest computation.
RunResult result_of(const Comparison& comparison, const Scenario& scenario);

/// Like that of a RunResult, but with the error of each number and with the events.
Json to_json(const Comparison& comparison, const Scenario& scenario, int digits);

/// A number with so many significant digits, including trailing zeros.
std::string rounded_to(double value, int digits);

/// Printed for a number without a certain digit.
inline constexpr std::string_view no_sure_digit = "?";

/// At most so many digits of a number, and only those that do not change within its error.
std::string certified_text(double value, double error, int digits);

/// A value of a summary as text: its certain digits if it has an error, otherwise six digits; "-"
/// if there is none.
std::string text_of(const Json& value, int digits);

/// The number of digits that a summary was asked for; 0 if none.
int asked_digits(const Json& summary);

}  // namespace rotor
