/// The phases without contact force: clear of the ring, or over a ring that is still indented.
#pragma once

#include <array>
#include <optional>

#include "model/phases/flight_chart.hpp"
#include "model/phases/rub.hpp"

namespace rotor {

/// The rim meets the ring, with slip or without.
template <class S>
Transition meet_ring(const RotorSystem<S>& rotor, const State<S>& q, Event event) {
  const S slip = rotor.ring.rim_point(RotatingFrame<S>::motion(rotor.body, q)).slip_velocity;
  if (slip != 0) return {event, ContactState::sliding, slip > 0 ? 1 : -1};
  const ContactChart<S> chart(rotor, q);
  Transition next = Rolling<S>(rotor, chart).leave_zero_slip(chart.without_slip(chart.unknowns(q)));
  next.event = event;
  return next;
}

/// How a motion continues in contact with the ring, perhaps after a jump. A rim that rolls has no
/// slip, whatever its rounded value is.
template <class S>
Transition resume_contact(const RotorSystem<S>& rotor, const State<S>& q, ContactState contact) {
  const auto k = rotor.ring.rim_point(RotatingFrame<S>::motion(rotor.body, q));
  if (rotor.ring.contact_of(k) == ContactState::indented)
    return {Event::none, ContactState::indented};
  if (contact == ContactState::rolling) return {Event::none, contact};
  return meet_ring(rotor, q, Event::none);
}

/// What both phases have in common.
template <class S, class Chart, ContactState state, std::size_t exits>
struct Flight : Phase<S, Chart, state, exits, Extreme::displacement, Extreme::bearing_force> {
  using Base = Phase<S, Chart, state, exits, Extreme::displacement, Extreme::bearing_force>;
  using Base::Base, Base::rotor, Base::chart, Base::mobility;
  using typename Base::Unknowns;
  static constexpr bool contact_in_rates = false;

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const auto at = chart.kinematics(x);
    rates = chart.rates(x, at, acceleration(mobility, at.motion, rotor.loads(at.motion)));
  }

  S phase_swing(const Unknowns& x, const S& h) const {
    return rotor.phase_swing(rotor.acting.supports.stiffness, chart.speed(x), h);
  }

  /// Every contact multiplies the errors at its start, and a flight is cheap: errors of length are
  /// relative to a small part of the clearance. The speed hardly changes, but long steps must not
  /// miss its ripple.
  Unknowns scale(const Unknowns& x) const {
    const S w = rotor.flight_frequency(chart.speed(x));
    return chart.scale(rotor.ring.clearance / 300, w, w / 100);
  }

  static constexpr bool extremes_take_rates = false;
  [[gnu::flatten]] std::array<SquareAndRate<S>, 2> extremes(const Unknowns& x,
                                                            const Unknowns& /*rates*/) const {
    const Motion<S> m = chart.kinematics(x).motion;
    const Supports<S>& supports = rotor.acting.supports;
    const Vector<S> of_O = acceleration_of_centre(acceleration(mobility, m, rotor.loads(m)), m);
    return {{SquareAndRate<S>::of(m.displacement, m.velocity),
             SquareAndRate<S>::of(supports.bearing_force(m),
                                  supports.bearing_force(m.velocity, of_O))}};
  }
};

/// Clear of the ring.
template <class S, class Chart = FlightChart<S>>
struct FreeFlight : Flight<S, Chart, ContactState::free, 2> {
  using Base = Flight<S, Chart, ContactState::free, 2>;
  using Base::Base, Base::rotor, Base::chart, Base::guard, Base::next;
  using typename Base::Unknowns, typename Base::Point, typename Base::MotorOff;

  /// rho = r_a - r
  using TouchDown = Exit<0>;
  [[gnu::flatten]] S guard(TouchDown /*exit*/, const Unknowns& x) const {
    const S clearance = rotor.ring.clearance;
    return clearance * clearance - chart.kinematics(x).motion.displacement.squaredNorm();
  }
  /// At a graze the path may have turned back already where a touch-down is found, because it is
  /// known to a tolerance only: then nothing presses.
  Transition next(TouchDown /*exit*/, const Unknowns& x) const {
    const State<S> q = chart.state(x);
    const RimPoint<S> k = rotor.ring.rim_point(RotatingFrame<S>::motion(rotor.body, q));
    if (k.normal_velocity < 0 && !(rotor.ring.law.pressing(k.indentation, k.normal_velocity) > 0))
      return {Event::none, k.indentation > 0 ? ContactState::indented : ContactState::free};
    return meet_ring(rotor, q, Event::touch_down);
  }

  /// Whether the guards can end the phase within a step, the curvature of the touch-down guard if
  /// so, and upper bounds of the extremes, if these are known.
  typename Base::Bounds bounds(const Point& from, const Point& to) const {
    typename Base::Bounds all;
    const auto motion = motion_bounds(from, to);
    if (!motion) return all;
    using std::max, std::min;
    const S clearance = rotor.ring.clearance, reach = min(motion->displacement, clearance);
    all.upper_bounds = {
        reach, rotor.acting.supports.bound(rotor.body, {reach, S(0), motion->velocity}).force};
    all.events[MotorOff()].stays_positive = !rotor.motor_on || motion->speed < rotor.motor_off;
    EventBound<S>& touch_down = all.events[TouchDown()];
    touch_down.stays_positive = motion->displacement < clearance;
    if (touch_down.stays_positive) return all;
    const S of_O = motion->acceleration + rotor.body.eccentricity * (motion->speed * motion->speed +
                                                                     motion->angular_acceleration);
    const auto velocity = [&](const Point& at) {
      return chart.kinematics(at.x).motion.velocity.norm();
    };
    // The larger velocity of both ends, plus what can be gained in half the step.
    const S fastest =
        min(motion->velocity, max(velocity(from), velocity(to)) + of_O * (to.time - from.time) / 2);
    touch_down.curvature = 2 * (fastest * fastest + clearance * of_O);
    return all;
  }

