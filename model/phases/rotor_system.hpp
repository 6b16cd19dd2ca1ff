/// The rotor and all that acts on it, the events between the phases of its motion, and the maxima
/// within them.
#pragma once

#include <cmath>
#include <cstddef>

#include "model/mechanics/contact.hpp"

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

/// The quantities whose maxima a run can locate.
enum class Extreme { displacement, bearing_force, normal_force };
constexpr std::size_t extreme_count = 3;

template <class S>
struct RotorSystem {
  Body<S> body;
  ActingLoads<S> acting;
  Ring<S> ring;
  S motor_off;  ///< speed at which the motor is switched off, rad/s
  bool motor_on = true;

  /// Before the mass loss, with the motor on.
  RotorSystem(const Parameters& p, Equations equations)
      : body(Body<S>::of(p)),
        acting(p, equations),
        ring(p),
        motor_off(radians_per_turn() * as_typed<S>(p.motor_off_Hz)) {}

  /// With the ring of other parameters, and the speed at which they switch the motor off.
  RotorSystem with_ring_of(const Parameters& p, Equations equations) const {
    RotorSystem other(p, equations);
    other.body = body;
    other.acting = acting;
    other.motor_on = motor_on;
    return other;
  }

  static S radians_per_turn() {  // to the precision of S
    using std::acos;
    return 2 * acos(S(-1));
  }

  /// All loads but those of the contact.
  Loads<S> loads(const Motion<S>& motion) const { return acting.loads(body, motion, motor_on); }
  LoadBound<S> bound(const MotionBound<S>& within) const {
    return acting.bound(body, within, motor_on);
  }
  /// Until the next event, N m.
  S constant_moment() const { return acting.constant_moment(motor_on); }

  /// Becomes negative where the motor is to be switched off.
  S motor_guard(const S& speed) const { return motor_on ? motor_off - speed : S(1); }

  /// Natural frequency on the supports without contact, rad/s.
  S support_frequency() const { return natural_frequency(acting.supports.stiffness, body.mass); }

  /// Highest natural rate of change in flight, rad/s.
  S flight_frequency(const S& speed) const {
    using std::abs, std::max;
    return max({S(1), abs(speed), support_frequency()});
  }

  /// The same in contact.
  S contact_frequency(const S& speed) const {
    using std::max;
    return max(flight_frequency(speed), natural_frequency(ring.typical_stiffness(), body.mass));
  }

  /// Upper bound of the phase angle through which a motion swings in a step of length h, rad: its
  /// natural vibration with that stiffness plus the rotation, seen from the stator. Vibrations that
  /// swing further in one step are below its tolerance.
  S phase_swing(const S& vibrating_stiffness, const S& speed, const S& h) const {
    using std::abs, std::min;
    const S furthest(16);  // at the loosest tolerance steps reach about a third of it
    const S rotation = body.eccentricity > 0 ? S(abs(speed)) : S(0);
    return min(furthest, S(h * natural_frequency(vibrating_stiffness, body.mass))) + h * rotation;
  }
};

}  // namespace rotor
