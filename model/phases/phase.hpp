/// A phase of the motion: the physics of rotor.hpp and contact.hpp in the coordinates of a chart,
/// and how it ends.
///
/// A chart has Unknowns for coordinates and says what they mean:
///   unknowns(q), state(x)    from and to the paper's coordinates
///   kinematics(x)            the motion, in a basis of the chart's own
///   speed(x)                 of the rotor, ripple aside
///   rim_point(x)             K, in the same basis
///   rates(x, kinematics, a)  of the unknowns, from the accelerations
///   scale(...)               of the unknowns, from those of the motion
///   recentre(x)              moves the chart to x, if that has become worth while
///
/// A phase is a system of integration/step.hpp. It ends where one of its guards, which are its
/// event functions, becomes negative; next() says what follows, and resets the unknowns where that
/// needs it.
#pragma once

#include "model/phases/rotor_system.hpp"
#include "model/phases/transition.hpp"

namespace rotor {

/// The quantities whose maxima a run can locate.
enum class Extreme { displacement, normal_force };

/// Such a quantity. It has its maximum where its rate becomes negative.
template <class S>
struct ExtremeValue {
  Extreme of;
  S value;  ///< m or N
  S rate;   ///< m/s or N/s
};

template <class S, class Chart>
struct Phase {
  using Unknowns = typename Chart::Unknowns;

  /// Whether the n-th guard works out all loads of the contact.
  static constexpr bool guard_takes_loads(std::size_t /*n*/) { return false; }

  const RotorSystem<S>& rotor;
  const Chart& chart;
};

}  // namespace rotor
