/// Random rotors: every input has a range from which it is drawn.
#pragma once

#include <random>

#include "figures/runs/run_ups.hpp"

namespace rotor {

class RandomInputs {
 public:
  explicit RandomInputs(unsigned seed) : random_(seed) {}

  /// What is stated of a rotor: from the middle part, in logarithm, of each range; one of the
  /// inputs that determine the same number. Throws std::logic_error if an input has no range.
  ScenarioSpec spec(double part = 1);

  /// The first of such rotors whose numbers and start are physical, and what was stated of it.
  struct Rotor {
    ScenarioSpec stated;
    Scenario scenario;
  };
  Rotor rotor(double part = 1, const ScenarioSpec& fixed = {});
  Scenario scenario() { return rotor().scenario; }

  double between(double least, double greatest);  ///< uniform in the logarithm
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }

 private:
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }

  std::mt19937_64 random_;
};

/// The options that state the same to `rotor run`.
std::string options_of(const ScenarioSpec& spec);

}  // namespace rotor
