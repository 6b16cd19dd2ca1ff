/// The paper's generalised coordinates: O in the axes O_a xy, which turn with the rotor, and the
/// rotor's angle. Source: "Overcritical high-speed rotor systems, full annular rub and accident",
/// Sec. 2.1, Eqs. (1) and (3).
#pragma once

#include <array>
#include <cmath>

#include "model/mechanics/rotor.hpp"

namespace rotor {

/// q1, q2 (m), q3 (rad), then their rates.
template <class S>
using State = std::array<S, 6>;

template <class S>
struct RotatingFrame {
  /// The motion, its vectors in the axes O_a xy.
  static Motion<S> motion(const Body<S>& body, const State<S>& q) {
    using std::cos, std::sin;
    const Vector<S> displacement(q[0], q[1]);
    const Vector<S> relative_velocity(q[3], q[4]);
    return {.displacement = displacement,
            .velocity = relative_velocity + q[5] * quarter_turn(displacement),
            .eccentricity = Vector<S>(body.eccentricity, 0),
            .down = Vector<S>(cos(q[2]), -sin(q[2])),
            .speed = q[5]};
  }

  /// Angle of O about O_a in the stator's frame, including all turns of q3, rad.
  static S angle(const State<S>& q) {
    using std::atan2;
    return q[2] + atan2(q[1], q[0]);
  }

  /// Time derivative of the state: the accelerations relative to the axes O_a xy.
  static State<S> rates(const Motion<S>& motion, const State<S>& q, const Acceleration<S>& a) {
    const Vector<S> r_C = motion.mass_centre();
    const Vector<S> relative_velocity(q[3], q[4]);
    const S w = motion.speed;
    const Vector<S> relative = a.mass_centre - a.angular * quarter_turn(r_C) -
                               2 * w * quarter_turn(relative_velocity) + w * w * r_C;  // Eq. (3)
    return {q[3], q[4], q[5], relative.x(), relative.y(), a.angular};
  }
};

/// A vector given in O_a xy, written in the stator's axes O_a x_a y_a.
inline Vector<double> in_stator_frame(const Vector<double>& v, double angle) {
  return turned<double>(v, std::cos(angle), std::sin(angle));
}

}  // namespace rotor
