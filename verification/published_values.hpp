/// The numbers that the paper's text states, and what the model makes of each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rotor {

/// A row of reference-data/published-values.csv, and our value.
struct PublishedValue {
  std::string id, place, quantity;
  std::string printed;  ///< the digits, or the words
  std::string unit;
  double least = 0, greatest = 0;  ///< what the digits or the stated range allow
  std::string expected_verdict;
  std::string reason;  ///< why it is not reproduced

  std::optional<double> computed;
  std::string verdict;  ///< reproduced, close, differs or excused
};

/// Reads the table and computes every row. Throws std::runtime_error, naming file and line, for a
/// row that is not well formed.
std::vector<PublishedValue> published_values(const std::filesystem::path& table);

/// The ids for which there is a computation.
std::vector<std::string> computed_ids();

std::string to_csv(const std::vector<PublishedValue>& values);

}  // namespace rotor
