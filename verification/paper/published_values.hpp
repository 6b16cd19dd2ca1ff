/// The numbers that the paper's text states, and what the model makes of each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotor {

/// A row of reference-data/published-values.csv, and our value.
struct PublishedValue {
  std::string id, place;
  std::string kind;  ///< arithmetic or simulated
  std::string quantity;
  std::string printed;  ///< the digits, or the words
  std::string unit;
  double least = 0, greatest = 0;  ///< what the digits or the stated range allow
  std::string expected_verdict;
  std::string refuted_by;  ///< a test that shows why it cannot be
  std::string reason;      ///< why it is not reproduced

  double computed = 0;
  std::string verdict;  ///< reproduced, close, differs or refuted
};

/// Reads the table and computes every row. Throws std::runtime_error, naming file and line, for a
/// row that is not well formed or that nothing computes.
std::vector<PublishedValue> published_values(const std::filesystem::path& table);

/// The ids for which there is a computation.
std::vector<std::string> computed_ids();

std::string to_csv(const std::vector<PublishedValue>& values);

}  // namespace rotor
