/// The rotor's equations, written down once more: in the stator's axes, with the moments about C.
/// Nothing here is shared with model/. Source:
/// "Overcritical high-speed rotor systems, full annular rub and accident", Sec. 2, and the
/// README beside this for what makes them a Filippov system.
#pragma once

#include <map>
#include <span>

#include "verification/proof/solver.hpp"

namespace proof {

/// An input as the paper prints it, named as the engine's option, and half a unit of its last
/// digit.
struct PrintedInput {
  std::string name, value, rounding;
};
std::span<const PrintedInput> printed_inputs();

/// A run about which something is to be proven.
struct Case {
  std::map<std::string, std::string> inputs;  ///< those that are not as printed
  bool jump_twice = true, whole_gravity_moment = true;
  std::string until = "0.03";  ///< s
  std::string rounding = "0";  ///< inputs lie within this share of their rounding
};

/// What is proven, in the order in which it happens; forces are magnitudes.
struct Findings {
  std::vector<std::pair<std::string, Ball>> quantities;
  long steps = 0;
  Ball reached_s;
  std::string undecided;  ///< what stopped the proof before the end, if anything did
};

Findings prove(const Case& of);

}  // namespace proof
