#include "verification/support/follow.hpp"

#include <algorithm>

#include "verification/support/follow_with.hpp"

namespace rotor {

RunEnd follow(const Scenario& scenario, const Instant& from, double until_s, Observer& observer) {
  return follow_with<double>(scenario, scenario.tolerance, from, until_s, observer);
}

Instant mass_lost_at_speed(const Scenario& scenario, double speed) {
  const Parameters& p = scenario.parameters;
  const MassLoss<double> loss(p);
  Instant at = at_rest(p);
  at.body = loss.after;
  at.mass_lost = true;
  at.motor_on = speed < two_pi * p.motor_off_Hz;
  const double offset = std::min(loss.before.eccentricity, 0.9 * Ring<double>(p).clearance);
  at.state = {-offset, 0, 0, 0, loss.velocity_jump(speed), speed};
  return at;
}

Instant pressed_by_whirl(const Scenario& scenario, double speed, double slip) {
  const Parameters& p = scenario.parameters;
  const double clearance = Ring<double>(p).clearance;
  const double tangential = slip - p.rotor_radius * speed;
  const double rho = clearance + p.mass * tangential * tangential / clearance / p.contact_stiffness;
  Instant at = at_rest(p);
  at.contact = slip == 0 ? ContactState::rolling : ContactState::sliding;
  at.state = {rho, 0, 0, 0, tangential - speed * rho, speed};
  return at;
}

}  // namespace rotor
