/// Coordinates of a rotor without contact. In the stator's frame the mass centre hardly feels the
/// rotation, because the supports are soft; what is left of it well above the critical speed is the
/// steady response to the unbalance, and the unknowns are the deviation from that. The axes are the
/// stator's, turned to where the rotor's axes were not long ago, so that the angle stays small.
#pragma once

#include <array>
#include <cmath>

#include "model/mechanics/rotating_frame.hpp"
#include "model/phases/rotor_system.hpp"

namespace rotor {

template <class S>
class FlightChart {
 public:
  /// Deviation of C along both axes (m), angle of the rotor from them (rad), then deviation of the
  /// velocity of C (m/s), and the speed (rad/s).
  using Unknowns = std::array<S, 6>;

  /// The steady response to the unbalance, as far as it is subtracted: O_a C and its change with
  /// the speed.
  struct Steady {
    Vector<S> displacement;  ///< m
    Vector<S> slope;         ///< m s
  };

  struct Kinematics {
    Motion<S> motion;
    Steady steady;
  };

  FlightChart(const RotorSystem<S>& rotor, const State<S>& q)
      : body_(rotor.body), supports_(rotor.supports) {
    lay_axes(q);
  }

  Unknowns unknowns(const State<S>& q) const {  // the axes coincide
    const Motion<S> m = RotatingFrame<S>::motion(body_, q);
    const Steady steady = this->steady(m.eccentricity, m.speed);
    const Vector<S> position = m.mass_centre() - steady.displacement;
    const Vector<S> velocity =
        m.mass_centre_velocity() - m.speed * quarter_turn(steady.displacement);
    return {position.x(), position.y(), S(0), velocity.x(), velocity.y(), m.speed};
  }

  State<S> state(const Unknowns& x) const {
    using std::cos, std::sin;
    const S c = cos(x[2]), s = sin(x[2]);
    const Motion<S> m = kinematics(x, c, s).motion;
    const Vector<S> q = turned(m.displacement, c, S(-s));
    const Vector<S> rate = turned(m.velocity, c, S(-s)) - x[5] * quarter_turn(q);
    return {q.x(), q.y(), angle_ + x[2], rate.x(), rate.y(), x[5]};
  }

  Kinematics kinematics(const Unknowns& x) const {
    using std::cos, std::sin;
    return kinematics(x, cos(x[2]), sin(x[2]));
  }

  Unknowns rates(const Unknowns& x, const Kinematics& at, const Acceleration<S>& a) const {
    // The steady response turns with the rotor and changes with its speed.
    const Steady& steady = at.steady;
    const S w = x[5];
    const Vector<S> drift = a.angular * steady.slope;
    const Vector<S> velocity = Vector<S>(x[3], x[4]) - drift;
    const Vector<S> rate = a.mass_centre + w * w * steady.displacement -
                           quarter_turn<S>(a.angular * steady.displacement + w * drift);
    return {velocity.x(), velocity.y(), w, rate.x(), rate.y(), a.angular};
  }

  Unknowns scale(const S& length, const S& frequency, const S& speed) const {
    return {length, length, S(1), length * frequency, length * frequency, speed};
  }

  /// Lays the axes anew if the rotor has turned far from them, or has become too slow for its
  /// response to be subtracted. Returns whether the rates have to be worked out again.
  bool recentre(Unknowns& x) {
    constexpr double far = 32;  // rad; the angle is known to some 1e-14 rad until there
    const bool is_near = x[2] < far && x[2] > -far;
    if (is_near && (!subtracts_response_ || is_fast(x[5]))) return false;
    const State<S> q = state(x);
    lay_axes(q);
    x = unknowns(q);
    return true;
  }

  /// Of C in the steady response to the unbalance, as far as that is subtracted, m.
  S steady_amplitude(const Unknowns& x) const {
    if (!subtracts_response_) return S(0);
    return body_.eccentricity * supports_.unbalance_response(body_.mass, x[5]).factor.norm();
  }

 private:
  void lay_axes(const State<S>& q) {
    using std::cos, std::sin;
    angle_ = q[2];
    down_ = Vector<S>(cos(angle_), -sin(angle_));
    subtracts_response_ = is_fast(q[5]);
  }

  /// Far above the critical speed. Near it the response changes too fast with the speed to be worth
  /// subtracting.
  bool is_fast(const S& speed) const {
    const S critical = supports_.stiffness / body_.mass;  // squared
    return speed * speed > 4 * critical;
  }

  Steady steady(const Vector<S>& eccentricity, const S& speed) const {
    if (!subtracts_response_) return {Vector<S>(0, 0), Vector<S>(0, 0)};
    const auto response = supports_.unbalance_response(body_.mass, speed);
    return {complex_product(eccentricity, response.factor),
            complex_product(eccentricity, response.slope)};
  }

  Kinematics kinematics(const Unknowns& x, const S& cosine, const S& sine) const {
    const Vector<S> eccentricity(body_.eccentricity * cosine, body_.eccentricity * sine);
    const Steady steady = this->steady(eccentricity, x[5]);
    const Vector<S> turning = steady.displacement - eccentricity;
    return {{.displacement = Vector<S>(x[0], x[1]) + turning,
             .velocity = Vector<S>(x[3], x[4]) + x[5] * quarter_turn(turning),
             .eccentricity = eccentricity,
             .down = down_,
             .speed = x[5]},
            steady};
  }

  Body<S> body_;
  Supports<S> supports_;
  S angle_;
  Vector<S> down_;
  bool subtracts_response_;
};

}  // namespace rotor
