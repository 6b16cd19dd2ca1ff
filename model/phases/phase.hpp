/// A phase of the motion: the physics of rotor.hpp and contact.hpp in the coordinates of a chart,
/// and how it ends.
#pragma once

#include <array>
#include <concepts>
#include <limits>
#include <type_traits>

#include "model/integration/step.hpp"
#include "model/mechanics/rotating_frame.hpp"
#include "model/phases/rotor_system.hpp"

namespace rotor {

/// The event that ends a phase, and the phase that follows it.
struct Transition {
  Event event;
  ContactState contact;
  int slip_sign = 0;  ///< that of the slip velocity, if the rim slides then
};

/// The square of a quantity of an Extreme, and its rate. Unlike the length of a vector, its square
/// is as smooth as the motion where the vector vanishes.
template <class S>
struct SquareAndRate {
  S square;  ///< m^2 or N^2
  S rate;    ///< m^2/s or N^2/s

  static SquareAndRate of(const Vector<S>& vector, const Vector<S>& its_rate) {
    return {vector.squaredNorm(), 2 * vector.dot(its_rate)};
  }
  static SquareAndRate of(const S& number, const S& its_rate) {
    return {number * number, 2 * number * its_rate};
  }
};

/// What a phase knows about a step beforehand: about its guards, and upper bounds of its extremes.
template <class S, std::size_t guards, std::size_t extremes>
struct StepBounds {
  std::array<EventBound<S>, guards> events{};
  std::array<S, extremes> upper_bounds;

  StepBounds() { upper_bounds.fill(std::numeric_limits<S>::infinity()); }
};

/// Coordinates of a rotor.
template <class T, class S, class Unknowns = typename T::Unknowns>
concept ChartOf = requires(const T& chart, const State<S>& q, const Unknowns& x, const S& size,
                           const typename T::Kinematics& at, const Acceleration<S>& a) {
  { chart.unknowns(q) } -> std::same_as<Unknowns>;                   // from the paper's coordinates
  { chart.state(x) } -> std::same_as<State<S>>;                      // to them
  { chart.kinematics(x).motion } -> std::convertible_to<Motion<S>>;  // in a basis of its own
  { chart.speed(x) } -> std::same_as<S>;                             // of the rotor, without ripple
  { chart.speed_with_ripple(x) } -> std::same_as<S>;                 // that of the motion
  { chart.rates(x, at, a) } -> std::same_as<Unknowns>;               // from the accelerations
  { chart.scale(size, size, size) } -> std::same_as<Unknowns>;  // from length, frequency, speed
};

/// Coordinates for contact as well: K in the same basis, and unknowns or rates without slip.
template <class T, class S, class Unknowns = typename T::Unknowns>
concept ContactChartOf = ChartOf<T, S> && requires(const T& chart, const Unknowns& x) {
  { chart.rim_point(x) } -> std::same_as<RimPoint<S>>;
  { chart.without_slip(x) } -> std::same_as<Unknowns>;
};

/// Coordinates that a run keeps: recentre() moves the chart to x, if that is worth while, and
/// returns whether the rates have changed. The whirl angle, of O in the stator's frame, is
/// continuous; 0 in flight.
template <class T, class S, class Unknowns = typename T::Unknowns>
concept MovingChartOf = ChartOf<T, S> && requires(T& chart, Unknowns& x) {
  { chart.recentre(x) } -> std::same_as<bool>;
  { chart.whirl_angle(x) } -> std::same_as<S>;
};

/// The n-th exit of a phase: a guard, which becomes negative there, and what follows, which may
/// reset the unknowns.
template <std::size_t n>
using Exit = std::integral_constant<std::size_t, n>;
template <class T, class S, std::size_t n>
concept HasExit = requires(const T& phase, typename T::Unknowns& x) {
  { phase.guard(Exit<n>(), x) } -> std::same_as<S>;
  { phase.next(Exit<n>(), x) } -> std::same_as<Transition>;
};

/// Calls use(Exit<n>()) for an n below count.
template <std::size_t count, class Use>
auto with_exit(std::size_t n, const Use& use) {
  if constexpr (count > 1)
    if (n < count - 1) return with_exit<count - 1>(n, use);
  return use(Exit<count - 1>());
}

/// The motion between two events, as a system of integration/step.hpp whose events are its exits.
template <class T, class S, class Unknowns = typename T::Unknowns>
concept PhaseOf = HasExit<T, S, 0> && HasExit<T, S, 1> && HasExit<T, S, T::event_count - 1> &&
    requires(const T& phase, const Unknowns& x, Unknowns& rates, const S& time,
             const Point<S, Unknowns>& at, std::size_t i) {
  phase(x, rates, time);
  { phase.scale(x) } -> std::same_as<Unknowns>;
  { phase.bounds(at, at) } -> std::same_as<StepBounds<S, T::event_count, T::extremes_of.size()>>;
  { phase.extremes(x, rates)[i] } -> std::convertible_to<SquareAndRate<S>>;
  { phase.phase_swing(x, time) } -> std::same_as<S>;  // see RotorSystem
  { phase.smooth_time(x) } -> std::same_as<S>;
  { T::extremes_take_rates } -> std::convertible_to<bool>;
  // Whether the rates, and a guard, compute the loads of the contact.
  { T::contact_in_rates || T::guard_takes_loads(i) } -> std::same_as<bool>;
};

/// What all phases have in common. Their last exit is that the motor is switched off.
template <class S, ChartOf<S> Chart, ContactState state, std::size_t exits, Extreme... extremes>
struct Phase {
  using Unknowns = typename Chart::Unknowns;
  using Point = rotor::Point<S, Unknowns>;
  using Bounds = StepBounds<S, exits, sizeof...(extremes)>;

  static constexpr std::size_t event_count = exits;
  static constexpr std::array extremes_of = {extremes...};
  static constexpr bool guard_takes_loads(std::size_t /*n*/) { return false; }

  const RotorSystem<S>& rotor;
  const Chart& chart;
  const Mobility<S> mobility;  ///< of the body, which does not change during the phase
  const int slip_sign;         ///< if the rim slides

  Phase(const RotorSystem<S>& system, const Chart& coordinates, int sign_of_slip = 0)
      : rotor(system), chart(coordinates), mobility(system.body), slip_sign(sign_of_slip) {}

  /// f = f_max
  using MotorOff = Exit<exits - 1>;
  S guard(MotorOff /*exit*/, const Unknowns& x) const {
    return rotor.motor_guard(chart.speed_with_ripple(x));
  }
  Transition next(MotorOff /*exit*/, const Unknowns& /*x*/) const {
    return {Event::motor_off, state, slip_sign};
  }

  /// The length of a step, s, that is short beside the time since the rates were last not smooth,
  /// or until they will not be.
  S smooth_time(const Unknowns& /*x*/) const { return std::numeric_limits<S>::infinity(); }

  Bounds bounds(const Point& /*from*/, const Point& /*to*/) const {
    Bounds all;
    all.events[MotorOff()].stays_positive = !rotor.motor_on;
    return all;
  }
};

}  // namespace rotor
