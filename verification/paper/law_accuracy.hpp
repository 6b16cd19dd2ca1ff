/// How well the closed forms of model/theory agree with runs of random rotors.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "figures/data/read_csv.hpp"

namespace rotor {

class LawAccuracy {
 public:
  /// Adds a row of a sweep of laws.toml; one that was refused does not count.
  void add(const CsvRow& rotor);

  /// The header row and rows of reference-data/laws.csv.
  std::string csv() const;

 private:
  /// Rotors with an unbalance share from one limit to another; empty: of any.
  struct Group {
    std::string equations, quantity, share_from, share_to;
    auto operator<=>(const Group&) const = default;
  };

  std::map<Group, std::vector<double>> ratios_;  ///< run over law; 1 or 0 if that is a yes or no
};

}  // namespace rotor
