/// The rotor's equations, written independently of model/: in the stator's axes, with the moments
/// about C. Source: "Overcritical high-speed rotor systems, full annular rub and accident", Sec. 2,
/// and the README of this folder for the Filippov system.
#pragma once

#include <map>

#include "verification/proof/solver.hpp"

namespace proof {

/// As printed, and half a unit of its last digit.
struct Input {
  std::string value, rounding;
};

/// A run about which something is to be proven. Inputs have the names of the engine's options.
struct Case {
  std::map<std::string, Input> inputs = {
      {"mass", {"5", "0.5"}},
      {"inertia", {"9e-3", "0.005e-3"}},
      {"eccentricity", {"0.15e-3", "0.005e-3"}},
      {"support-stiffness", {"20e3", "500"}},
      {"support-damping", {"25", "0.5"}},
      {"gravity", {"9.81", "0.005"}},
      {"torque", {"0.3", "0.05"}},
      {"motor-off-Hz", {"150", "0"}},
      {"contact-stiffness", {"8e8", "0.5e8"}},
      {"contact-damping", {"1e4", "0.5e4"}},
      {"friction", {"0.3", "0.05"}},
      {"rotor-radius", {"0.06", "0.0005"}},
      {"clearance", {"0.003", "0.0005"}},
      {"unbalance-factor", {"3", "0.004"}},
      {"start-speed-Hz", {"0", "0.5"}},
      {"mass-loss-time", {"29.1", "0.05"}},
      {"until", {"0.03", "0"}},
  };
  std::string rounding = "0";  ///< the inputs lie within this share of theirs
  bool published = true;       ///< the equations as printed, or else the corrected ones
};

/// Quantities in the order of their proof, with the engine's names; forces are magnitudes.
using Findings = std::vector<std::pair<std::string, Ball>>;

/// Throws Undecided, with the time that was reached.
Findings prove(const Case& of);

}  // namespace proof
