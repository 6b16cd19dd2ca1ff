/// The rotor's equations, written down once more: in the stator's axes, with the moments about C.
/// Nothing here is shared with model/. Source:
/// "Overcritical high-speed rotor systems, full annular rub and accident", Sec. 2, and the
/// README beside this for what makes them a Filippov system.
#pragma once

#include <map>
#include <span>

#include "verification/proof/solver.hpp"

namespace proof {

/// An input as the paper prints it, called as the engine's option, and half a unit of its last
/// digit.
struct PrintedInput {
  std::string name, value, rounding;
};
std::span<const PrintedInput> printed_inputs();

enum class Contact { free, sliding, rolling, indented };

/// What is to be proven something of.
struct Case {
  std::map<std::string, std::string> inputs;  ///< those that are not as printed
  bool jump_twice = true, whole_gravity_moment = true;
  std::string until = "0.03";  ///< s
  std::string rounding = "0";  ///< inputs lie within this share of their rounding
};

/// An event, for all inputs the same one.
struct Happening {
  std::string event;
  Ball time_s, speed_Hz, normal_force_N;
};

/// What is proven. Forces are magnitudes.
struct Findings {
  std::vector<Happening> happenings;
  Ball greatest_force_N, greatest_displacement_m;
  bool touches = false;
  long steps = 0;
  Ball reached_s;
  std::string undecided;  ///< what stopped the proof before the end, if anything did
};

Findings prove(const Case& of);

}  // namespace proof
