/// The phases without contact force: clear of the ring, or over a ring that is still indented.
#pragma once

#include <array>
#include <optional>

#include "model/integration/first_event.hpp"
#include "model/phases/flight_chart.hpp"
#include "model/phases/rub.hpp"

namespace rotor {

/// The rim meets the ring with the slip that it has.
template <class S>
Transition meet_ring(const RotorSystem<S>& rotor, const State<S>& q, Event event) {
  const S slip = rotor.ring.rim_point(RotatingFrame<S>::motion(rotor.body, q)).slip_velocity;
  if (slip != 0) return {event, ContactState::sliding, slip > 0 ? 1 : -1};
  const ContactChart<S> chart(rotor, q);
  Transition next = Rolling<S>(rotor, chart).leave_zero_slip(chart.without_slip(chart.unknowns(q)));
  next.event = event;
  return next;
}

/// How a motion goes on that is taken up in contact with the ring, perhaps after a jump.
template <class S>
Transition resume_contact(const RotorSystem<S>& rotor, const State<S>& q, ContactState contact) {
  const auto k = rotor.ring.rim_point(RotatingFrame<S>::motion(rotor.body, q));
  if (rotor.ring.elastic_force(k) > 0) return {Event::none, ContactState::indented};
  if (contact == ContactState::rolling) return {Event::none, contact};
  return meet_ring(rotor, q, Event::none);
}

/// What both have in common.
template <class S, class Chart>
struct Flight : Phase<S, Chart> {
  using typename Phase<S, Chart>::Unknowns;
  using Phase<S, Chart>::rotor, Phase<S, Chart>::chart;
  static constexpr bool contact_in_rates = false;

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const auto at = chart.kinematics(x);
    rates = chart.rates(x, at, acceleration(rotor.body, at.motion, rotor.loads(at.motion)));
  }

  S swing(const Unknowns& x, const S& h) const {
    return rotor.swing(rotor.supports.stiffness, x[5], h);
  }

  /// Every contact multiplies the errors that it begins with, and a flight is cheap: its lengths
  /// are measured by a small part of the clearance. The speed hardly changes, but its ripple must
  /// not pass unnoticed under long steps.
  Unknowns scale(const Unknowns& x) const {
    const S w = rotor.flight_frequency(x[5]);
    return chart.scale(rotor.ring.clearance / 300, w, w / 100);
  }
};

/// Clear of the ring.
template <class S, class Chart = FlightChart<S>>
struct FreeFlight : Flight<S, Chart> {
  using typename Flight<S, Chart>::Unknowns;
  using Flight<S, Chart>::rotor, Flight<S, Chart>::chart;
  static constexpr bool contact_in_guards = false;

  FreeFlight(const RotorSystem<S>& system, const Chart& coordinates)
      : Flight<S, Chart>{{system, coordinates}} {}

  static constexpr std::size_t event_count = 2;
  std::array<S, event_count> guards(const Unknowns& x) const {
    const S clearance = rotor.ring.clearance;
    const auto at = chart.kinematics(x);
    return {clearance * clearance - at.motion.displacement.squaredNorm(),  // rho = r_a - r
            rotor.motor_guard(x[5])};                                      // f = f_max
  }
  Transition next(std::size_t guard, const Unknowns& x) const {
    if (guard == 0) return meet_ring(rotor, chart.state(x), Event::touch_down);
    return {Event::motor_off, ContactState::free};
  }

  /// Whether the guards can end the phase within a step from x to y of length h, and how fast that
  /// of touch-down can bend.
  std::optional<std::array<EventBound<S>, event_count>> event_bounds(const Unknowns& x,
                                                                     const Unknowns& y,
                                                                     const S& h) const {
    const auto bounds = motion_bounds(x, h);
    if (!bounds) return std::nullopt;
    const S e = rotor.body.eccentricity;
    const S of_O =
        bounds->acceleration + e * (bounds->speed * bounds->speed + bounds->angular_acceleration);
    const S bend = 2 * (bounds->velocity * bounds->velocity + rotor.ring.clearance * of_O);
    return std::array<EventBound<S>, event_count>{
        {{reach(*bounds, x, y, h) < rotor.ring.clearance, bend},
         {!rotor.motor_on || bounds->speed < rotor.motor_off, std::nullopt}}};
  }

