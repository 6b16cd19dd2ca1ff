/// The rotor as a rigid body in the plane: kinetic energy, loads of the supports, equations of
/// motion. Source: "Overcritical high-speed rotor systems, full annular rub and accident", Sec.
/// 2.1, Eqs. (1)-(4).
///
/// Everything is written with plane vectors, and so holds in any orthonormal basis: the paper's
/// rotating axes O_a xy, the stator's axes O_a x_a y_a, or the radial and tangential directions of
/// a contact. A chart such as rotating_frame.hpp defines the basis of the components.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "model/mechanics/parameters.hpp"
#include "model/mechanics/plane.hpp"

namespace rotor {

/// Inertia of the rotor: m, I_C, e_x before the mass loss and m_1, I_C1, e_x1 after it.
template <class S>
struct Body {
  S mass;          ///< kg
  S inertia;       ///< about the mass centre C, kg m^2; infinite while a drive holds the speed
  S eccentricity;  ///< distance of C from the geometrical centre O, m

  static Body of(const Parameters& p) {
    return {as_typed<S>(p.mass),
            p.drive == Drive::constant_speed ? std::numeric_limits<S>::infinity()
                                             : as_typed<S>(p.inertia),
            as_typed<S>(p.eccentricity)};
  }
  bool has_constant_speed() const { return inertia == std::numeric_limits<S>::infinity(); }
};

/// Position and velocity of the rotor, all vectors in one basis.
template <class S>
struct Motion {
  Vector<S> displacement;  ///< of O from O_a, m
  Vector<S> velocity;      ///< of O relative to the stator, m/s
  Vector<S> eccentricity;  ///< of C from O, m
  Vector<S> down;          ///< unit vector of gravity, the direction of x_a
  S speed;                 ///< q3', rad/s

  Vector<S> mass_centre() const { return displacement + eccentricity; }
  Vector<S> mass_centre_velocity() const {
    return velocity + speed * quarter_turn(eccentricity);  // Eq. (1)
  }
};

/// Generalised forces: Q_1, Q_2 as a vector (N), and Q_3, the moment about O_a (N m).
template <class S>
struct Loads {
  Vector<S> force;
  S moment;

  Loads& operator+=(const Loads& other) {
    force += other.force;
    moment += other.moment;
    return *this;
  }
};

template <class S>
struct Acceleration {
  Vector<S> mass_centre;  ///< of C relative to the stator, m/s^2
  S angular;              ///< q3'', rad/s^2
};

/// Of a mass on a spring, rad/s.
template <class S>
S natural_frequency(const S& stiffness, const std::type_identity_t<S>& mass) {
  using std::sqrt;
  return sqrt(stiffness / mass);
}

/// T, J; without that of the rotation if the speed is constant.
template <class S>
S kinetic_energy(const Body<S>& body, const Motion<S>& motion) {
  const S rotation =
      body.has_constant_speed() ? S(0) : S(body.inertia * motion.speed * motion.speed);
  return (body.mass * motion.mass_centre_velocity().squaredNorm() + rotation) / 2;  // Eq. (2)
}

/// Everything that acts on the rotor while it is clear of the ring: springs and dampers of the
/// supports, gravity, motor.
template <class S>
struct Supports {
  S stiffness;               ///< k, N/m
  S damping;                 ///< d, N s/m
  S gravity;                 ///< g, m/s^2
  S torque;                  ///< M_mot while the motor drives, N m
  bool balanced_by_springs;  ///< whether the springs' preload takes its share of the gravity moment

  Supports(const Parameters& p, Equations equations)
      : stiffness(as_typed<S>(p.support_stiffness)),
        damping(as_typed<S>(p.support_damping)),
        gravity(as_typed<S>(p.gravity)),
        torque(as_typed<S>(p.torque)),
        balanced_by_springs(equations.gravity_moment == GravityMoment::balanced) {}

  /// Force on the supports at a position and a velocity of O, N; by their magnitudes, an upper
  /// bound of its own; by velocity and acceleration, its rate, N/s.
  template <class T>
  T bearing_force(const T& displacement, const T& velocity) const {
    return stiffness * displacement + damping * velocity;
  }

