/// The balances of a run's energy and angular momentum: their values, and what these must be from
/// work and moments of the loads. Computed independently, by quadrature along the motion, without
/// the model's energy by cause (energy.hpp).
#pragma once

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "model/scenario/observer.hpp"
#include "model/scenario/scenario.hpp"
#include "verification/support/contact_formulas.hpp"
#include "verification/support/follow.hpp"

namespace rotor {

class BalanceObserver : public Observer {
 public:
  explicit BalanceObserver(const Scenario& scenario)
      : parameters_(scenario.parameters),
        acting_(scenario.parameters, scenario.equations),
        ring_(scenario.parameters) {
    // The springs' moment about O_a does work at constant speed, too; rest is known to its
    // rounding.
    const Parameters& p = scenario.parameters;
    const double square = p.ring_offset_x * p.ring_offset_x + p.ring_offset_y * p.ring_offset_y;
    largest_ = {1e-6 * p.support_stiffness * square,
                1e-6 * std::sqrt(p.support_stiffness * p.mass) * square};
  }

  bool wants_dense_output(const double& /*from_s*/, const double& /*until_s*/) const override {
    return true;
  }

  void on_step(const DenseOutput& motion) override {
    constexpr unsigned points = 7;  // exact for polynomials of degree 13
    using Rule = boost::math::quadrature::gauss<double, points>;
    const long parts = 1 + motion.arcs / 3;  // of three radians, as precise as rounding there
    const double part = (motion.until_s - motion.from_s) / static_cast<double>(parts);
    for (long n = 0; n < parts; ++n) {
      const double from = motion.from_s + part * static_cast<double>(n);
      const auto rate = [&](double Contents::*of) {
        return Rule::integrate([&](double t) { return rates(motion.at(t)).*of; }, from,
                               from + part);
      };
      expected_.energy += rate(&Contents::energy);
      expected_.angular_momentum += rate(&Contents::angular_momentum);
    }
  }

  /// Starts at the first instant, and again after the mass loss, whose jump is not due to loads.
  void on_instant(const Instant& at) override {
    const Contents now = contents(at);
    if (!begun_ || at.event == Event::mass_loss) {
      expected_ = now;
      begun_ = true;
    }
    largest_.energy = std::max(largest_.energy, std::abs(now.energy));
    largest_.angular_momentum = std::max(largest_.angular_momentum, std::abs(now.angular_momentum));
    residual_.energy = std::max(residual_.energy, std::abs(now.energy - expected_.energy));
    residual_.angular_momentum = std::max(
        residual_.angular_momentum, std::abs(now.angular_momentum - expected_.angular_momentum));
  }

  /// Largest deviation at any event and at the end, relative to the largest content.
  double energy_residual() const { return relative(residual_.energy, largest_.energy); }
  double angular_momentum_residual() const {
    return relative(residual_.angular_momentum, largest_.angular_momentum);
  }

 private:
  struct Contents {
    double energy = 0;            ///< J
    double angular_momentum = 0;  ///< about O_a, N m s
  };

  static double relative(double residual, double content) {
    return residual == 0 ? 0 : residual / content;  // a rotor at rest has nothing to lose
  }

  bool conserves_gravity() const { return acting_.weight.balanced_by_springs; }

  /// Kinetic energy, springs of supports and contact, and gravity if it has a potential.
  Contents contents(const Instant& at) const {
    const Motion<double> m = at.motion();
    const double indentation =
        at.contact == ContactState::free ? 0 : ring_.rim_point(m).indentation;
    const Vector<double> off = m.displacement + parameters_.ring_offset_x * m.down +
                               parameters_.ring_offset_y * quarter_turn(m.down);
    double energy = kinetic_energy(at.body, m) +
                    parameters_.support_stiffness * off.squaredNorm() / 2 +
                    contact_energy_by_formula(parameters_, indentation);
    if (conserves_gravity())
      energy -= at.body.mass * acting_.weight.gravity * m.eccentricity.dot(m.down);
    const double spin = at.body.has_constant_speed() ? 0 : at.body.inertia * m.speed;
    return {energy, at.body.mass * cross(m.mass_centre(), m.mass_centre_velocity()) + spin};
  }

  /// Power and moment of everything that has no potential.
  Contents rates(const Instant& at) const {
    const Motion<double> m = at.motion();
    const Loads<double> acting = acting_.loads(at.body, m, at.motor_on);
    double power = -parameters_.support_damping * m.velocity.squaredNorm() +
                   acting_.constant_moment(at.motor_on) * m.speed;
    if (!conserves_gravity()) power += acting_.weight.loads(at.body, m).moment * m.speed;
    double moment = acting.moment;
    Vector<double> force = acting.force;
    if (at.contact != ContactState::free) {
      const RimPoint<double> k = ring_.rim_point(m);
      if (at.contact == ContactState::indented) {
        power += spring_force_by_formula(parameters_, k.indentation) *
                 k.normal_velocity;  // spring against dashpot
      } else {
        const double normal = ring_.elastic_force(k), friction = friction_at(at, m, k, normal);
        power += -parameters_.contact_damping * k.normal_velocity * k.normal_velocity +
                 friction * k.slip_velocity;
        moment += friction * (k.displacement + ring_.rotor_radius);
        force += normal * k.normal + friction * k.tangent;
      }
    }
    if (at.body.has_constant_speed()) {  // the drive balances the moment about C
      const double drive = cross(m.mass_centre(), force) - moment;
      power += drive * m.speed;
      moment += drive;
    }
    return {power, moment};
  }

  double friction_at(const Instant& at, const Motion<double>& m, const RimPoint<double>& k,
                     double normal) const {
    if (at.contact == ContactState::sliding)
      return ring_.sliding_friction(normal, k.slip_velocity > 0 ? 1 : -1);
    return friction_without_slip(at.body, ring_, m, k, acting_.loads(at.body, m, at.motor_on),
                                 normal);
  }

  Parameters parameters_;
  ActingLoads<double> acting_;
  Ring<double> ring_;
  bool begun_ = false;
  Contents expected_, largest_, residual_;
};

/// A run from an instant to a time, its events and its balances.
class BalancedRun : public BalanceObserver {
 public:
  BalancedRun(const Scenario& scenario, const Instant& from, double until_s)
      : BalanceObserver(scenario) {
    counters_ = follow(scenario, from, until_s, *this).counters;
  }

  void on_instant(const Instant& at) override {
    BalanceObserver::on_instant(at);
    events_.on_instant(at);
  }

  long count(Event kind) const { return events_.count(kind); }
  const Instant& first(Event kind) const { return events_.first(kind); }
  const Instant& last() const { return events_.last(); }
  const Counters& counters() const { return counters_; }

 private:
  EventRecorder events_;
  Counters counters_;
};

}  // namespace rotor
