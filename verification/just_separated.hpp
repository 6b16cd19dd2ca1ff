/// Where the random rotors of the stress test begin, and the tests that it has left.
#pragma once

#include <algorithm>
#include <boost/math/constants/constants.hpp>

#include "model/simulation.hpp"

namespace rotor {

/// Just after the mass loss at a speed in rad/s: self-centred before it as far as the clearance
/// lets it.
inline Instant just_separated(const Scenario& scenario, double speed) {
  const Parameters& p = scenario.parameters;
  const MassLoss<double> loss(p);
  Instant at = start(scenario);
  at.body = loss.after;
  at.separated = true;
  at.motor_on = speed < boost::math::constants::two_pi<double>() * p.motor_off_Hz;
  const double offset = std::min(loss.before.eccentricity, 0.9 * Ring<double>(p).clearance);
  at.state = {-offset, 0, 0, 0, loss.velocity_jump(speed), speed};
  return at;
}

}  // namespace rotor
