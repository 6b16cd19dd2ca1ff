/// Where the rotor can whirl along the ring, in closed form: backward, sliding or rolling, and
/// forward with its unbalance. README.md beside this file derives the formulas.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "model/mechanics/contact.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {

/// The rotor after its mass loss. Throws std::domain_error unless the ring is linear and centred.
class Whirl {
 public:
  explicit Whirl(const Parameters& p)
      : body_(MassLoss<double>(p).after),
        stiffness_(Supports<double>(p).required_centred().stiffness),
        damping_(p.support_damping),
        ring_(p),
        contact_stiffness_(ring_.law.required_linear().stiffness),
        contact_damping_(ring_.law.required_linear().damping) {}

  /// Backward sliding whirl in contact grows above this rate and dies below it, rad/s.
  double separatrix_rate(double friction) const {
    const double braking = damping_ > 0 ? damping_ / (2 * body_.mass * friction) : 0;
    return braking + std::hypot(natural_frequency(stiffness_, body_.mass), braking);
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
    return damping_ * rate / pressure / (1 + rim / body_.inertia);
  }

  /// The friction up to which forward synchronous rub exists at a speed, with the indentation
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

  /// rho of the circle of that rub at a constant speed, the larger one if there are two: the root
  /// of |k - m w^2 + k_t x + i (d w + mu k_t x)| rho = m w^2 e with x = 1 - c/rho, m.
  std::optional<double> synchronous_radius(double speed, double friction) const {
    const double force = body_.mass * speed * speed * body_.eccentricity;
    const double softness = stiffness_ - body_.mass * speed * speed, drag = damping_ * speed;
    const double along = softness + contact_stiffness_,
                 across = drag + friction * contact_stiffness_;
    // A quadratic equation of the indentation, with the forces at none.
    const double along_0 = softness * ring_.clearance, across_0 = drag * ring_.clearance;
    const double a = along * along + across * across, b = along * along_0 + across * across_0,
                 c = along_0 * along_0 + across_0 * across_0 - force * force;
    const double indentation = (std::sqrt(b * b - a * c) - b) / a;  // NaN if there is no circle
    return indentation >= 0 ? std::optional(ring_.clearance + indentation) : std::nullopt;
  }

  /// The least friction, looked for in steps of 2 %, at which a small disturbance of that circle
  /// grows, by Routh and Hurwitz; infinite if none up to 10 does as long as there is a circle.
  double stable_synchronous_friction(double speed) const {
    constexpr double most = 10, ratio = 1.02;
    double low = 0, high = 1e-6;
    while (high < most && disturbances_decay(speed, high)) {
      low = high;
      high *= ratio;
    }
    const auto up_to = [&](const auto& holds) {
      double from = low, to = high;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = (from + to) / 2;
        (holds(speed, middle) ? from : to) = middle;
      }
      return to;
    };
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (high >= most) return infinite;
    const auto exists = [this](double w, double mu) { return bool(synchronous_radius(w, mu)); };
    const double end = exists(speed, high) ? infinite : up_to(exists);
    const double stable = up_to([this](double w, double mu) { return disturbances_decay(w, mu); });
    constexpr double rounding = 1e-6;  // where two circles meet and both end
    if (stable < (1 - rounding) * end) return stable;
    return infinite;
  }

 private:
  /// Of the circle at constant speed, in axes that turn with it: all roots of
  ///   (m s^2 + (d + d_t) s + K_n) (m s^2 + d s + K_t)
  ///     + (2 m w s + d w + mu k_t x) ((2 m w + mu d_t) s + d w + mu k_t)
  /// with K_n = k + k_t - m w^2 and K_t = k + k_t x - m w^2 have negative real parts.
  bool disturbances_decay(double speed, double friction) const {
    const auto radius = synchronous_radius(speed, friction);
    if (!radius) return false;
    const double m = body_.mass, d = damping_, d_n = d + contact_damping_;
    const double pressed = contact_stiffness_ * (1 - ring_.clearance / *radius);
    const double K_n = stiffness_ + contact_stiffness_ - m * speed * speed,
                 K_t = stiffness_ + pressed - m * speed * speed;
    const double turn = 2 * m * speed, turn_n = turn + friction * contact_damping_;
    const double cross_t = d * speed + friction * pressed,
                 cross_n = d * speed + friction * contact_stiffness_;
    const double a4 = m * m, a3 = m * (d + d_n), a2 = m * (K_n + K_t) + d * d_n + turn * turn_n,
                 a1 = d_n * K_t + d * K_n + turn * cross_n + cross_t * turn_n,
                 a0 = K_n * K_t + cross_t * cross_n;
    return a3 > 0 && a2 > 0 && a1 > 0 && a0 > 0 && a3 * a2 * a1 > a4 * a1 * a1 + a3 * a3 * a0;
  }

  Body<double> body_;
  double stiffness_, damping_;
  Ring<double> ring_;
  double contact_stiffness_, contact_damping_;
};

}  // namespace rotor
