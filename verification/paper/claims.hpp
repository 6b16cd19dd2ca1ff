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

/// One way to read a claim, and what it gives.
struct ClaimReading {
  std::string name;
  std::optional<double> converged, by_rk4;  ///< at the inputs as printed
  Spread times, everything;                 ///< over the rounding of the inputs
};

struct Claim {
  std::string id, figures, place, says, printed, rule, unit;
  bool is_arithmetic = false;
  Allowed allowed{};
  std::vector<ClaimReading> readings;
  std::string expected_verdict, reason;
  std::string verdict;  ///< reproduced, within rounding or refuted
};

/// By the rules of policy.md.
std::string verdict_of(const Claim& claim);

/// The claims of the table, each with its verdict, from stored ensembles.
std::vector<Claim> judged_claims(const std::filesystem::path& folder);

/// The table alone, readings without values.
std::vector<Claim> read_claims(const std::filesystem::path& table);

/// Rows of ensembles.csv: reading by reading, of every claim.
std::string ensembles_csv(const std::vector<Claim>& claims, const Draws& times,
                          const Draws& everything);

std::string to_csv(const std::vector<Claim>& claims);

}  // namespace rotor
