/// A phase of the motion: the physics of rotor.hpp and contact.hpp in the coordinates of a chart,
/// and how it ends.
///
/// A chart has Unknowns for coordinates and says what they mean:
///   unknowns(q), state(x)    from and to the paper's coordinates
///   kinematics(x)            the motion, in a basis of the chart's own
///   speed(x)                 of the rotor, without ripple
///   whirl_angle(x)           of O in the stator's frame, continuous; 0 in flight
///   rim_point(x)             K, in the same basis
///   rates(x, kinematics, a)  of the unknowns, from the accelerations
///   scale(...)               of the unknowns, from those of the motion
///   recentre(x)              moves the chart to x, if that is worth while
///
/// A phase is a system of integration/step.hpp. It ends where one of its guards, which are its
/// event functions, becomes negative; next() returns what follows, and resets the unknowns if
/// necessary.
#pragma once

#include <array>
#include <limits>

#include "model/integration/step.hpp"
#include "model/phases/rotor_system.hpp"

namespace rotor {

/// What happens between two phases.
enum class Event {
  none,
  touch_down,       ///< the rim meets the ring
  release,          ///< F_n = 0; a damped ring is still indented
  ring_clear,       ///< the ring has sprung back, the rotor is clear of it
  renewed_contact,  ///< the rim meets the ring again before it is clear
  rolling_onset,    ///< the slip ends, and friction can hold the rim
  slip_reversal,    ///< the slip ends, and friction cannot hold the rim
  break_away,       ///< friction can no longer hold the rim
  motor_off,
  mass_loss,
};

/// The event that ends a phase, and the phase that follows it.
struct Transition {
  Event event;
  ContactState contact;
  int direction = 0;  ///< sign of the slip velocity, if the rim slides then
};

/// The quantities whose maxima a run can locate.
enum class Extreme { displacement, bearing_force, normal_force };
constexpr std::size_t extreme_count = 3;

/// Such a quantity. It has a maximum where its rate becomes negative.
template <class S>
struct ExtremeValue {
  S value;  ///< m or N
  S rate;   ///< m/s or N/s

  /// The length of a vector.
  static ExtremeValue length(const Vector<S>& vector, const Vector<S>& rate) {
    const S length = vector.norm();
    return {length, length > 0 ? S(vector.dot(rate) / length) : S(0)};
  }
};

/// What a phase knows about a step beforehand: about its guards, and upper bounds of its extremes.
template <class S, std::size_t guards, std::size_t extremes>
struct StepBounds {
  std::array<EventBound<S>, guards> events{};
  std::array<S, extremes> reach;

  StepBounds() { reach.fill(std::numeric_limits<S>::infinity()); }
};

template <class S, class Chart>
struct Phase {
  using Unknowns = typename Chart::Unknowns;

  /// Whether the n-th guard computes all loads of the contact.
  static constexpr bool guard_takes_loads(std::size_t /*n*/) { return false; }

  const RotorSystem<S>& rotor;
  const Chart& chart;
  const Mobility<S> mobility;  ///< of the body, which does not change during the phase

  Phase(const RotorSystem<S>& system, const Chart& coordinates)
      : rotor(system), chart(coordinates), mobility(system.body) {}
};

}  // namespace rotor
