/// Contact of the rotor's rim with the stator ring: a spring and a dashpot along the normal,
/// Coulomb friction across it. Source: "Overcritical high-speed rotor systems, full annular rub and
/// accident", Sec. 2.3, Eqs. (15)-(25).
#pragma once

#include <algorithm>
#include <limits>

#include "model/mechanics/contact_law.hpp"
#include "model/mechanics/loads.hpp"

namespace rotor {

/// State of the contact at one instant.
enum class ContactState {
  free,      ///< clear of the ring
  sliding,   ///< in contact, the rim slides along the ring
  rolling,   ///< in contact, the rim does not slide
  indented,  ///< no force, but the ring's contact spot has not sprung back yet (Delta > 0)
};

/// Whether the rim is pressed against the ring.
inline bool touches(ContactState contact) {
  return contact == ContactState::sliding || contact == ContactState::rolling;
}

/// Kinematics of the rim point K nearest to the ring. Only meaningful for a displaced rotor
/// (rho > 0), which every contact implies.
template <class S>
struct RimPoint {
  Vector<S> normal;   ///< from O_a through O to K
  Vector<S> tangent;  ///< normal turned by a quarter turn in the sense of q3
  S displacement;     ///< rho, m
  S indentation;      ///< Delta, m; negative while there is a gap
  S normal_velocity;  ///< v_Kn = Delta', m/s
  S slip_velocity;    ///< v_Ktau, of the rim relative to the ring, m/s
};

/// Forces at K: F_n along the normal, negative in compression as in the paper, and F_tau along the
/// tangent (N).
template <class S>
struct ContactForces {
  S normal;
  S friction;
};

template <class S>
struct Ring {
  S rotor_radius;  ///< r, m
  S clearance;     ///< r_a - r, m
  ContactLaw<S> law;
  S friction;  ///< mu

  explicit Ring(const Parameters& p)
      : rotor_radius(as_typed<S>(p.rotor_radius)),
        clearance(clearance_of(p)),
        law(p),
        friction(as_typed<S>(p.friction)) {}

  /// Double precision uses r_a, so that both inputs give identical runs.
  static S clearance_of(const Parameters& p) {
    if constexpr (!std::is_same_v<S, double>)
      if (const auto stated = p.stated_clearance()) return as_typed<S>(*stated);
    return as_typed<S>(p.stator_radius) - as_typed<S>(p.rotor_radius);
  }

  bool is_clear_of(const Motion<S>& motion) const {
    return motion.displacement.squaredNorm() <= clearance * clearance;
  }

  RimPoint<S> rim_point(const Motion<S>& motion) const {
    const S rho = motion.displacement.norm();
    const Vector<S> normal = motion.displacement / rho;  // Eq. (18)
    const Vector<S> tangent = quarter_turn(normal);
    return {.normal = normal,
            .tangent = tangent,
            .displacement = rho,
            .indentation = rho - clearance,  // Eq. (20)
            .normal_velocity = normal.dot(motion.velocity),
            .slip_velocity =
                tangent.dot(motion.velocity) + rotor_radius * motion.speed};  // Eqs. (15)-(19)
  }

  /// F_n as long as the ring is pressed, N. The ring cannot pull: a positive value means no force.
  S elastic_force(const RimPoint<S>& k) const {
    return law.force(k.indentation, k.normal_velocity);
  }

  /// F_n of a rim that is known to touch: at a touch-down, rounding may still show a gap.
  S touching_force(const RimPoint<S>& k) const {
    using std::min;
    return min<S>(S(0), elastic_force(k));
  }

  /// F_n, zero while a ring that is still indented would have to pull.
  S normal_force(const RimPoint<S>& k) const {
    return k.indentation <= 0 ? S(0) : touching_force(k);
  }

  /// The contact of a rim over an indented ring, with slip if it presses: it does not where it
  /// moves back so fast that the dashpot would have to pull it.
  ContactState contact_of(const RimPoint<S>& k) const {
    const bool pulls = law.has_dashpot() && law.pressing(k.indentation, k.normal_velocity) < 0;
    return pulls ? ContactState::indented : ContactState::sliding;
  }

  /// Slope of the force at the indentations of impacts, N/m: that of a linear ring at any.
  S typical_stiffness() const {
    return law.is_linear() ? law.linear().stiffness : law.tangent_stiffness(clearance / 100);
  }

  /// A time that is short beside that since the indentation was zero, or until it is, s, but
  /// changes it by far more than rounding; infinite if the force is smooth there.
  S smooth_time(const RimPoint<S>& k) const {
    if (law.is_linear()) return std::numeric_limits<S>::infinity();
    const S depth =
        std::max<S>(k.indentation, 20'000 * std::numeric_limits<S>::epsilon() * clearance);
    return depth / (k.normal_velocity > 0 ? 2 * k.normal_velocity : -3 * k.normal_velocity);
  }

  /// Energy of the ring's spring, J.
  S energy(const RimPoint<S>& k, ContactState contact) const {
    return contact == ContactState::free ? S(0) : law.energy(k.indentation);
  }

  /// Power of the damper, W, while the rim presses it and while the ring's spring pushes it back.
  S damping_power(const RimPoint<S>& k, ContactState contact) const {
    switch (contact) {
      case ContactState::free:
        return S(0);
      case ContactState::indented:
        return law.spring_force(k.indentation) * k.normal_velocity;
      case ContactState::sliding:
      case ContactState::rolling:
        return -law.damping() * k.normal_velocity * k.normal_velocity;
    }
    return S(0);
  }

  /// F_tau against a sliding rim. `slip_sign` is that of the slip velocity.
  S sliding_friction(const S& normal_force, int slip_sign) const {
    return S(slip_sign) * friction * normal_force;  // Eqs. (22)-(24): F_n < 0
  }

  /// Generalised forces of the contact. F_n passes through O_a and has no moment about it.
  Loads<S> loads(const RimPoint<S>& k, const ContactForces<S>& forces) const {
    const Vector<S> friction_force = forces.friction * k.tangent;
    return {forces.normal * k.normal + friction_force,
            forces.friction * (k.displacement + rotor_radius)};  // Eq. (25)
  }

  /// Arm of the friction force about C, m.
  S friction_arm(const Motion<S>& motion, const RimPoint<S>& k) const {
    return rotor_radius - motion.eccentricity.dot(k.normal);
  }
};

/// 1/m_tau: how much the slip acceleration changes per newton of friction with that arm, 1/kg.
template <class S>
S slip_mobility(const Mobility<S>& body, const S& friction_arm) {
  return body.per_mass + body.per_inertia * friction_arm * friction_arm;
}

/// F_tau in rolling: the friction that keeps v_Ktau constant, given the loads of the supports and
/// F_n. Without friction, O accelerates as C and the rotation say, and the tangent turns with the
/// whirl of O.
template <class S>
S friction_without_slip(const std::type_identity_t<Mobility<S>>& body, const Ring<S>& ring,
                        const Motion<S>& motion, const RimPoint<S>& k, const Loads<S>& supports,
                        const S& normal_force) {
  Loads<S> loads = supports;
  loads += ring.loads(k, {normal_force, S(0)});
  const Acceleration<S> a = acceleration(body, motion, loads);
  const S arm = ring.friction_arm(motion, k);
  const S whirl = k.tangent.dot(motion.velocity) / k.displacement;
  const S slip_acceleration = k.tangent.dot(a.mass_centre) + arm * a.angular +
                              motion.speed * motion.speed * k.tangent.dot(motion.eccentricity) -
                              whirl * k.normal_velocity;
  return -slip_acceleration / slip_mobility(body, arm);
}

}  // namespace rotor
