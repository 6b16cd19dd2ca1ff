/// Whether a motor turns the rotor over its weight from rest.
#pragma once

#include "model/scenario/scenario.hpp"

namespace rotor {

/// The greatest (1 - cos t)/t, where tan(t/2) = t.
inline constexpr double lifting_share = 0.7246113537767085;

/// The torque, N m, above which C comes over O: from rest, with C below O, the motor gives M t up
/// to the angle t, and the weight takes m g e_x (1 - cos t). The supports' motion is neglected.
inline double lifting_torque(const Parameters& p) {
  return lifting_share * p.mass * p.gravity * p.eccentricity;
}

/// Whether the motor swings the rotor as a pendulum.
inline bool swings(const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  return p.drive == Drive::motor && scenario.start_speed_Hz == 0 && p.torque > 0 &&
         p.torque < lifting_torque(p);
}

}  // namespace rotor
