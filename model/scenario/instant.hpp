/// The rotor at one instant of a run, and where runs start.
#pragma once

#include <fmt/format.h>

#include <optional>

#include "model/mechanics/rotating_frame.hpp"
#include "model/phases/rotor_system.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// What a method continues from, and what an observer is shown.
template <class S>
struct BasicInstant {
  S time_s{0};
  State<S> state{};  // at rest in O_a
  Body<S> body{};
  bool motor_on = true;
  bool mass_lost = false;  ///< whether the mass has been lost
  ContactState contact = ContactState::free;
  int slip_sign = 0;          ///< that of the slip velocity while the rim slides; 0 by fixed steps
  Event event = Event::none;  ///< what has just happened

  Motion<S> motion() const { return RotatingFrame<S>::motion(body, state); }

  /// Whether the rim is pressed against the ring.
  bool touches() const { return rotor::touches(contact); }
  /// |F_n| in its motion, N.
  S contact_force(const Ring<S>& ring, const Motion<S>& its_motion) const {
    return touches() ? S(-ring.touching_force(ring.rim_point(its_motion))) : S(0);
  }
};

using Instant = BasicInstant<double>;

/// Finds the touch-downs of a run: where the ring begins to press on a rotor that was clear of it,
/// or that started over the ring and has not been pressed yet.
class TouchDowns {
 public:
  /// Whether one comes with the next instant. To be called with the instants of a run in order.
  bool begins_with(ContactState contact) {
    // A fixed step that ends over an indented ring has pressed on it.
    const bool presses =
        touches(contact) || (contact == ContactState::indented && last_ == ContactState::free);
    const bool begins = presses && !has_pressed_;
    has_pressed_ = contact != ContactState::free && (has_pressed_ || presses);
    last_ = contact;
    return begins;
  }

 private:
  std::optional<ContactState> last_;
  bool has_pressed_ = false;  ///< since the rotor was last clear of the ring
};

/// A speed in rad/s as turns per second.
template <class S>
S in_Hz(const S& speed) {
  return speed / RotorSystem<S>::radians_per_turn();
}

/// At rest at t = 0, where a run starts unless it states a speed.
template <class S = double>
BasicInstant<S> at_rest(const Parameters& p) {
  const Vector<S> rest = Supports<S>(p).rest;
  return {.state = {rest.x(), rest.y()}, .body = Body<S>::of(p)};
}

/// At rest, in the steady response to the unbalance at the scenario's start speed, or as the
/// scenario states it, perhaps in contact. Throws ScenarioError if the rotor would touch the ring
/// at rest or in the steady response.
template <class S = double>
BasicInstant<S> start_of(const Scenario& scenario) {
  BasicInstant<S> start = at_rest<S>(scenario.parameters);
  const Parameters& p = scenario.parameters;
  const S speed = RotorSystem<S>::radians_per_turn() * as_typed<S>(scenario.start_speed_Hz);
  const bool turns = scenario.start_speed_Hz > 0;
  if (turns || scenario.start)
    start.motor_on = p.drive == Drive::motor && scenario.start_speed_Hz < p.motor_off_Hz;
  if (const auto& stated = scenario.start) {
    const Vector<S> at(as_typed<S>(stated->x), as_typed<S>(stated->y));
    const Vector<S> rate =
        Vector<S>(as_typed<S>(stated->velocity_x), as_typed<S>(stated->velocity_y)) -
        speed * quarter_turn(at);
    start.state = {at.x(), at.y(), S(0), rate.x(), rate.y(), speed};
    if (const Ring<S> ring(p); !ring.is_clear_of(start.motion()))
      start.contact = ring.contact_of(ring.rim_point(start.motion()));
    return start;
  }
  const Supports<S> supports(p);
  const Vector<S> centre =
      supports.unbalance_response(start.body, speed) - Vector<S>(start.body.eccentricity, S(0));
  const S clearance = Ring<S>(p).clearance, farthest = supports.rest_distance + centre.norm();
  if (!(farthest < clearance)) {
    Message message = {
        mention_of(scenario, "start_speed_Hz"),
        fmt::format(": the rotor would touch the ring {}, {:.4g} m from its axis, with ",
                    turns ? "in the steady response at that speed" : "at rest",
                    static_cast<double>(farthest)),
        Mention{"clearance", fmt::format("{:.4g} m", static_cast<double>(clearance))}};
    if (!supports.is_centred)
      for (const char* const offset : {"ring_offset_x", "ring_offset_y"})
        message.parts.insert(message.parts.end(), {", ", mention_of(scenario, offset)});
    throw ScenarioError(message);
  }
  const Vector<S> at = supports.rest + centre,  // and its rate in the axes O_a xy
      rate = Vector<S>(S(0), S(0)) - speed * quarter_turn(supports.rest);
  if (turns) start.state = {at.x(), at.y(), S(0), rate.x(), rate.y(), speed};
  return start;
}

/// Throws ScenarioError if the scenario's numbers or its start are not physical.
inline void check(const Scenario& scenario) {
  check_numbers(scenario);
  static_cast<void>(start_of(scenario));
}

}  // namespace rotor
