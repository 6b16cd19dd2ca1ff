/// The rotor at one instant of a run, and who gets to see it.
#pragma once

#include "model/contact.hpp"
#include "model/rotating_frame.hpp"

namespace rotor {

/// What happens at an instant, where one phase of the motion ends and another one begins.
enum class Event {
  none,
  touch_down,       ///< the rim meets the ring
  release,          ///< F_n = 0, the ring still being indented
  ring_clear,       ///< the ring has come back, the rotor is clear of it
  renewed_contact,  ///< the rim meets the ring again before that
  rolling_onset,    ///< the slip ends, and friction can hold the rim
  slip_reversal,    ///< the slip ends, and friction cannot
  break_away,       ///< friction can hold the rim no longer
  motor_off,
  mass_loss,
};

/// What a method hands on, and what an observer gets to see.
template <class S>
struct BasicInstant {
  S time_s{0};
  State<S> state{};  // at rest, in static equilibrium
  Body<S> body{};
  bool motor_on = true;
  bool separated = false;
  ContactState contact = ContactState::free;
  Event event = Event::none;  ///< what has just happened
  S next_step_s{0};           ///< that the method would take from here, if it knows

  Motion<S> motion() const { return RotatingFrame<S>::motion(body, state); }
};

using Instant = BasicInstant<double>;

/// A smooth piece of a run, known at each of its times.
template <class S>
struct BasicPiece {
  S from_s, until_s;
  int arcs;  ///< parts of equal length in which its curves swing by a radian at most

  BasicPiece(const S& from, const S& until, int arcs_in_it)
      : from_s(from), until_s(until), arcs(arcs_in_it) {}
  virtual ~BasicPiece() = default;
  virtual BasicInstant<S> at(const S& time_s) const = 0;
};

/// The quantities whose maxima a run can locate.
enum class Extreme { displacement, normal_force };

/// Watches a run. It is shown, in order: both sides of every event, the end, and what it asks for.
/// A method with fixed steps shows the end of every step, and nothing in between.
template <class S>
class BasicObserver {
 public:
  virtual ~BasicObserver() = default;
  virtual void see(const BasicInstant<S>& at) = 0;

  /// Whether to be shown the pieces of the run between those times.
  virtual bool wants_pieces(const S& /*from_s*/, const S& /*until_s*/) const { return false; }
  virtual void see(const BasicPiece<S>& /*piece*/) {}

  /// Whether to be shown a maximum between those times that is not above `bound` (m or N).
  virtual bool wants(Extreme /*of*/, const S& /*bound*/, const S& /*from_s*/,
                     const S& /*until_s*/) const {
    return false;
  }
};

using Piece = BasicPiece<double>;
using Observer = BasicObserver<double>;

}  // namespace rotor
