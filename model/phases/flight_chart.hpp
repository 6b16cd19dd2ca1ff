/// Coordinates of a rotor without contact. In the stator's frame the rotation hardly moves the mass
/// centre, because the supports are soft; well above the critical speed only the synchronous motion
/// is left of it, and the unknowns are the deviation from that. A new chart subtracts the steady
/// response alone: short flights between contacts are not worth the series. The axes are the
/// stator's, turned to a recent position of the rotor's axes, so that the angle stays small. In a
/// ring off centre the deviation contains the position of rest.
#pragma once

#include <array>
#include <cmath>

#include "model/mechanics/rotating_frame.hpp"
#include "model/mechanics/turn.hpp"
#include "model/phases/synchronous_motion.hpp"

namespace rotor {

template <class S>
class FlightChart {
  using Synchronous = SynchronousMotion<S>;

 public:
  /// Deviation of C along both axes (m), angle of the rotor from them without ripple (rad), then
  /// deviation of the velocity of C (m/s), and the change of the speed without ripple since the
  /// chart was made (rad/s), which has a smaller rounding error.
  using Unknowns = std::array<S, 6>;
  enum Unknown { deviation_x, deviation_y, rotor_angle, rate_x, rate_y, speed_change };
  /// The deviation of C, m, and of its velocity, m/s; or, from the rates, their rates.
  static Vector<S> deviation(const Unknowns& x) { return {x[deviation_x], x[deviation_y]}; }
  static Vector<S> deviation_rate(const Unknowns& x) { return {x[rate_x], x[rate_y]}; }
  /// The deviation from the position of rest, m.
  Vector<S> vibration(const Unknowns& x) const { return deviation(x) - rest_; }

  struct Kinematics {
    Motion<S> motion;
    Vector<S> rotor_axis;  ///< unit vector along x
    typename Synchronous::Value synchronous;
    Vector<S> response, response_by_speed;  ///< steady, of C, m; and its change, m s
  };

  FlightChart(const RotorSystem<S>& rotor, const State<S>& q)
      : rotor_(rotor), angle_(q[2]), speed_(q[5]), is_steady_(is_fast(q[5])) {
    set_axes();
  }

  Unknowns unknowns(const State<S>& q) const {  // of the state at which the chart is made
    return without_synchronous(RotatingFrame<S>::motion(rotor_.body, q), S(0));
  }

  State<S> state(const Unknowns& x) const {
    const Kinematics at = kinematics(x);
    const Motion<S>& m = at.motion;
    const S c = at.rotor_axis.x(), s = -at.rotor_axis.y();
    const Vector<S> q = turned(m.displacement, c, s);
    const Vector<S> rate = turned(m.velocity, c, s) - m.speed * quarter_turn(q);
    return {q.x(), q.y(), angle_ + angle(x, at), rate.x(), rate.y(), m.speed};
  }

  /// The speed without ripple, rad/s.
  S speed(const Unknowns& x) const { return speed_ + x[speed_change]; }
  S speed_with_ripple(const Unknowns& x) const { return kinematics(x).motion.speed; }
  S whirl_angle(const Unknowns& /*x*/) const { return S(0); }

  Kinematics kinematics(const Unknowns& x) const {
    Kinematics k;  // what the rates do not need is not set
    k.rotor_axis = unit_vector(x[rotor_angle]);
    Vector<S> position = deviation(x), velocity = deviation_rate(x);
    S speed = this->speed(x);
    if (is_steady_) {
      const Supports<S>& supports = rotor_.acting.supports;
      k.response = complex_product(supports.unbalance_response(rotor_.body, speed), k.rotor_axis);
      k.response_by_speed =
          complex_product(supports.unbalance_response_by_speed(rotor_.body, speed), k.rotor_axis);
      position += k.response;
      velocity += speed * quarter_turn(k.response);
    } else if (synchronous_.exists()) {
      k.synchronous = synchronous_.at(k.rotor_axis, speed);
      position += k.synchronous.value(Synchronous::displacement);
      velocity += k.synchronous.value(Synchronous::velocity);
      speed += k.synchronous.value.real(Synchronous::speed_ripple);
      const S half = k.synchronous.value.real(Synchronous::angle_ripple) / 2,
              per = 1 / (1 + half * half);
      k.rotor_axis = turned(k.rotor_axis, S((1 - half * half) * per), S(2 * half * per));
    }
    const Vector<S> eccentricity = rotor_.body.eccentricity * k.rotor_axis;
    k.motion = {.displacement = position - eccentricity,
                .velocity = velocity - speed * quarter_turn(eccentricity),
                .eccentricity = eccentricity,
                .down = down_,
                .speed = speed};
    return k;
  }