 private:
  /// Bounds of absolute values.
  struct MotionBounds {
    S displacement;          ///< of O, m
    S velocity;              ///< of O, m/s
    S acceleration;          ///< of C, m/s^2
    S speed;                 ///< rad/s
    S angular_acceleration;  ///< rad/s^2
  };

  /// Bounds that hold through a step, with contact or not. The deviation from
  /// the synchronous motion is a damped oscillation, driven only by the residual that the
  /// synchronous motion leaves, and its amplitude grows by no more than that. Twice the residual at
  /// the ends of the step, plus a thousandth of the amplitude, is taken as its bound in between.
  std::optional<MotionBounds> motion_bounds(const Point& from, const Point& to) const {
    using std::abs, std::max, std::min, std::sqrt;
    const Body<S>& body = rotor.body;
    const Supports<S>& supports = rotor.acting.supports;
    const S h = to.time - from.time, e = body.eccentricity;
    const S frequency = rotor.support_frequency();
    const auto synchronous = [&] {
      const auto a = chart.synchronous_amplitudes(from.x), b = chart.synchronous_amplitudes(to.x);
      return decltype(a){max(a.displacement, b.displacement), max(a.velocity, b.velocity),
                         max(a.speed_ripple, b.speed_ripple)};
    }();
    const S drive = 2 * max(this->drive(from, frequency), this->drive(to, frequency));
    const S deviation =
        (norm(frequency * chart.vibration(from.x), chart.deviation_rate(from.x)) + h * drive) *
        (1 + S(1) / 1000);
    // The farther end of the step, plus the most that the path can bend outwards in between.
    const S bend = (frequency + supports.damping / body.mass) * deviation + drive;
    const S farther =
        sqrt(max<S>(chart.deviation(from.x).squaredNorm(), chart.deviation(to.x).squaredNorm()));
    const S of_C = min(farther + bend * h * h / 8, deviation / frequency + supports.rest_distance) +
                   synchronous.displacement;
    const S of_O = of_C + e;

    // Angular acceleration and velocity bound each other through the damping.
    const S speed = abs(chart.speed(from.x)) + synchronous.speed_ripple;
    const S velocity = deviation + synchronous.velocity + speed * e;  // without the change of speed
    const S moment = rotor.bound({of_O, of_C, velocity}).moment_about_centre(body);
    const S relief = 1 - supports.damping * e * e * h / body.inertia;
    if (!(relief > S(0.5))) return std::nullopt;
    const S angular = moment / body.inertia / relief;
    const S velocity_of_O = velocity + angular * h * e;
    return MotionBounds{of_O, velocity_of_O,
                        rotor.bound({of_O, of_C, velocity_of_O}).force / body.mass,
                        speed + angular * h, angular};
  }

  /// How far the deviation is from a free damped oscillation, m/s^2.
  S drive(const Point& at, const S& frequency) const {
    const Supports<S>& supports = rotor.acting.supports;
    const S k = supports.stiffness / rotor.body.mass, d = supports.damping / rotor.body.mass;
    const Vector<S> velocity = chart.deviation_rate(at.x);
    return norm(frequency * (chart.deviation(at.rates) - velocity),
                chart.deviation_rate(at.rates) + d * velocity + k * chart.vibration(at.x));
  }
  static S norm(const Vector<S>& a, const Vector<S>& b) {
    using std::sqrt;
    return sqrt(a.x() * a.x() + a.y() * a.y() + b.x() * b.x() + b.y() * b.y());
  }
};

/// No force, but the ring is still indented, by so little that only the coordinates of contact
/// resolve it.
template <class S, ContactChartOf<S> Chart = ContactChart<S>>
struct IndentedFlight : Flight<S, Chart, ContactState::indented, 3> {
  using Base = Flight<S, Chart, ContactState::indented, 3>;
  using Base::Base, Base::rotor, Base::chart, Base::guard, Base::next;
  using typename Base::Unknowns;

  S smooth_time(const Unknowns& x) const {  // for the power of the damper
    return rotor.ring.smooth_time(chart.rim_point(x));
  }

  /// Delta = 0
  using RingClear = Exit<0>;
  S guard(RingClear /*exit*/, const Unknowns& x) const { return chart.rim_point(x).indentation; }
  Transition next(RingClear /*exit*/, const Unknowns& /*x*/) const {
    return {Event::ring_clear, ContactState::free};
  }

  /// F_n = 0 again
  using RenewedContact = Exit<1>;
  S guard(RenewedContact /*exit*/, const Unknowns& x) const {
    const RimPoint<S> k = chart.rim_point(x);
    return -rotor.ring.law.pressing(k.indentation, k.normal_velocity);
  }
  Transition next(RenewedContact /*exit*/, const Unknowns& x) const {
    return meet_ring(rotor, chart.state(x), Event::renewed_contact);
  }
};

}  // namespace rotor
