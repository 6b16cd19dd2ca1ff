/// The claims of the paper's text, and what becomes of each by the rules of
/// reference-data/policy.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "verification/paper/ensembles.hpp"

namespace rotor {

/// What a number as printed allows by a rule. Throws std::invalid_argument for a rule that does not
/// exist, or a number that is none.
struct Allowed {
  double least, greatest;
  bool holds(double value) const { return least <= value && value <= greatest; }
};
Allowed allowed(const std::string& printed, const std::string& rule);

/// Half a unit of the last digit of a number as printed.
double half_digit(const std::string& printed);

/// One way to read a number, and what it gives.
struct Reading {
  std::string name;
  std::optional<double> converged, by_rk4;  ///< at the inputs as printed
  Spread times, everything;                 ///< over the rounding of the inputs
};

/// Arithmetic on printed numbers, what the paper's method does, or what its equations give.
enum class Kind { arithmetic, method, simulated };

/// A number of a claim, which may have several.
struct Number {
  std::string claim, id, figures, place, says, printed, rule, unit;
  Kind kind = Kind::simulated;
  Allowed allowed{};
  std::vector<Reading> readings;
  std::string expected_verdict, reason;
  std::string verdict;  ///< reproduced, within rounding or refuted
};

/// By the rules of policy.md.
std::string verdict_of(const Number& number);

/// The numbers of the table, each with its verdict, from stored ensembles.
std::vector<Number> judged_numbers(const std::filesystem::path& folder);

/// The table alone, readings without values.
std::vector<Number> read_numbers(const std::filesystem::path& table);

/// The verdict of each claim: the worst one of its numbers.
std::map<std::string, std::string> verdicts_of_claims(const std::vector<Number>& numbers);

/// What the rounding of the inputs can decide, and ensembles have.
std::vector<std::string> readings_to_draw(const std::vector<Number>& numbers);

/// Rows of ensembles.csv: reading by reading, of every number.
std::string ensembles_csv(const std::vector<Number>& numbers, const Draws& times,
                          const Draws& everything);

std::string to_csv(const std::vector<Number>& numbers);

}  // namespace rotor
