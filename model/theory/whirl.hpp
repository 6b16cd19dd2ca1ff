/// Where the rotor can whirl along the ring, in closed form: backward, sliding or rolling, and
/// forward with its unbalance. README.md beside this file derives the formulas.
#pragma once

#include <cmath>
#include <limits>

#include "model/mechanics/contact.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {

/// The rotor after its mass loss. Throws std::domain_error unless the ring is linear.
class Whirl {
 public:
  explicit Whirl(const Parameters& p)
      : body_(MassLoss<double>(p).after),
        stiffness_(p.support_stiffness),
        damping_(p.support_damping),
        ring_(p),
        contact_stiffness_(ring_.law.linear("the whirl along the ring").stiffness) {}

  /// Backward sliding whirl in contact grows above this rate and dies below it, rad/s.
  double separatrix_rate(double friction) const {
    const double braking = damping_ > 0 ? damping_ / (2 * body_.mass * friction) : 0;
    return braking + std::hypot(natural_rate(), braking);
  }

  /// Below this friction backward sliding whirl dies at any rate.
  double whip_friction() const {
    return damping_ * natural_frequency(stiffness_ + contact_stiffness_, body_.mass) /
           contact_stiffness_;
  }

  /// The rate of backward rolling at a speed, both in rad/s: the root of r w = Omega rho(Omega).
  double rolling_rate(double speed) const {
    const double b = ring_.clearance * contact_stiffness_, rim = ring_.rotor_radius * speed;
    const double c = rim * (contact_stiffness_ + stiffness_);
    return 2 * c / (b + std::sqrt(b * b + 4 * body_.mass * rim * c));
  }

  /// s of backward rolling at a rate in rad/s.
  double shrinking(double rate) const {
    const double inertia_force = body_.mass * rate * rate;
    return 2 * inertia_force / (stiffness_ + contact_stiffness_ - inertia_force);
  }

  /// The friction that backward rolling needs at a speed; infinite where it would leave the ring.
  double rolling_friction(double speed) const {
    const double rate = rolling_rate(speed), pressure = body_.mass * rate * rate - stiffness_;
    if (!(pressure > 0)) return std::numeric_limits<double>::infinity();
    const double r = ring_.rotor_radius, s = shrinking(rate);
    const double rim = body_.mass * r * r * (1 + 2 * s) / (1 + s);
    return body_.inertia / (body_.inertia + rim) * damping_ * rate / pressure;
  }

  /// The friction up to which forward synchronous rub can last at a speed, with the indentation
  /// neglected beside the clearance: 0 if the unbalance cannot overcome the damping and also press
  /// O against the ring, infinite if it overcomes any friction.
  double synchronous_friction(double speed) const {
    const double inertia_force = body_.mass * speed * speed;
    const double unbalance = inertia_force * body_.eccentricity / ring_.clearance;
    const double pressure = inertia_force - stiffness_, drag = damping_ * speed;
    const double slowing = body_.mass * ring_.rotor_radius * ring_.clearance / body_.inertia;
    // Negative where the unbalance exceeds the damping as N tends to 0: then any mu is possible.
    const double excess = pressure * pressure + drag * drag - unbalance * unbalance;
    constexpr double any = std::numeric_limits<double>::infinity();
    if (slowing > 1) {  // mu' is negative, and its greatest size at the least left-hand side
      if (pressure <= unbalance) return pressure > -unbalance ? any : 0;
      const double effective = (pressure * drag + unbalance * std::sqrt(excess)) /
                               (pressure * pressure - unbalance * unbalance);
      return effective / (slowing - 1);
    }
    if (drag >= unbalance || (pressure <= 0 && excess >= 0)) return 0;
    if (excess <= 0 || slowing == 1) return any;
    // The greatest left-hand side over phi: mu' pressure + drag = unbalance sqrt(1 + mu'^2).
    const double effective =
        (unbalance * unbalance - drag * drag) / (pressure * drag + unbalance * std::sqrt(excess));
    return effective / (1 - slowing);
  }

 private:
  double natural_rate() const { return natural_frequency(stiffness_, body_.mass); }

  Body<double> body_;
  double stiffness_, damping_;
  Ring<double> ring_;
  double contact_stiffness_;
};

}  // namespace rotor
