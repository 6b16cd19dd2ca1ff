/// What every run checks of itself from event to event, whatever its result is used for.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "model/scenario/instant.hpp"

namespace rotor {

/// Energy enters by constant moments and by those without a potential; dampers, ring and friction
/// only take it. A drive that holds the speed may give any. A contact lasts, unless it is a graze
/// by less than rounding, and its ring is indented.
template <class S>
class RunCheck {
 public:
  /// `truncation`: allowed for the error of a step, relative to the clearance, and to the energy
  /// (at least that of the supports at the clearance) plus the work of the ring's force along that.
  explicit RunCheck(const S& truncation) : truncation_(truncation) {}

  /// That of error control: over 1,000 random rotors at a tolerance of 1e-3 the energy grew by at
  /// most 1.1 tolerances a step.
  static S truncation_of(const S& tolerance) {
    return 10 * tolerance + 1000 * std::numeric_limits<S>::epsilon();
  }
  /// That of fixed steps, without error control, and the most of all: the energy may not double.
  static constexpr double fixed_steps = 0.5;

  /// Counts from an instant on, such as just after an event.
  void begin(const RotorSystem<S>& rotor, const BasicInstant<S>& at) {
    if (from_.touches() && !at.touches() && at.time_s == contact_from_s_) grazed_s_ = at.time_s;
    if (!from_.touches()) contact_from_s_ = at.time_s;
    from_ = at;
    energy_ = energy(rotor, at);
    steps_ = 0;
    turned_ = deepest_ = least_indentation_ = S(0);
  }

  /// A step of that length, s, from a speed to another, rad/s; in contact with an indentation, m.
  void add_step(const S& length, const S& speed, const S& later_speed,
                const S& indentation = S(0)) {
    using std::abs, std::max, std::min;
    ++steps_;
    turned_ += length * (abs(speed) + abs(later_speed)) / 2;
    deepest_ = max(deepest_, indentation);
    least_indentation_ = min(least_indentation_, indentation);
  }

  /// What is wrong from there until an instant, just before an event after which the rim `touches`
  /// the ring or not.
  std::optional<std::string> fault(const RotorSystem<S>& rotor, const BasicInstant<S>& at,
                                   bool touches) const {
    using std::max, std::min;
    const S now = energy(rotor, at),
            share = min(S(fixed_steps), S(truncation_ * static_cast<S>(steps_)));
    const S grown = now - energy_ - rotor.constant_moment() * (at.state[2] - from_.state[2]);
    const S all =
        max({now, energy_, rotor.acting.supports.potential_range(at.body, rotor.ring.clearance)}) +
        rotor.ring.law.spring_force(deepest_) * rotor.ring.clearance;
    if (!at.body.has_constant_speed() &&
        !(grown <= work_without_potential(rotor) + share * all + rounding(rotor, at) +
                       rounding(rotor, from_)))
      return fmt::format("the energy grew by {:.4g} J from {:.4g} J between {:.9f} s and {:.9f} s",
                         static_cast<double>(grown), static_cast<double>(energy_),
                         static_cast<double>(from_.time_s), static_cast<double>(at.time_s));
    if (least_indentation_ < -share * rotor.ring.clearance)
      return fmt::format("contact went on across a gap of {:.4g} m",
                         static_cast<double>(-least_indentation_));
    if (at.touches() && !touches && !(at.time_s > contact_from_s_) && grazed_s_ == at.time_s)
      return "contacts begin and end at one instant, again and again";
    return std::nullopt;
  }

 private:
  /// Kinetic energy, potentials of the loads, and the energy of the ring's spring, J.
  static S energy(const RotorSystem<S>& rotor, const BasicInstant<S>& at) {
    const Motion<S> m = at.motion();
    S all = kinetic_energy(at.body, m) + rotor.acting.potential(at.body, m);
    if (at.contact != ContactState::free)
      all += rotor.ring.energy(rotor.ring.rim_point(m), at.contact);
    return all;
  }

  /// Rounding of the distance and of the angle, in that energy, J.
  static S rounding(const RotorSystem<S>& rotor, const BasicInstant<S>& at) {
    using std::abs;
    const Motion<S> m = at.motion();
    const RimPoint<S> k = rotor.ring.rim_point(m);
    const S pressure =
        at.contact == ContactState::free ? S(0) : abs(rotor.ring.law.spring_force(k.indentation));
    const LoadBound<S> loads =
        rotor.bound({k.displacement, k.displacement + at.body.eccentricity, m.velocity.norm()});
    return 100 * std::numeric_limits<S>::epsilon() *
           (pressure * k.displacement + loads.couple * (1 + abs(at.state[2])));
  }

  /// Upper bound of what loads without a potential do, J: of the weight as printed, whose arm
  /// includes that of O from O_a.
  S work_without_potential(const RotorSystem<S>& rotor) const {
    return rotor.acting.moment_without_potential(rotor.body, rotor.ring.clearance + deepest_) *
           turned_;
  }

  S truncation_;
  BasicInstant<S> from_;
  S energy_{0}, contact_from_s_{0};
  std::optional<S> grazed_s_;  ///< end of the last contact without a length
  long steps_ = 0;
  S turned_{0};  ///< angle in either direction, rad
  S deepest_{0}, least_indentation_{0};
};

}  // namespace rotor
