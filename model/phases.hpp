/// The smooth phases of the motion, each in the coordinates in which it is slowest. A phase writes
/// the vectors of rotor.hpp and contact.hpp in a basis of its own; the physics stays there.
#pragma once

#include <array>
#include <cmath>

#include "model/contact.hpp"
#include "model/rotating_frame.hpp"

namespace rotor {

/// All that acts in a phase.
template <class S>
struct Surroundings {
  Body<S> body;
  Supports<S> supports;
  Ring<S> ring;
  bool motor_on;
};

/// No contact force. The mass centre in the stator's frame: it hardly feels the rotation, because
/// the supports are soft. The axes are the stator's, turned to where the rotor's axes are at the
/// start of the phase, so that the angle stays small.
template <class S>
class Flight {
 public:
  /// C along both axes (m), angle since the start (rad), then the rates.
  using Unknowns = std::array<S, 6>;

  Flight(const Surroundings<S>& around, const State<S>& start) : around_(around), angle_(start[2]) {
    using std::cos, std::sin;
    down_ = Vector<S>(cos(angle_), -sin(angle_));
  }

  Unknowns unknowns(const State<S>& q) const {
    const auto motion =
        RotatingFrame<S>::motion(around_.body, q);  // the axes coincide at the start
    const Vector<S> c = motion.mass_centre(), v = motion.mass_centre_velocity();
    return {c.x(), c.y(), S(0), v.x(), v.y(), motion.speed};
  }

  Motion<S> motion(const Unknowns& x) const {
    using std::cos, std::sin;
    const S e = around_.body.eccentricity;
    const Vector<S> eccentricity(e * cos(x[2]), e * sin(x[2]));
    return {.displacement = Vector<S>(x[0], x[1]) - eccentricity,
            .velocity = Vector<S>(x[3], x[4]) - x[5] * quarter_turn(eccentricity),
            .eccentricity = eccentricity,
            .down = down_,
            .speed = x[5]};
  }

  State<S> state(const Unknowns& x) const {
    using std::cos, std::sin;
    const Motion<S> m = motion(x);
    const S c = cos(x[2]), s = -sin(x[2]);
    const Vector<S> q = turned(m.displacement, c, s);
    const Vector<S> rate = turned(m.velocity, c, s) - x[5] * quarter_turn(q);
    return {q.x(), q.y(), angle_ + x[2], rate.x(), rate.y(), x[5]};
  }

  void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const Motion<S> m = motion(x);
    const auto a =
        acceleration(around_.body, m, around_.supports.loads(around_.body, m, around_.motor_on));
    rates = {x[3], x[4], x[5], a.mass_centre.x(), a.mass_centre.y(), a.angular};
  }

 private:
  const Surroundings<S>& around_;
  S angle_;
  Vector<S> down_;
};

/// In contact, sliding or rolling: polar coordinates of O in the rotating axes. The basis is the
/// normal and the tangent at K.
template <class S>
class Rub {
 public:
  /// rho (m), direction of O in the rotating axes and angle of the rotor, both since the start
  /// (rad), then the velocity of O along normal and tangent (m/s), and the speed (rad/s).
  using Unknowns = std::array<S, 6>;

  /// `direction` is the sign of the slip velocity, or 0 for rolling.
  Rub(const Surroundings<S>& around, const State<S>& start, int direction)
      : around_(around), direction_(direction), q3_(start[2]) {
    using std::atan2;
    alpha_ = atan2(start[1], start[0]);
  }

  Unknowns unknowns(const State<S>& q) const {
    const auto k = around_.ring.rim_point(RotatingFrame<S>::motion(around_.body, q));
    const S v_t = direction_ == 0 ? -around_.ring.rotor_radius * q[5]
                                  : k.slip_velocity - around_.ring.rotor_radius * q[5];
    return {k.displacement, S(0), S(0), k.normal_velocity, v_t, q[5]};
  }

  Motion<S> motion(const Unknowns& x) const {
    using std::cos, std::sin;
    const S e = around_.body.eccentricity;
    const S alpha = alpha_ + x[1], beta = q3_ + x[2] + alpha;
    return {.displacement = Vector<S>(x[0], 0),
            .velocity = Vector<S>(x[3], x[4]),
            .eccentricity = Vector<S>(e * cos(alpha), -e * sin(alpha)),
            .down = Vector<S>(cos(beta), -sin(beta)),
            .speed = x[5]};
  }

  State<S> state(const Unknowns& x) const {
    using std::cos, std::sin;
    const S c = cos(alpha_ + x[1]), s = sin(alpha_ + x[1]);
    const Vector<S> q = turned(Vector<S>(x[0], 0), c, s);
    const Vector<S> rate = turned(Vector<S>(x[3], x[4] - x[5] * x[0]), c, s);
    return {q.x(), q.y(), q3_ + x[2], rate.x(), rate.y(), x[5]};
  }

  void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    evaluate(x, rates);
  }

  /// The rates, and the forces at K that go with them.
  ContactForces<S> evaluate(const Unknowns& x, Unknowns& rates) const {
    const Motion<S> m = motion(x);
    const RimPoint<S> k = rim_point(x);
    const Loads<S> free = around_.supports.loads(around_.body, m, around_.motor_on);
    ContactForces<S> forces{pressure(x), S(0)};
    if (direction_ != 0) {
      forces.friction = around_.ring.sliding_friction(forces.normal, direction_);
      rates = with(x, m, free, k, forces);
    } else {
      rates = with(x, m, free, k, forces);
      const S slip_acceleration = rates[4] + around_.ring.rotor_radius * rates[5];
      forces.friction =
          -slip_acceleration / slip_mobility(around_.body, m, k, around_.ring.rotor_radius);
      rates = with(x, m, free, k, forces);
    }
    return forces;
  }

  /// F_n without the clamp: a guard ends the phase where it changes sign.
  S pressure(const Unknowns& x) const {
    const Ring<S>& ring = around_.ring;
    return -ring.stiffness * (x[0] - ring.clearance) - ring.damping * x[3];  // Eq. (21)
  }

  S slip_velocity(const Unknowns& x) const { return x[4] + around_.ring.rotor_radius * x[5]; }
  int direction() const { return direction_; }

 private:
  RimPoint<S> rim_point(const Unknowns& x) const {
    return {.normal = Vector<S>(1, 0),
            .tangent = Vector<S>(0, 1),
            .displacement = x[0],
            .indentation = x[0] - around_.ring.clearance,
            .normal_velocity = x[3],
            .slip_velocity = slip_velocity(x)};
  }

  Unknowns with(const Unknowns& x, const Motion<S>& m, Loads<S> loads, const RimPoint<S>& k,
                const ContactForces<S>& forces) const {
    loads += around_.ring.loads(k, forces);
    const auto a = acceleration(around_.body, m, loads);
    const Vector<S> of_O =
        a.mass_centre - a.angular * quarter_turn(m.eccentricity) + x[5] * x[5] * m.eccentricity;
    const S whirl = x[4] / x[0];  // of the basis, rad/s
    return {x[3], whirl - x[5], x[5], of_O.x() + whirl * x[4], of_O.y() - whirl * x[3], a.angular};
  }

  const Surroundings<S>& around_;
  int direction_;
  S q3_, alpha_;
};

}  // namespace rotor
