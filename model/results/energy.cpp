#include "model/results/energy.hpp"

#include <boost/math/quadrature/gauss.hpp>

namespace rotor {
namespace {

/// The powers of all that stores no energy, W, in the order of EnergyBalance.
Eigen::Array<double, 5, 1> powers(const Supports<double>& supports, const Ring<double>& ring,
                                  const Instant& at) {
  const Motion<double> m = at.motion();
  const RimPoint<double> k = ring.rim_point(m);
  const double friction =
      at.contact == ContactState::sliding
          ? k.slip_velocity * ring.sliding_friction(ring.elastic_force(k), at.slip_sign)
          : 0;
  return {supports.motor_power(m, at.motor_on), supports.gravity_moment(at.body, m) * m.speed,
          supports.damping_power(m), ring.damping_power(k, at.contact), friction};
}

}  // namespace

void EnergyObserver::on_step(const DenseOutput& motion) {
  using Rule = boost::math::quadrature::gauss<double, 7>;  // exact for polynomials of degree 13
  const long parts = 1 + motion.arcs / 3;                  // of three radians
  const double part = (motion.until_s - motion.from_s) / static_cast<double>(parts);
  Eigen::Array<double, 5, 1> work = Eigen::Array<double, 5, 1>::Zero();
  for (long n = 0; n < parts; ++n) {
    const double middle = motion.from_s + part * (static_cast<double>(n) + 0.5);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      const double away = part / 2 * Rule::abscissa()[i], weight = part / 2 * Rule::weights()[i];
      work += weight * powers(supports_, ring_, motion.at(middle + away));
      if (i > 0) work += weight * powers(supports_, ring_, motion.at(middle - away));
    }
  }
  balance_.motor += work[0];
  balance_.gravity += work[1];
  balance_.support_damping += work[2];
  balance_.contact_damping += work[3];
  balance_.friction += work[4];
}

void EnergyObserver::on_instant(const Instant& at) {
  const double before = balance_.content();
  take_stock(at);
  if (!begun_) {
    const bool is_lost_now = at.event == Event::mass_loss;
    balance_.initial = is_lost_now ? before : balance_.content();
    balance_.mass_loss = balance_.content() - balance_.initial;
    begun_ = is_lost_now || !loses_mass_;
  }
  if (begun_ && at.contact == ContactState::rolling && !until_rolling_) until_rolling_ = balance_;
}

void EnergyObserver::take_stock(const Instant& at) {
  const Motion<double> m = at.motion();
  balance_.kinetic = kinetic_energy(at.body, m);
  balance_.support_springs = supports_.spring_energy(m.displacement);
  balance_.contact_spring = ring_.energy(ring_.rim_point(m), at.contact);
}

}  // namespace rotor
