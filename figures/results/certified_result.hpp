/// What a run says of itself whose digits are sure.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "figures/results/run_result.hpp"
#include "model/certified/digits.hpp"

namespace rotor {

/// double, extended or quadruple.
std::string_view name_of(Precision precision);

/// A value of which fewer digits are sure than were asked for.
struct ShortOfDigits {
  std::string value;
  int digits;
};
std::vector<ShortOfDigits> short_of_digits(const Comparison& comparison, int digits);

/// Why digits that were asked for are not sure; empty if all are.
std::string complaint(const Comparison& comparison, int digits);

/// The finest computation's, as if it were the only one.
RunResult result_of(const Comparison& comparison, const Scenario& scenario);

/// As of an RunResult, but each number of the run with its error, and the events.
nlohmann::ordered_json to_json(const Comparison& comparison, const Scenario& scenario, int digits);

/// So many significant digits of a number, zeros among them.
std::string rounded_to(double value, int digits);

/// What is printed for a number of which no digit is sure.
inline constexpr std::string_view no_sure_digit = "?";

/// So many digits of a number at most as it has whatever it is within its error.
std::string certified_text(double value, double error, int digits);

/// A value of a summary as text, "-" if there is none: if it has an error, its sure digits; other
/// numbers have six.
std::string text_of(const nlohmann::ordered_json& value, int digits);

/// How many digits were asked for in a summary; 0 if none were.
int asked_digits(const nlohmann::ordered_json& summary);

}  // namespace rotor
