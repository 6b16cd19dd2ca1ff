/// The paper's reasons for the accident, and its sentences on what matters, tried on many rotors.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/mechanics/parameters.hpp"

namespace rotor {

/// How a statement is judged, along values of one quantity from the least to the most risky one.
/// A rotor counts if the statement could fail on it, and fails it once or not at all.
enum class Judged {
  rolls,     ///< one that rolls goes on to do so
  touches,   ///< one that touches the ring goes on to do so
  force,     ///< the largest force rises from each value at which it rolls to the next
  harmless,  ///< one that touches does not roll
  minor,     ///< the outcome is the same, and the largest force but for 10 %, at each value
  slight,    ///< the same with 5 %; both by reference-data/policy.md
};

struct Reason {
  std::string id, place, says, quantity;
  std::vector<double> values;  ///< of the quantity, SI; of a location, the number of angles
  Judged judged;
};

/// The first columns of reference-data/reasons.csv.
std::vector<Reason> read_reasons(const std::filesystem::path& table);

/// Of each reason, by its id and the equations: on how many rotors it fails, in words, from
/// reference-data/reasons-tried.csv.
std::map<std::pair<std::string, std::string>, std::string> read_shares_that_fail(
    const std::filesystem::path& table);

/// What becomes of a statement.
struct Trial {
  long rotors = 0, fails = 0;  ///< that count, and those of them that fail
  std::vector<long> failing;   ///< at each step from a value to the next; harmless: at each value
  double first = 0, last = 0;  ///< trend: share of the draws that roll, or touch, at the least and
                               ///< at the most risky value; or their mean largest force, kN
  std::string example;         ///< the first draw that fails, as options of `rotor run`

  double share() const;  ///< of those that fail
  double standard_error() const;
};
using Trials = std::map<std::string, Trial>;  ///< by reason

/// Over so many draws of reasons.toml, numbers to four digits, by so many threads.
Trials tried(const std::vector<Reason>& reasons, Equations equations, long draws, int threads);

/// What `make reasons` writes.
std::string to_csv(const std::vector<Reason>& reasons, const Trials& published,
                   const Trials& consistent);

}  // namespace rotor
