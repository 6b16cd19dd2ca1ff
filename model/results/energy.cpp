#include "model/results/energy.hpp"

#include <algorithm>
#include <numeric>

#include "model/results/quadrature.hpp"

namespace rotor {
namespace {

EnergyByCause powers(const ActingLoads<double>& acting, const Ring<double>& ring,
                     const Instant& at) {
  const Motion<double> m = at.motion();
  const RimPoint<double> k = ring.rim_point(m);
  EnergyByCause all{.loads = acting.powers(at.body, m, at.motor_on),
                    .contact_damping = ring.damping_power(k, at.contact)};
  Loads<double> loads = acting.loads(at.body, m, at.motor_on);
  if (at.touches()) {
    const double normal = ring.elastic_force(k);
    const bool slides = at.contact == ContactState::sliding;
    const double friction = slides ? ring.sliding_friction(normal, at.slip_sign)
                                   : friction_without_slip(at.body, ring, m, k, loads, normal);
    if (slides) all.friction = k.slip_velocity * friction;
    loads += ring.loads(k, {normal, friction});
  }
  all.drive = drive_power(at.body, m, loads);
  return all;
}

}  // namespace

void EnergyByCause::add(const EnergyByCause& other, double weight) {
  for (std::size_t i = 0; i < loads.size(); ++i) loads[i] += weight * other.loads[i];
  drive += weight * other.drive;
  contact_damping += weight * other.contact_damping;
  friction += weight * other.friction;
}

double EnergyByCause::sum() const {
  return std::accumulate(loads.begin(), loads.end(), drive + contact_damping + friction);
}

double EnergyByCause::of(std::string_view load) const {
  const auto* const found = std::find(loads_by_name.begin(), loads_by_name.end(), load);
  return loads.at(static_cast<std::size_t>(found - loads_by_name.begin()));
}

void EnergyObserver::on_step(const DenseOutput& motion) {
  const long parts = 1 + motion.arcs / 3;  // of three radians
  EnergyByCause work;
  gauss_nodes(motion.from_s, motion.until_s, parts, [&](double time_s, double weight) {
    work.add(powers(acting_, ring_, motion.at(time_s)), weight);
  });
  balance_.work.add(work);
}

void EnergyObserver::on_instant(const Instant& at) {
  const double before = balance_.content();
  const Motion<double> m = at.motion();
  balance_.kinetic = kinetic_energy(at.body, m);
  balance_.support_springs = acting_.supports.potential(at.body, m);
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
