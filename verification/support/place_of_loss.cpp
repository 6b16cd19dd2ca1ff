#include "verification/support/place_of_loss.hpp"

#include <cmath>

namespace rotor {

double lost_mass_by_formula(const Parameters& p) {
  const double e_1 = p.unbalance_factor * p.eccentricity;
  return p.stated_lost_mass().value_or(p.mass * (e_1 - p.eccentricity) /
                                       (p.rotor_radius + e_1));  // Eq. (5)
}

PlaceOfLoss::PlaceOfLoss(const Parameters& p, double angle)
    : PlaceOfLoss(p, angle, lost_mass_by_formula(p)) {}

PlaceOfLoss::PlaceOfLoss(const Parameters& p, double angle, double lost_mass)
    : lost_mass_(lost_mass),
      piece_(-p.rotor_radius * Vector<double>(std::cos(angle), std::sin(angle))) {
  const Vector<double> before(p.eccentricity, 0);
  after_.mass = p.mass - lost_mass_;
  eccentricity_ = (p.mass * before - lost_mass_ * piece_) / after_.mass;
  shift_ = eccentricity_ - before;
  after_.eccentricity = eccentricity_.norm();
  after_.inertia = Body<double>::of(p).inertia - lost_mass_ * (piece_ - before).squaredNorm() -
                   after_.mass * shift_.squaredNorm();  // Eqs. (8), (11)
}

Instant PlaceOfLoss::lose_mass(Instant at, Equations equations) const {
  State<double>& q = at.state;
  Vector<double> velocity(q[3], q[4]);
  if (equations.velocity_jump == VelocityJump::twice) velocity += q[5] * quarter_turn(shift_);
  const double cosine = eccentricity_.x() / after_.eccentricity;
  const double sine = eccentricity_.y() / after_.eccentricity;
  const Vector<double> displacement = turned<double>({q[0], q[1]}, cosine, -sine);
  velocity = turned<double>(velocity, cosine, -sine);
  q = {displacement.x(), displacement.y(), q[2] + std::atan2(sine, cosine),
       velocity.x(),     velocity.y(),     q[5]};
  at.body = after_;
  at.mass_lost = true;
  at.event = Event::mass_loss;
  return at;
}

}  // namespace rotor
