/// A piece that is lost from any point of the rim, not from the one opposite to the unbalance
/// alone.
#pragma once

#include <cmath>

#include "model/simulation/instant.hpp"
#include "model/simulation/start.hpp"

namespace rotor {

/// The rotor just after it has lost, in the steady response that the scenario starts with, a mass
/// at an angle from its x axis: pi is the paper's point. C moves to C_1, and the model, which has
/// its mass centre on the x axis, goes on with axes that are turned by the direction of C_1 from O:
/// contact and supports are the same in any axes.
inline Instant lost_elsewhere(const Scenario& scenario, double lost_mass, double angle) {
  Instant at = start_of(scenario);
  const Body<double> before = at.body;
  const Vector<double> C(before.eccentricity, 0);
  const Vector<double> D =
      scenario.parameters.rotor_radius * Vector<double>(std::cos(angle), std::sin(angle));
  const double mass = before.mass - lost_mass;
  const Vector<double> C_1 = (before.mass * C - lost_mass * D) / mass, shift = C_1 - C;
  at.body = {mass, before.inertia - lost_mass * (D - C).squaredNorm() - mass * shift.squaredNorm(),
             C_1.norm()};
  Vector<double> q(at.state[0], at.state[1]), rate(at.state[3], at.state[4]);
  const double speed = at.state[5];
  // As printed: what the new place of the mass centre adds to its velocity, once more.
  if (scenario.equations.velocity_jump == VelocityJump::twice) rate += speed * quarter_turn(shift);
  const double turn = std::atan2(C_1.y(), C_1.x());
  q = turned<double>(q, std::cos(turn), -std::sin(turn));
  rate = turned<double>(rate, std::cos(turn), -std::sin(turn));
  at.state = {q.x(), q.y(), turn, rate.x(), rate.y(), speed};
  at.separated = true;
  at.motor_on = false;
  return at;
}

}  // namespace rotor
