/// The phases in contact: the rim slides along the ring, or rolls on it. Friction is Filippov's:
/// set-valued at zero slip, where rolling is a separate phase.
#pragma once

#include <array>
#include <limits>

#include "model/phases/contact_chart.hpp"
#include "model/phases/phase.hpp"

namespace rotor {

/// What sliding and rolling have in common. F_n may change its sign: a guard ends the phase there.
/// The ring's law is a type, so that no evaluation has to ask which it is.
template <class S, ContactChartOf<S> Chart, ContactState state, class Law>
struct Rub : Phase<S, Chart, state, 3, Extreme::displacement, Extreme::bearing_force,
                   Extreme::normal_force> {
  using Base = Phase<S, Chart, state, 3, Extreme::displacement, Extreme::bearing_force,
                     Extreme::normal_force>;
  using Base::Base, Base::rotor, Base::chart, Base::mobility, Base::guard, Base::next;
  using typename Base::Unknowns, typename Base::Point;
  static constexpr bool contact_in_rates = true;

  const Law& law() const {
    if constexpr (std::is_same_v<Law, ContactLaw<S>>)
      return rotor.ring.law;
    else
      return rotor.ring.law.linear();
  }
  /// F_n, N; positive where the ring would have to pull.
  S force(const RimPoint<S>& k) const { return law().force(k.indentation, k.normal_velocity); }
  /// Rate of -F_n, N/s.
  S pressure_rate(const RimPoint<S>& k, const Unknowns& rates) const {
    return law().pressure_rate(k.indentation, rates[Chart::indentation],
                               rates[Chart::normal_velocity]);
  }

  S phase_swing(const Unknowns& x, const S& h) const {
    using std::abs;
    const RimPoint<S> k = chart.rim_point(x);
    const S deepest = k.indentation + abs(k.normal_velocity) * h;
    return rotor.phase_swing(law().tangent_stiffness(deepest), chart.speed(x), h);
  }

  S smooth_time(const Unknowns& x) const {
    if constexpr (std::is_same_v<Law, ContactLaw<S>>)
      return rotor.ring.smooth_time(chart.rim_point(x));
    else
      return Base::smooth_time(x);
  }

  static constexpr bool extremes_take_rates = true;
  std::array<SquareAndRate<S>, 3> extremes(const Unknowns& x, const Unknowns& rates) const {
    const auto k = chart.rim_point(x);
    const Supports<S>& supports = rotor.acting.supports;
    // Components along the normal and the tangent, which turn.
    Vector<S> position(k.displacement, 0), drift(rates[Chart::indentation], 0);
    if (!supports.is_centred) [[unlikely]] {  // the position of rest turns backwards
      const Motion<S> m = chart.kinematics(x).motion;
      const Vector<S> rest = m.from_stator(supports.rest);
      position -= rest;
      drift += m.velocity.y() / k.displacement * quarter_turn(rest);
    }
    const Vector<S> velocity(k.normal_velocity, chart.tangential_velocity(x)),
        change(rates[Chart::normal_velocity], chart.tangential_velocity(rates));
    return {{SquareAndRate<S>::of(k.displacement, rates[Chart::indentation]),
             SquareAndRate<S>::of(supports.bearing_force(position, velocity),
                                  supports.bearing_force(drift, change)),
             SquareAndRate<S>::of(S(-force(k)), pressure_rate(k, rates))}};
  }

  typename Base::Bounds bounds(const Point& from, const Point& to) const {
    typename Base::Bounds all = Base::bounds(from, to);
    if (rotor.ring.law.is_linear()) all.upper_bounds = reach(from, to);
    return all;
  }

  /// Upper bounds of the extremes in a step on a linear ring, judged by its ends: by the position
  /// of rest that the radial acceleration shows, 1.5 times the amplitude of the vibration about it,
  /// and what slower motion adds. There are none in a step longer than a period of the vibration:
  /// its interpolant may leave what the ends allow.
  std::array<S, 3> reach(const Point& from, const Point& to) const {
    using std::abs, std::max, std::sqrt;
    const Ring<S>& ring = rotor.ring;
    const Supports<S>& supports = rotor.acting.supports;
    const auto& [stiffness, damping] = ring.law.linear();
    const S square = stiffness / rotor.body.mass, frequency = sqrt(square), h = to.time - from.time,
            longest = max<S>(1 / frequency, h / 4);
    std::array<S, 3> all{};
    if (!(frequency * h < RotorSystem<S>::radians_per_turn())) {
      all.fill(std::numeric_limits<S>::infinity());
      return all;
    }
    for (const Point* const end : {&from, &to}) {
      const RimPoint<S> k = chart.rim_point(end->x);
      const S to_rest = end->rates[Chart::normal_velocity] / square,
              swing = k.normal_velocity * longest;
      const S amplitude = S(1.5) * sqrt(to_rest * to_rest + swing * swing);
      const S furthest = k.displacement + to_rest + amplitude, fastest = frequency * amplitude;
      const S across =
          abs(chart.tangential_velocity(end->x)) + h * abs(chart.tangential_velocity(end->rates));
      all[0] = max(all[0], furthest);
      const Vector<S> bearings(supports.bearing_force(furthest, fastest),
                               supports.bearing_force(S(0), across));
      all[1] = max(all[1], S(bearings.norm() + supports.stiffness * supports.rest_distance));
      all[2] = max(all[2], S(stiffness * (furthest - ring.clearance) + damping * fastest));
    }
    return all;
  }

  /// The rim pressed against the ring.
  struct Pressed {
    Pressed(const Rub& phase, const Unknowns& x)
        : at(phase.chart.kinematics(x)),
          k(phase.chart.rim_point(x)),
          normal_force(phase.force(k)),
          supports(phase.rotor.loads(at.motion)) {}

    typename Chart::Kinematics at;
    RimPoint<S> k;
    S normal_force;
    Loads<S> supports;
  };

  Unknowns rates(const Unknowns& x, const Pressed& p, const S& friction) const {
    Loads<S> loads = p.supports;
    loads += rotor.ring.loads(p.k, {p.normal_force, friction});
    return chart.rates(x, p.at, acceleration(mobility, p.at.motion, loads));
  }

  /// F_tau that keeps the slip constant.
  S holding_friction(const Pressed& p) const {
    return friction_without_slip(mobility, rotor.ring, p.at.motion, p.k, p.supports,
                                 p.normal_force);
  }

  /// Positive while friction can hold the rim: |F_tau| < mu |F_n|.
  S grip(const Pressed& p, const S& holding_friction) const {
    // Friction of the size of rounding errors is available even if F_n has vanished.
    const Supports<S>& supports = rotor.acting.supports;
    const S rounding = 64 * std::numeric_limits<S>::epsilon() * supports.stiffness *
                       (p.k.displacement + supports.rest_distance);
    const S limit = rotor.ring.friction * -p.normal_force + rounding;
    return limit * limit - holding_friction * holding_friction;
  }

  /// F_n = 0 of a ring with a dashpot, which is still indented then; Delta = 0 of one without
  using Release = Exit<0>;
  S guard(Release /*exit*/, const Unknowns& x) const {
    const RimPoint<S> k = chart.rim_point(x);
    return law().pressing(k.indentation, k.normal_velocity);
  }
  Transition next(Release /*exit*/, const Unknowns& /*x*/) const {
    return {Event::release,
            rotor.ring.law.has_dashpot() ? ContactState::indented : ContactState::free};
  }

  /// A rim without slip rolls if there is friction, and it can hold the rim. If not, the rim slides
  /// against the friction that would be needed to hold it.
  Transition leave_zero_slip(const Unknowns& x) const {
    const Pressed p(*this, x);
    const S holding = holding_friction(p);
    if (rotor.ring.friction > 0 && grip(p, holding) >= 0)
      return {Event::rolling_onset, ContactState::rolling};
    return {Event::slip_reversal, ContactState::sliding, holding > 0 ? -1 : 1};
  }
};

/// The rim slides, and the slip velocity keeps its sign.
template <class S, class Chart = ContactChart<S>, class Law = ContactLaw<S>>
struct Sliding : Rub<S, Chart, ContactState::sliding, Law> {
  using Base = Rub<S, Chart, ContactState::sliding, Law>;
  using Base::rotor, Base::chart, Base::slip_sign, Base::guard, Base::next;
  using typename Base::Unknowns, typename Base::Pressed;

