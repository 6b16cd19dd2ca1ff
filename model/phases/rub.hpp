/// The phases in contact: the rim slides along the ring, or rolls on it. Friction is Filippov's:
/// set-valued at zero slip, where rolling is a separate phase.
#pragma once

#include <array>
#include <limits>

#include "model/phases/contact_chart.hpp"
#include "model/phases/phase.hpp"

namespace rotor {

/// What sliding and rolling have in common. F_n may change its sign: a guard ends the phase there.
template <class S, class Chart>
struct Rub : Phase<S, Chart> {
  using Phase<S, Chart>::Phase;
  using typename Phase<S, Chart>::Unknowns;
  using Phase<S, Chart>::rotor, Phase<S, Chart>::chart;
  static constexpr bool contact_in_rates = true;

  S swing(const Unknowns& x, const S& h) const {
    return rotor.swing(rotor.ring.stiffness, x[5], h);
  }

  static constexpr std::array extremes_of = {Extreme::displacement, Extreme::bearing_force,
                                             Extreme::normal_force};
  static constexpr bool extreme_takes_rates(std::size_t i) { return i > 0; }
  std::array<ExtremeValue<S>, 3> extremes(const Unknowns& x, const Unknowns& rates) const {
    const Ring<S>& ring = rotor.ring;
    const auto k = chart.rim_point(x);
    // Components along the normal and the tangent, which turn.
    const Vector<S> position(k.displacement, 0), drift(x[3], 0);
    const Vector<S> velocity(x[3], chart.tangential_velocity(x)),
        change(rates[3], chart.tangential_velocity(rates));
    return {{{k.displacement, k.normal_velocity},
             ExtremeValue<S>::length(rotor.supports.bearing_force(position, velocity),
                                     rotor.supports.bearing_force_rate(position, drift, change)),
             {-ring.elastic_force(k), ring.stiffness * x[3] + ring.damping * rates[3]}}};
  }

  /// What the radial vibration reaches in a step, judged by its ends: the position of rest that the
  /// acceleration shows, plus 1.5 times the amplitude. The bearing force hardly follows it.
  std::array<S, 3> vibration_reach(const Point<S, Unknowns>& from,
                                   const Point<S, Unknowns>& to) const {
    using std::max, std::sqrt;
    const Ring<S>& ring = rotor.ring;
    const S square = ring.stiffness / rotor.body.mass, frequency = sqrt(square);
    std::array<S, 3> reach{};
    for (const auto* const end : {&from, &to}) {
      const S to_rest = end->rates[3] / square, speed = end->x[3] / frequency;
      const S amplitude = S(1.5) * sqrt(to_rest * to_rest + speed * speed);
      const S furthest = chart.rim_point(end->x).displacement + to_rest + amplitude;
      reach[0] = max(reach[0], furthest);
      reach[2] = max(reach[2], S(ring.stiffness * (furthest - ring.clearance) +
                                 ring.damping * frequency * amplitude));
    }
    return reach;
  }

  /// The rim pressed against the ring.
  struct Pressed {
    Pressed(const Rub& phase, const Unknowns& x)
        : at(phase.chart.kinematics(x)),
          k(phase.chart.rim_point(x)),
          normal_force(phase.rotor.ring.elastic_force(k)),
          without_friction(acceleration(phase.mobility, at.motion, phase.loads(*this))),
          per_newton(
              friction_mobility(phase.mobility, at.motion, k, phase.rotor.ring.rotor_radius)) {}

    typename Chart::Kinematics at;
    RimPoint<S> k;
    S normal_force;
    Acceleration<S> without_friction;
    Acceleration<S> per_newton;  ///< of friction
  };

  Unknowns rates(const Unknowns& x, const Pressed& p, const S& friction) const {
    return chart.rates(x, p.at, p.without_friction + friction * p.per_newton);
  }

  /// F_tau that keeps the slip constant.
  S holding_friction(const Pressed& p) const {
    return friction_without_slip(p.at.motion, p.k, p.without_friction, p.per_newton,
                                 rotor.ring.rotor_radius);
  }

  /// Positive while friction can hold the rim: |F_tau| < mu |F_n|.
  S grip(const Pressed& p, const S& holding_friction) const {
    // Friction of the size of rounding errors is available even if F_n has vanished.
    const S rounding =
        64 * std::numeric_limits<S>::epsilon() * rotor.supports.springs.force(p.k.displacement);
    const S limit = rotor.ring.friction * -p.normal_force + rounding;
    return limit * limit - holding_friction * holding_friction;
  }

  /// What follows when F_n has vanished.
  Transition release(const Unknowns& x) const {
    const bool indented = rotor.ring.is_indented_at_release(chart.rim_point(x));
    return {Event::release, indented ? ContactState::indented : ContactState::free};
  }

  /// A rim without slip rolls if friction can hold it. If not, it slides against the friction that
  /// would be needed to hold it.
  Transition leave_zero_slip(const Unknowns& x) const {
    const Pressed p(*this, x);
    const S holding = holding_friction(p);
    if (grip(p, holding) >= 0) return {Event::rolling_onset, ContactState::rolling};
    return {Event::slip_reversal, ContactState::sliding, holding > 0 ? -1 : 1};
  }

 private:
  /// All loads but friction.
  Loads<S> loads(const Pressed& p) const {
    Loads<S> all = rotor.loads(p.at.motion);
    all += rotor.ring.loads(p.k, {p.normal_force, S(0)});
    return all;
  }
};

/// The rim slides in one direction, which is the sign of the slip velocity.
template <class S, class Chart = ContactChart<S>>
struct Sliding : Rub<S, Chart> {
  using typename Rub<S, Chart>::Unknowns, typename Rub<S, Chart>::Pressed;
  using Rub<S, Chart>::rotor, Rub<S, Chart>::chart;
  int direction;

