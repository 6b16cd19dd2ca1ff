/// Coordinates of a rotor that touches the ring: polar coordinates of O in the rotating axes. The
/// basis is the normal and the tangent at K.
#pragma once

#include <array>
#include <cmath>

#include "model/mechanics/rotating_frame.hpp"
#include "model/mechanics/turn.hpp"
#include "model/phases/rotor_system.hpp"

namespace rotor {

template <class S>
class ContactChart {
 public:
  /// Angle of the rotor and azimuth of O in its axes, both since the chart was centred (rad);
  /// Delta, which has a smaller rounding error than rho (m); Delta' and the slip velocity v_Ktau
  /// (m/s); the speed (rad/s). The angles come first, side by side: their rates need no
  /// accelerations, so a processor can begin the next stage's sines early. Where the clearance is a
  /// very small part of the radius, the tangential velocity of O replaces the slip while it is the
  /// smaller: as slip less the rim's velocity it would be lost in rounding, and the whirl rate
  /// divides it by rho. To locate zeros of the slip, the slip itself is needed.
  using Unknowns = std::array<S, 6>;
  enum Unknown { rotor_angle, azimuth, indentation, normal_velocity, tangential, rotor_speed };

  struct Kinematics {
    Motion<S> motion;
  };

  ContactChart(const RotorSystem<S>& rotor, const State<S>& q)
      : eccentricity_(rotor.body.eccentricity),
        clearance_(rotor.ring.clearance),
        radius_(rotor.ring.rotor_radius),
        knows_slip_(is_wide()) {
    using std::atan2;
    centre(q[2], atan2(q[1], q[0]));
  }

  Unknowns unknowns(const State<S>& q) const {  // of the state at which the chart is centred
    const Vector<S> displacement(q[0], q[1]);
    const S rho = displacement.norm();
    const Vector<S> normal = displacement / rho;
    const Vector<S> velocity = Vector<S>(q[3], q[4]) + q[5] * quarter_turn(displacement);
    return {S(0),
            S(0),
            rho - clearance_,
            normal.dot(velocity),
            quarter_turn(normal).dot(velocity) + (knows_slip_ ? S(radius_ * q[5]) : S(0)),
            q[5]};
  }

  State<S> state(const Unknowns& x) const {
    using std::cos, std::sin;
    const S c = cos(alpha_ + x[azimuth]), s = sin(alpha_ + x[azimuth]), rho = displacement(x);
    const Vector<S> q = turned(Vector<S>(rho, 0), c, s);
    const Vector<S> rate =
        turned(Vector<S>(x[normal_velocity], tangential_velocity(x) - speed(x) * rho), c, s);
    return {q.x(), q.y(), q3_ + x[rotor_angle], rate.x(), rate.y(), speed(x)};
  }

  Kinematics kinematics(const Unknowns& x) const {
    const auto [cosine, sine] = cosines_and_sines<S>(-x[azimuth], -(x[rotor_angle] + x[azimuth]));
    return {{.displacement = Vector<S>(displacement(x), 0),
             .velocity = Vector<S>(x[normal_velocity], tangential_velocity(x)),
             .eccentricity = turned(arm_, cosine[0], sine[0]),
             .down = turned(down_, cosine[1], sine[1]),
             .speed = speed(x)}};
  }

  S speed(const Unknowns& x) const { return x[rotor_speed]; }
  S speed_with_ripple(const Unknowns& x) const { return speed(x); }
  S whirl_angle(const Unknowns& x) const { return q3_ + alpha_ + x[azimuth] + x[rotor_angle]; }

  RimPoint<S> rim_point(const Unknowns& x) const {
    return {.normal = Vector<S>(1, 0),
            .tangent = Vector<S>(0, 1),
            .displacement = displacement(x),
            .indentation = x[indentation],
            .normal_velocity = x[normal_velocity],
            .slip_velocity = slip_velocity(x)};
  }

  Unknowns rates(const Unknowns& x, const Kinematics& at, const Acceleration<S>& a) const {
    const Motion<S>& m = at.motion;
    const Vector<S> of_O = acceleration_of_centre(a, m);
    const S whirl = m.velocity.y() / m.displacement.x();  // of the basis, rad/s
    return {speed(x),
            whirl - speed(x),
            x[normal_velocity],
            of_O.x() + whirl * m.velocity.y(),
            of_O.y() - whirl * x[normal_velocity] + (knows_slip_ ? S(radius_ * a.angular) : S(0)),
            a.angular};
  }

  Unknowns scale(const S& length, const S& frequency, const S& speed) const {
    return {S(1), S(1), length, length * frequency, radius_ * speed, speed};
  }

  /// The unknowns without slip, or their rates without a change of slip.
  Unknowns without_slip(Unknowns x) const {
    x[tangential] = knows_slip_ ? S(0) : S(-radius_ * speed(x));
    return x;
  }

  /// Tangential velocity of O; or, from the rates, its rate.
  S tangential_velocity(const Unknowns& x) const {
    return knows_slip_ ? x[tangential] - radius_ * speed(x) : x[tangential];
  }

  /// Counts both angles from x: small ones have smaller rounding errors and cost less. Returns
  /// whether the rates have changed.
  bool recentre(Unknowns& x) {
    using std::abs;
    centre(q3_ + x[rotor_angle], alpha_ + x[azimuth]);
    x[rotor_angle] = x[azimuth] = 0;
    const S slip = slip_velocity(x), velocity_of_O = tangential_velocity(x);
    const bool knew_slip = knows_slip_;
    knows_slip_ = is_wide() || abs(slip) <= abs(velocity_of_O);
    x[tangential] = knows_slip_ ? slip : velocity_of_O;
    return knows_slip_ != knew_slip;
  }

 private:
  void centre(const S& q3, const S& alpha) {
    q3_ = q3;
    alpha_ = alpha;
    arm_ = eccentricity_ * unit_vector<S>(-alpha);
    down_ = unit_vector<S>(-(q3 + alpha));  // q3 + alpha: direction of O in the stator's frame
  }

  /// Whether the velocity of O, less the rounding of the rim's velocity, has enough digits for all
  /// but the smallest tolerances.
  bool is_wide() const { return radius_ <= 100 * clearance_; }

  S displacement(const Unknowns& x) const { return clearance_ + x[indentation]; }
  S slip_velocity(const Unknowns& x) const {
    return knows_slip_ ? x[tangential] : x[tangential] + radius_ * speed(x);
  }

  S eccentricity_, clearance_, radius_;
  bool knows_slip_;       ///< whether the slip is among the unknowns
  S q3_, alpha_;          ///< where the chart is centred
  Vector<S> arm_, down_;  ///< of C from O, and gravity's direction, in the basis there
};

}  // namespace rotor