  Sliding(const RotorSystem<S>& system, const Chart& coordinates, int sign_of_slip)
      : Base(system, coordinates, sign_of_slip) {}

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const Pressed p(*this, x);
    rates = this->rates(x, p, rotor.ring.sliding_friction(p.normal_force, slip_sign));
  }

  /// v_Ktau = 0
  using SlipEnd = Exit<1>;
  S guard(SlipEnd /*exit*/, const Unknowns& x) const {
    return S(slip_sign) * chart.rim_point(x).slip_velocity;
  }
  Transition next(SlipEnd /*exit*/, Unknowns& x) const {
    x = chart.without_slip(x);
    return this->leave_zero_slip(x);
  }

  /// Lengths nearly as small as in flight.
  Unknowns scale(const Unknowns& x) const {
    return chart.scale(rotor.ring.clearance / 100, rotor.contact_frequency(chart.speed(x)),
                       rotor.flight_frequency(chart.speed(x)) / 10);
  }
};

/// The rim rolls without slip.
template <class S, class Chart = ContactChart<S>, class Law = ContactLaw<S>>
struct Rolling : Rub<S, Chart, ContactState::rolling, Law> {
  using Base = Rub<S, Chart, ContactState::rolling, Law>;
  using Base::Base, Base::rotor, Base::chart, Base::guard, Base::next;
  using typename Base::Unknowns, typename Base::Point, typename Base::Pressed;

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const Pressed p(*this, x);
    rates = chart.without_slip(this->rates(x, p, this->holding_friction(p)));
  }

  /// |F_tau| = mu |F_n|
  using BreakAway = Exit<1>;
  S guard(BreakAway /*exit*/, const Unknowns& x) const {
    const Pressed p(*this, x);
    return this->grip(p, this->holding_friction(p));
  }
  Transition next(BreakAway /*exit*/, const Unknowns& x) const {
    return {Event::break_away, ContactState::sliding,
            this->holding_friction(Pressed(*this, x)) > 0 ? -1 : 1};
  }
  static constexpr bool guard_takes_loads(std::size_t n) { return n == BreakAway(); }

  /// Whether friction is too weak to hold the rim, by more than rounding: for example after the
  /// motor is switched off or mass is lost.
  bool has_no_grip(const Unknowns& x) const {
    const S surely = 1 - 1000 * std::numeric_limits<S>::epsilon();
    const Pressed p(*this, x);
    return this->grip(p, S(surely * this->holding_friction(p))) < 0;
  }

  /// In most steps friction stays far from its limit, and the most expensive guard need not be
  /// evaluated: twice the bound of friction at the ends of the step stays below the limit all
  /// through it, if that is as smooth as estimated_curvature assumes.
  typename Base::Bounds bounds(const Point& from, const Point& to) const {
    using std::max;
    const S friction = 2 * max(friction_bound(from), friction_bound(to));
    const auto reserve = [&](const Point& at) -> ValueAndSlope<S> {
      const Ring<S>& ring = rotor.ring;
      const RimPoint<S> k = chart.rim_point(at.x);
      return {at.time, ring.friction * -this->force(k) - friction,
              ring.friction * this->pressure_rate(k, at.rates)};
    };
    const auto first = reserve(from), last = reserve(to);
    typename Base::Bounds all = Base::bounds(from, to);
    all.events[BreakAway()].stays_positive =
        stays_clear(first, last, estimated_curvature(first, last));
    return all;
  }

  /// The radial oscillation is so much faster than the whirl that its errors average out.
  Unknowns scale(const Unknowns& x) const {
    return chart.scale(10 * rotor.ring.clearance, rotor.contact_frequency(chart.speed(x)),
                       rotor.flight_frequency(chart.speed(x)));
  }

 private:
  /// A bound of |F_tau|, N, from the moments about C of all other loads; infinite if C may lie on
  /// the line of friction.
  S friction_bound(const Point& at) const {
    using std::abs;
    const Body<S>& body = rotor.body;
    const RimPoint<S> k = chart.rim_point(at.x);
    const S e = body.eccentricity, r = rotor.ring.rotor_radius, w = abs(chart.speed(at.x));
    if (!(e < r)) return std::numeric_limits<S>::infinity();
    LoadBound<S> loads =
        rotor.bound({k.displacement, k.displacement + e, abs(k.normal_velocity) + r * w});
    loads.force += abs(this->force(k));
    return (body.inertia * abs(at.rates[Chart::rotor_speed]) + loads.moment_about_centre(body)) /
           (r - e);
  }
};

}  // namespace rotor