  Unknowns rates(const Unknowns& x, const Kinematics& at, const Acceleration<S>& a) const {
    if (is_steady_) {
      const S w = at.motion.speed;
      const Vector<S> drift = a.angular * at.response_by_speed;
      const Vector<S> rate = a.mass_centre + w * w * at.response -
                             quarter_turn<S>(a.angular * at.response + w * drift);
      return {x[rate_x] - drift.x(), x[rate_y] - drift.y(), w, rate.x(), rate.y(), a.angular};
    }
    if (!synchronous_.exists())
      return {x[rate_x],         x[rate_y],         at.motion.speed,
              a.mass_centre.x(), a.mass_centre.y(), a.angular};
    // theta' and W' follow from w and w'.
    const auto& value = at.synchronous.value;
    const auto& by_angle = at.synchronous.by_angle;
    const auto& by_speed = at.synchronous.by_speed;
    const S half = value.real(Synchronous::angle_ripple) / 2, per_half = 1 / (1 + half * half);
    const S phi_by_theta = 1 + by_angle.real(Synchronous::angle_ripple) * per_half;
    const S phi_by_W = by_speed.real(Synchronous::angle_ripple) * per_half;
    const S w_by_theta = by_angle.real(Synchronous::speed_ripple);
    const S w_by_W = 1 + by_speed.real(Synchronous::speed_ripple);
    const S w = at.motion.speed, per = 1 / (w_by_W * phi_by_theta - w_by_theta * phi_by_W);
    const S theta_rate = per * (w_by_W * w - phi_by_W * a.angular);
    const S W_rate = per * (phi_by_theta * a.angular - w_by_theta * w);
    const auto change = [&](auto of) -> Vector<S> {
      return theta_rate * by_angle(of) + W_rate * by_speed(of);
    };
    const Vector<S> drift = value(Synchronous::velocity) - change(Synchronous::displacement);
    const Vector<S> rate = a.mass_centre - change(Synchronous::velocity);
    return {x[rate_x] + drift.x(), x[rate_y] + drift.y(), theta_rate, rate.x(), rate.y(), W_rate};
  }

  /// Errors of the speed add up in the angle. One without ripple is integrated more accurately at
  /// no cost, one about the steady response at little.
  Unknowns scale(const S& length, const S& frequency, const S& speed) const {
    const int finer = synchronous_.exists() ? 50 : is_steady_ ? 10 : 1;
    return {length, length, S(1), length * frequency, length * frequency, S(speed / finer)};
  }

  /// Turns the axes to the rotor's if these have turned far away, and renews the chart where what
  /// it subtracts is no longer worth it. Returns whether the rates have to be computed again.
  bool recentre(Unknowns& x) {
    const bool is_near = x[rotor_angle] < far && x[rotor_angle] > -far;
    if (!is_near) {
      const Vector<S> turn = unit_vector(x[rotor_angle]);
      const S &c = turn.x(), &s = turn.y();
      angle_ += x[rotor_angle];
      set_axes();
      synchronous_.turn_axes(c, s);
      const Vector<S> position = turned(deviation(x), c, S(-s));
      const Vector<S> velocity = turned(deviation_rate(x), c, S(-s));
      x = {position.x(), position.y(), S(0), velocity.x(), velocity.y(), x[speed_change]};
    }
    const S speed = this->speed(x);
    const bool holds = synchronous_.exists()   ? synchronous_.holds(speed)
                       : is_steady_            ? is_fast(speed) && vibrates(x)
                       : synchronous_disabled_ ? is_near_reference_speed(x)
                                               : !is_fast(speed);
    if (!holds) renew(x);
    return !is_near || !holds;
  }

  void switch_motor_off(Unknowns& x) {
    rotor_.motor_on = false;
    square_of_fast_ = square_of_fast();
    renew(x);
  }

  /// Bounds of the synchronous motion.
  typename Synchronous::Amplitudes synchronous_amplitudes(const Unknowns& x) const {
    using std::abs;
    if (is_steady_) {
      const S w = speed(x),
              length = rotor_.acting.supports.unbalance_response(rotor_.body, w).norm();
      return {length, abs(w) * length, S(0)};
    }
    if (!synchronous_.exists()) return {S(0), S(0), S(0)};
    return synchronous_.amplitudes(speed(x));
  }

 private:
  void set_axes() {
    down_ = unit_vector<S>(-angle_);
    rest_ = complex_product(rotor_.acting.supports.rest, down_);
  }

  static constexpr double far = 32;  ///< rad; up to here the angle is rounded by some 1e-14 rad