  std::array<ExtremeValue<S>, 1> extremes(const Unknowns& x, const Unknowns& /*rates*/) const {
    const Motion<S> m = chart.kinematics(x).motion;
    const S rho = m.displacement.norm();
    const S rate = rho > 0 ? S(m.displacement.dot(m.velocity) / rho) : S(0);
    return {{{Extreme::displacement, rho, rate}}};
  }

  /// A bound of rho within a step from x to y of length h, if it can be told, m.
  std::optional<S> reach(const Unknowns& x, const Unknowns& y, const S& h) const {
    const auto bounds = motion_bounds(x, h);
    return bounds ? std::optional(reach(*bounds, x, y, h)) : std::nullopt;
  }

 private:
  struct Bounds {
    S velocity;      ///< of O, m/s
    S acceleration;  ///< of C, m/s^2
    S speed;         ///< rad/s
    S angular_acceleration;
  };

  S reach(const Bounds& bounds, const Unknowns& x, const Unknowns& y, const S& h) const {
    using std::max, std::sqrt;
    const S farther = max(x[0] * x[0] + x[1] * x[1], y[0] * y[0] + y[1] * y[1]);
    const S of_C = sqrt(farther) + max(chart.steady_amplitude(x), chart.steady_amplitude(y)) +
                   bounds.acceleration * h * h / 8;
    return of_C + rotor.body.eccentricity;
  }

  /// Bounds that hold from x on for a time h, as long as O is inside the clearance. The velocity is
  /// assumed to stay below a bound; if the loads that this allows cannot drive it there, it does.
  std::optional<Bounds> motion_bounds(const Unknowns& x, const S& h) const {
    using std::abs, std::sqrt;
    const Body<S>& body = rotor.body;
    const Supports<S>& supports = rotor.supports;
    const S clearance = rotor.ring.clearance, e = body.eccentricity;
    const S speed = abs(x[5]);
    const S velocity_of_C = sqrt(x[3] * x[3] + x[4] * x[4]) + speed * chart.steady_amplitude(x);
    const S spring = supports.stiffness * clearance;

    const S velocity = 2 * (velocity_of_C + speed * e + spring / body.mass * h);
    const S force = spring + supports.damping * velocity;
    const S moment = supports.torque + supports.damping * clearance * velocity +
                     (clearance + e) * (body.mass * supports.gravity + force);
    const Bounds bounds{velocity, force / body.mass, speed + moment / body.inertia * h,
                        moment / body.inertia};
    if (velocity_of_C + bounds.acceleration * h + bounds.speed * e > velocity) return std::nullopt;
    return bounds;
  }
};

/// Without force, the ring still being indented: by how little, only the coordinates of contact
/// know.
template <class S, class Chart = ContactChart<S>>
struct IndentedFlight : Flight<S, Chart> {
  using typename Flight<S, Chart>::Unknowns;
  using Flight<S, Chart>::rotor, Flight<S, Chart>::chart;
  static constexpr bool contact_in_guards = true;

  IndentedFlight(const RotorSystem<S>& system, const Chart& coordinates)
      : Flight<S, Chart>{{system, coordinates}} {}

  static constexpr std::size_t event_count = 3;
  std::array<S, event_count> guards(const Unknowns& x) const {
    const RimPoint<S> k = chart.rim_point(x);
    return {k.indentation,                // Delta = 0
            rotor.ring.elastic_force(k),  // k_t Delta + d_t Delta' = 0
            rotor.motor_guard(x[5])};     // f = f_max
  }
  Transition next(std::size_t guard, const Unknowns& x) const {
    switch (guard) {
      case 0:
        return {Event::ring_clear, ContactState::free};
      case 1:
        return meet_ring(rotor, chart.state(x), Event::renewed_contact);
      default:
        return {Event::motor_off, ContactState::indented};
    }
  }
};

}  // namespace rotor
