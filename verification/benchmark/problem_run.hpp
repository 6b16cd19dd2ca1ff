/// A run of a problem of reference-data/problems by the solver of another library: the motion,
/// contact law, events and quantities that the page there states.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "verification/benchmark/solver.hpp"

namespace rotor {

/// From the start of a stretch.
using MakeSolver = std::function<std::unique_ptr<Solver>(const Stretch&, const Newton&)>;

struct Solution {
  std::map<std::string, double> values;  ///< by their names in answers.csv
  long right_hand_sides;
};

/// Throws std::invalid_argument for a mass loss after the start, std::runtime_error if the solver
/// gives up.
Solution solution(const Scenario& scenario, const MakeSolver& make_solver);

}  // namespace rotor