  /// Chooses what to subtract at the present speed: nothing if the rotor is not fast, the steady
  /// response if it vibrates, or else the synchronous motion, unless the speed ripples too much.
  void renew(Unknowns& x) {
    const Kinematics at = kinematics(x);
    const S angle = this->angle(x, at);
    const bool fast = is_fast(at.motion.speed);
    speed_ = at.motion.speed;
    synchronous_ = Synchronous();
    synchronous_disabled_ = false;
    is_steady_ = fast;
    x = without_synchronous(at.motion, angle);
    if (!fast || vibrates(x)) return;
    is_steady_ = false;
    synchronous_ = Synchronous(rotor_, speed_, down_);
    x = without_synchronous(at.motion, angle);
    synchronous_disabled_ = !(synchronous_.ripples_little() && is_near_reference_speed(x));
    if (!synchronous_disabled_) return;
    synchronous_ = Synchronous();
    x = without_synchronous(at.motion, angle);
  }

  /// Whether the deviation from the steady response is mostly a vibration, which the synchronous
  /// motion leaves as it is: one with more energy than a 2,000th of the static deflection m g / k,
  /// which measures the ripple, and of the eccentricity. From half to four times of that, run-ups
  /// and flights of the paper's rotor cost the same within 3 %.
  bool vibrates(const Unknowns& x) const {
    const Supports<S>& supports = rotor_.acting.supports;
    const S k = supports.stiffness, m = rotor_.body.mass;
    const S force = (m * rotor_.acting.weight.gravity + k * rotor_.body.eccentricity) / 2000;
    return k * (k * vibration(x).squaredNorm() + m * deviation_rate(x).squaredNorm()) >
           force * force;
  }

  /// Whether the speed is, apart from a ripple, that of the last renewal.
  bool is_near_reference_speed(const Unknowns& x) const {
    using std::abs;
    return abs(x[speed_change]) <= Synchronous::range() * abs(speed_);
  }

  /// The unknowns of a motion in these axes, from which the rotor has turned by an angle.
  Unknowns without_synchronous(const Motion<S>& m, const S& angle) const {
    using std::atan;
    Vector<S> position = m.mass_centre(), velocity = m.mass_centre_velocity();
    S theta = angle, speed = m.speed;
    if (is_steady_) {
      const Vector<S> response = complex_product(
          rotor_.acting.supports.unbalance_response(rotor_.body, speed), unit_vector(theta));
      position -= response;
      velocity -= speed * quarter_turn(response);
    } else if (synchronous_.exists()) {
      auto at = synchronous_.at(unit_vector(theta), speed);
      for (int n = 0; n < 100; ++n) {  // gains a digit each time if the ripple is small
        const S last_theta = theta, last_speed = speed;
        theta = angle - 2 * atan(at.value.real(Synchronous::angle_ripple) / 2);
        speed = m.speed - at.value.real(Synchronous::speed_ripple);
        if (theta == last_theta && speed == last_speed) break;
        at = synchronous_.at(unit_vector(theta), speed);
      }
      position -= at.value(Synchronous::displacement);
      velocity -= at.value(Synchronous::velocity);
    }
    return {position.x(), position.y(), theta, velocity.x(), velocity.y(), speed - speed_};
  }

  /// Angle of the rotor from the axes, rad.
  S angle(const Unknowns& x, const Kinematics& at) const {
    using std::atan;
    return synchronous_.exists()
               ? S(x[rotor_angle] +
                   2 * atan(at.synchronous.value.real(Synchronous::angle_ripple) / 2))
               : x[rotor_angle];
  }

  bool is_fast(const S& speed) const { return speed * speed > square_of_fast_; }

  /// Above 1.4 times the critical speed, and not driven to change by a quarter in five turns.
  /// Nearer to it, or then, the response changes too fast to be worth subtracting. Springs that are
  /// not linear have no such response.
  S square_of_fast() const {
    using std::abs, std::max;
    const S in_turns = 4 * far * abs(rotor_.constant_moment()) / rotor_.body.inertia;
    return max<S>(2 * rotor_.acting.supports.stiffness / rotor_.body.mass, in_turns);
  }

  RotorSystem<S> rotor_;
  S square_of_fast_ = square_of_fast();
  S angle_, speed_;
  Vector<S> down_, rest_;    ///< gravity's direction, and the position of rest, in the axes
  bool is_steady_;           ///< whether the steady response is subtracted,
  Synchronous synchronous_;  ///< or this, if it exists
  bool synchronous_disabled_ = false;  ///< though the rotor is fast
};

}  // namespace rotor
