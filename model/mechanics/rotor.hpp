/// The rotor as a rigid body in the plane: kinetic energy and equations of motion. Source:
/// "Overcritical high-speed rotor systems, full annular rub and accident", Sec. 2.1, Eqs. (1)-(3).
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
  Vector<S> displacement;  ///< of O from O_a, the ring's centre, m
  Vector<S> velocity;      ///< of O relative to the stator, m/s
  Vector<S> eccentricity;  ///< of C from O, m
  Vector<S> down;          ///< unit vector of gravity, the direction of x_a
  S speed;                 ///< q3', rad/s

  /// A vector along x_a and y_a, in the basis of the others.
  Vector<S> from_stator(const Vector<S>& v) const { return complex_product(v, down); }
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
  /// About the mass centre, N m.
  S moment_about_centre(const Motion<S>& motion) const {
    return moment - cross(motion.mass_centre(), force);
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
          body.per_inertia * loads.moment_about_centre(motion)};  // Eq. (3)
}

/// Power of a drive that holds the speed against all those loads, W; 0 without one.
template <class S>
S drive_power(const Body<S>& body, const Motion<S>& motion, const Loads<S>& loads) {
  return body.has_constant_speed() ? S(-loads.moment_about_centre(motion) * motion.speed) : S(0);
}

/// Acceleration of O relative to the stator, m/s^2.
template <class S>
inline Vector<S> acceleration_of_centre(const Acceleration<S>& a, const Motion<S>& motion) {
  return a.mass_centre - a.angular * quarter_turn(motion.eccentricity) +
         motion.speed * motion.speed * motion.eccentricity;
}

}  // namespace rotor
