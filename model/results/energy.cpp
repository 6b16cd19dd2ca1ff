#include "model/results/energy.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace rotor {
namespace {

/// The powers of all that stores no energy, W, in the order of EnergyBalance.
Eigen::Array<double, 6, 1> powers(const Supports<double>& supports, const Ring<double>& ring,
                                  const Instant& at) {
  const Motion<double> m = at.motion();
  const RimPoint<double> k = ring.rim_point(m);
  Loads<double> loads = supports.loads(at.body, m, at.motor_on);
  double friction = 0;
  if (at.touches()) {
    const double normal = ring.elastic_force(k);
    friction = at.contact == ContactState::sliding
                   ? ring.sliding_friction(normal, at.slip_sign)
                   : friction_without_slip(at.body, ring, m, k, loads, normal);
    loads += ring.loads(k, {normal, friction});
  }
  // A drive that holds the speed balances the moment of all loads about C.
  const double moment = loads.moment - cross(m.mass_centre(), loads.force);
  return {supports.motor_power(m, at.motor_on),
          at.body.has_constant_speed() ? -moment * m.speed : 0,
          supports.gravity_moment(at.body, m) * m.speed,
          supports.damping_power(m),
          ring.damping_power(k, at.contact),
          at.contact == ContactState::sliding ? k.slip_velocity * friction : 0};
}

}  // namespace

void EnergyObserver::on_step(const DenseOutput& motion) {
  using Rule = boost::math::quadrature::gauss<double, 7>;  // exact for polynomials of degree 13
  const long parts = 1 + motion.arcs / 3;                  // of three radians
  const double part = (motion.until_s - motion.from_s) / static_cast<double>(parts);
  Eigen::Array<double, 6, 1> work = Eigen::Array<double, 6, 1>::Zero();
  for (long n = 0; n < parts; ++n) {
    const double middle = motion.from_s + part * (static_cast<double>(n) + 0.5);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double away = part / 2 * Rule::abscissa()[i], weight = part / 2 * Rule::weights()[i];
      work += weight * powers(supports_, ring_, motion.at(middle + away));
      if (i > 0) work += weight * powers(supports_, ring_, motion.at(middle - away));
    }
  }
  balance_.motor += work[0];
  balance_.drive += work[1];
  balance_.gravity += work[2];
  balance_.support_damping += work[3];
  balance_.contact_damping += work[4];
  balance_.friction += work[5];
}

void EnergyObserver::on_instant(const Instant& at) {
  const double before = balance_.content();
  const Motion<double> m = at.motion();
  balance_.kinetic = kinetic_energy(at.body, m);
  balance_.support_springs = supports_.spring_energy(m.displacement);
  balance_.contact_spring = ring_.energy(ring_.rim_point(m), at.contact);
  if (!begun_) {
    const bool is_lost_now = at.event == Event::mass_loss;
    balance_.initial = is_lost_now ? before : balance_.content();
    balance_.mass_loss = balance_.content() - balance_.initial;
    begun_ = is_lost_now || !loses_mass_;
  }
  if (begun_ && at.contact == ContactState::rolling && !until_rolling_) until_rolling_ = balance_;
}

}  // namespace rotor