  Loads<S> loads(const Body<S>& body, const Motion<S>& motion, bool motor_on) const {
    const Vector<S> force = -damping * motion.velocity - stiffness * motion.displacement;
    return {force, -damping * cross(motion.displacement, motion.velocity) +
                       gravity_moment(body, motion) + (motor_on ? torque : S(0))};  // Eq. (4)
  }

  /// Energy stored in the springs, J.
  S spring_energy(const Vector<S>& displacement) const {
    return stiffness * displacement.squaredNorm() / 2;
  }

  /// Power of the motor, and of the dampers, W.
  S motor_power(const Motion<S>& motion, bool motor_on) const {
    return motor_on ? S(torque * motion.speed) : S(0);
  }
  S damping_power(const Motion<S>& motion) const {
    return -damping * motion.velocity.squaredNorm();
  }

  /// Moment of gravity about O_a. Q_1 and Q_2 leave gravity out because the springs carry it at
  /// equilibrium; as printed, Q_3 nevertheless keeps the moment of the whole weight. The springs'
  /// preload balances all of it but the part due to the eccentricity.
  S gravity_moment(const Body<S>& body, const Motion<S>& motion) const {
    const Vector<S> arm = balanced_by_springs ? motion.eccentricity : motion.mass_centre();
    return body.mass * gravity * cross(arm, motion.down);  // Eq. (4)
  }

  /// The steady response to the unbalance at a constant speed in rad/s, gravity's moment left out:
  /// O_a C = e_x (k + i w d) / (k - m w^2 + i w d) in the rotating axes, as complex numbers, m.
  Vector<S> unbalance_response(const Body<S>& body, const S& speed) const {
    if (speed == 0) return {body.eccentricity, S(0)};  // without springs, too
    const Vector<S> force(stiffness, damping * speed);
    const Vector<S> impedance = force - Vector<S>(body.mass * speed * speed, S(0));
    const Vector<S> inverse =
        Vector<S>(impedance.x(), -impedance.y()) * (body.eccentricity / impedance.squaredNorm());
    return complex_product(force, inverse);
  }
  /// Its derivative by the speed, e_x m w (2 k + i w d) / (k - m w^2 + i w d)^2, m s.
  Vector<S> unbalance_response_by_speed(const Body<S>& body, const S& speed) const {
    if (speed == 0) return {S(0), S(0)};
    const Vector<S> impedance(stiffness - body.mass * speed * speed, damping * speed);
    const Vector<S> inverse =
        Vector<S>(impedance.x(), -impedance.y()) * (1 / impedance.squaredNorm());
    const Vector<S> driven =
        body.eccentricity * body.mass * speed * Vector<S>(2 * stiffness, damping * speed);
    return complex_product(driven, complex_product(inverse, inverse));
  }
};

/// Acceleration of a body per unit of load.
template <class S>
struct Mobility {
  S per_mass;     ///< 1/kg
  S per_inertia;  ///< 1/(kg m^2)

  Mobility(const Body<S>& body) : per_mass(1 / body.mass), per_inertia(1 / body.inertia) {}
};

/// Solves the equations of motion for the accelerations. The mass matrix of Eq. (3) needs no
/// general solver: force and moment balance about C are the same equations, and the moment balance
/// can be solved by itself.
template <class S>
inline Acceleration<S> acceleration(const std::type_identity_t<Mobility<S>>& body,
                                    const Motion<S>& motion, const Loads<S>& loads) {
  return {body.per_mass * loads.force,
          body.per_inertia * (loads.moment - cross(motion.mass_centre(), loads.force))};  // Eq. (3)
}

/// Acceleration of O relative to the stator, m/s^2.
template <class S>
inline Vector<S> acceleration_of_centre(const Acceleration<S>& a, const Motion<S>& motion) {
  return a.mass_centre - a.angular * quarter_turn(motion.eccentricity) +
         motion.speed * motion.speed * motion.eccentricity;
}

}  // namespace rotor