  Sliding(const RotorSystem<S>& system, const Chart& coordinates, int direction_of_slip)
      : Rub<S, Chart>(system, coordinates), direction(direction_of_slip) {}

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const Pressed p(*this, x);
    rates = this->rates(x, p, rotor.ring.sliding_friction(p.normal_force, direction));
  }

  static constexpr std::size_t event_count = 3;
  S guard(std::size_t n, const Unknowns& x) const {
    const RimPoint<S> k = chart.rim_point(x);
    switch (n) {
      case 0:
        return -rotor.ring.elastic_force(k);  // F_n = 0
      case 1:
        return S(direction) * k.slip_velocity;  // v_Ktau = 0
      default:
        return rotor.motor_guard(x[5]);  // f = f_max
    }
  }
  StepBounds<S, event_count, 3> bounds(const Point<S, Unknowns>& /*from*/,
                                       const Point<S, Unknowns>& /*to*/) const {
    StepBounds<S, event_count, 3> all;
    all.events[2].stays_positive = !rotor.motor_on;
    return all;
  }
  Transition next(std::size_t guard, Unknowns& x) const {
    switch (guard) {
      case 0:
        return this->release(x);
      case 1:
        x = chart.without_slip(x);
        return this->leave_zero_slip(x);
      default:
        return {Event::motor_off, ContactState::sliding, direction};
    }
  }

  /// Lengths nearly as small as in flight.
  Unknowns scale(const Unknowns& x) const {
    return chart.scale(rotor.ring.clearance / 100, rotor.contact_frequency(x[5]),
                       rotor.flight_frequency(x[5]) / 10);
  }
};

/// The rim rolls without slip.
template <class S, class Chart = ContactChart<S>>
struct Rolling : Rub<S, Chart> {
  using Rub<S, Chart>::Rub;
  using typename Rub<S, Chart>::Unknowns, typename Rub<S, Chart>::Pressed;
  using Rub<S, Chart>::rotor, Rub<S, Chart>::chart;

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const Pressed p(*this, x);
    rates = chart.without_slip(this->rates(x, p, this->holding_friction(p)));
  }

  static constexpr std::size_t event_count = 3;
  static constexpr bool guard_takes_loads(std::size_t n) { return n == 1; }
  S guard(std::size_t n, const Unknowns& x) const {
    switch (n) {
      case 0:
        return -rotor.ring.elastic_force(chart.rim_point(x));  // F_n = 0
      case 1: {
        const Pressed p(*this, x);
        return this->grip(p, this->holding_friction(p));  // |F_tau| = mu |F_n|
      }
      default:
        return rotor.motor_guard(x[5]);  // f = f_max
    }
  }

  /// Whether friction is too weak to hold the rim, by more than rounding: for example after the
  /// motor is switched off or mass is lost.
  bool has_no_grip(const Unknowns& x) const {
    const S surely = 1 - 1000 * std::numeric_limits<S>::epsilon();
    const Pressed p(*this, x);
    return this->grip(p, S(surely * this->holding_friction(p))) < 0;
  }

  using Point = rotor::Point<S, Unknowns>;

  /// In most steps friction stays far from its limit, and the most expensive guard need not be
  /// evaluated: twice the bound of friction at the ends of the step stays below the limit all
  /// through it, if that is as smooth as estimated_curvature assumes.
  StepBounds<S, event_count, 3> bounds(const Point& from, const Point& to) const {
    using std::max;
    const S friction = 2 * max(friction_bound(from), friction_bound(to));
    const auto reserve = [&](const Point& at) -> ValueAndSlope<S> {
      const Ring<S>& ring = rotor.ring;
      return {at.time, ring.friction * -ring.elastic_force(chart.rim_point(at.x)) - friction,
              ring.friction * (ring.stiffness * at.x[3] + ring.damping * at.rates[3])};
    };
    const auto first = reserve(from), last = reserve(to);
    StepBounds<S, event_count, 3> all;
    all.events[1].stays_positive = stays_clear(first, last, estimated_curvature(first, last));
    all.events[2].stays_positive = !rotor.motor_on;
    return all;
  }

  Transition next(std::size_t guard, Unknowns& x) const {
    switch (guard) {
      case 0:
        return this->release(x);
      case 1:
        return break_away(x);
      default:
        return {Event::motor_off, ContactState::rolling};
    }
  }

  Transition break_away(const Unknowns& x) const {
    return {Event::break_away, ContactState::sliding,
            this->holding_friction(Pressed(*this, x)) > 0 ? -1 : 1};
  }

  /// The radial oscillation is so much faster than the whirl that its errors average out.
  Unknowns scale(const Unknowns& x) const {
    return chart.scale(10 * rotor.ring.clearance, rotor.contact_frequency(x[5]),
                       rotor.flight_frequency(x[5]));
  }

 private:
  /// A bound of |F_tau|, N, from the moments about C of all other loads; infinite if C may lie on
  /// the line of friction.
  S friction_bound(const Point& at) const {
    using std::abs;
    const Body<S>& body = rotor.body;
    const Supports<S>& supports = rotor.supports;
    const RimPoint<S> k = chart.rim_point(at.x);
    const S e = body.eccentricity, r = rotor.ring.rotor_radius, w = abs(at.x[5]);
    if (!(e < r)) return std::numeric_limits<S>::infinity();
    const S support = supports.greatest_bearing_force(k.displacement, abs(at.x[3]) + r * w);
    const S moment = body.inertia * abs(at.rates[5]) + rotor.motor_torque() +
                     body.mass * supports.gravity * (k.displacement + e) +
                     e * (support + abs(rotor.ring.elastic_force(k)));
    return moment / (r - e);
  }
};

}  // namespace rotor
