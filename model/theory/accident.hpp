/// The accident in closed forms: whether the rotor touches the ring after its mass loss, above
/// which friction it rolls, at what speed rolling begins, and how large the force becomes. The
/// README.md of this folder derives them and has the same equation numbers.
#pragma once

#include "model/theory/mass_loss_response.hpp"
#include "model/theory/whirl.hpp"

namespace rotor {

/// How far an oscillator of damping ratio zeta > 0 swings after a blow, over v / w_0.
inline double swing_after_blow(double zeta) {
  if (zeta == 1) return std::exp(-1);
  const double root = std::sqrt(std::abs(1 - zeta * zeta));
  return std::exp(-zeta / root * (zeta < 1 ? std::acos(zeta) : std::acosh(zeta)));
}

/// The largest force of spring and dashpot together after that blow, over k v / w_0.
inline double impact(double zeta) {
  if (zeta >= 0.5) return 2 * zeta;
  return std::exp(-zeta / std::sqrt(1 - zeta * zeta) * (3 * std::acos(zeta) - std::numbers::pi));
}

/// The friction above which rebounds, after an impact with a normal velocity, bring O to where
/// backward whirl grows; (2).
inline double whirling_friction(const Parameters& p, double mass, double velocity,
                                double restitution) {
  const double kicks = velocity * (1 + restitution) / (1 - restitution);
  const double way = Ring<double>(p).clearance / kicks;
  return std::sqrt(way * (way * p.support_stiffness + p.support_damping) / mass);
}

/// SI units; speeds and rates in rad/s. Empty: does not happen.
struct Accident {
  std::optional<double> contact_speed;    ///< by (1)
  double reach;                           ///< largest |r_O| without a ring, m; at constant speed
  std::optional<double> contact_s;        ///< first contact after the loss
  std::optional<double> impact_force;     ///< of that contact, N
  std::optional<double> whirl_friction;   ///< above which rebounds may lead to backward whirl; (2)
  double forward_friction;                ///< up to which there is forward rub
  double stable_forward_friction;         ///< up to which it returns after a small disturbance
  std::optional<double> rolling_speed;    ///< of the rotor when rolling begins; (3)
  std::optional<double> whirl_rate;       ///< of O when rolling begins
  std::optional<double> rolling_force;    ///< largest normal force in rolling, N; (4)
  std::optional<double> unbalance_share;  ///< kappa e_x1/(mu r), which (3) and (4) neglect

  /// Of a rotor that loses the piece in steady response at a speed. Throws as MassLossResponse.
  Accident(const Parameters& p, Equations equations, double speed)
      : forward_friction(Whirl(p).synchronous_friction(speed)),
        stable_forward_friction(Whirl(p).stable_synchronous_friction(speed)) {
    const Body<double> body = MassLoss<double>(p).after;
    const MassLossResponse response(p, equations, speed);
    const Whirl whirl(p);
    const Ring<double> ring(p);
    const double m = body.mass, e_1 = body.eccentricity, r = ring.rotor_radius, c = ring.clearance;
    const double k = p.support_stiffness;
    const auto [k_t, d_t] = ring.law.required_linear();
    const double natural = natural_frequency(k, m), d = p.support_damping;
    const double jumps = equations.velocity_jump == VelocityJump::twice ? 2 : 1;
    const double limit =
        natural * (c - e_1) /
        (jumps * (e_1 - p.eccentricity) * swing_after_blow(d / (2 * m * natural)));  // (1)
    if (limit > natural) contact_speed = limit;
    reach = response.greatest();
    contact_s = response.first_contact();
    if (!contact_s) return;

    using Complex = MassLossResponse::Complex;
    const Complex outwards = response.position(*contact_s) / c, i(0, 1);
    const Complex v_O = response.velocity(*contact_s) * std::conj(outwards);
    const Complex v_C =
        v_O + i * speed * e_1 * std::exp(i * speed * *contact_s) * std::conj(outwards);
    const double contact_rate = natural_frequency(k_t, m);
    const double zeta = d_t / (2 * m * contact_rate);
    impact_force = k_t * v_O.real() / contact_rate * impact(zeta);
    whirl_friction =
        whirling_friction(p, m, v_O.real(), swing_after_blow(zeta) * swing_after_blow(zeta));
    if (!(ring.friction > 0)) return;

    const double kappa = m * r * r / body.inertia, stiffness = k_t + k;
    const double least_rate = whirl.separatrix_rate(ring.friction);
    const auto softness = [&](double rate) { return rate * std::sqrt(m / stiffness); };
    const auto momentum = [&](double w) {
      const double rate = whirl.rolling_rate(w), x = softness(rate);
      const double drag = d * c / ring.friction * std::log(std::max(1., rate / least_rate));
      return w * (1 + kappa * (2 - (1 - x * x) * std::atanh(x) / x)) + drag * r / body.inertia;
    };
    const double given = speed - m * v_C.imag() * r / body.inertia;  // over I/r
    double low = 0, high = given;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (momentum(middle) < given ? low : high) = middle;  // (3)
    }
    const double rate = whirl.rolling_rate(high), x = softness(rate), s = whirl.shrinking(rate);
    if (!(rate > least_rate)) return;
    rolling_speed = high;
    whirl_rate = rate;
    const double rho = r * high / rate, normal_force = k_t * (rho - c);
    const double drift = s / (1 + 2 * s) * ring.friction * normal_force / (m * rate);
    const double radial_rate = rate * std::sqrt(1 / (x * x) + 1 + 2 * kappa / (1 + kappa));
    rolling_force = normal_force + k_t * drift / radial_rate *
                                       swing_after_blow(d_t / (2 * m * radial_rate));  // (4)
    unbalance_share = kappa * e_1 / (ring.friction * r);
  }

  /// Up to which forward rub can last.
  double lasting_friction() const { return std::min(forward_friction, stable_forward_friction); }

  /// The larger of impact and rolling force.
  std::optional<double> peak_force() const {
    return rolling_force ? std::optional(std::max(*rolling_force, *impact_force)) : std::nullopt;
  }
};

}  // namespace rotor
