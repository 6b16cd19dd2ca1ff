/// How a run has ended, in one word.
#pragma once

#include <optional>

#include "model/scenario/instant.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// The outcome is the first of these that holds at the end of a run:
enum class Outcome {
  rolling,     ///< rolling has set in, whatever followed
  stalled,     ///< the motor hardly raises the speed, which is below 1.5 times the critical speed
  sliding,     ///< the last contact has lasted longer than a natural period of the contact
  freed,       ///< there were contacts, but the free rotor cannot reach the ring at this speed
  no_contact,  ///< there was no contact, and the free rotor cannot reach the ring at this speed
  bouncing,    ///< there were contacts, and more are possible
  undecided,   ///< there was no contact, but one is possible
};

/// The farthest that O can get from O_a, m, while the rotor stays clear of the ring and keeps its
/// speed: the steady response to the unbalance plus a vibration about it that can only decay. The
/// ripple of the speed due to gravity, and its effect on O, are neglected. Infinite unless the
/// springs of the supports are linear.
template <class S>
S reach(const Body<S>& body, const Supports<S>& supports, const Motion<S>& motion);

/// Gathers what decides the outcome. Definitions: outcome.ipp.
template <class S>
class BasicOutcomeWatch {
 public:
  explicit BasicOutcomeWatch(const Scenario& scenario);

  /// Time whose speed note_speed() needs, if the motor is on then, s.
  const S& time_of_speed_s() const { return time_of_speed_s_; }
  void note_speed(const std::optional<S>& speed) { early_speed_ = speed; }
  const std::optional<S>& early_speed() const { return early_speed_; }

  /// To be called at all events, and at the end.
  void note(const BasicInstant<S>& at);

  /// At the last instant noted.
  Outcome outcome() const;

  /// Whether the free rotor cannot reach the ring at any speed that it can have until the end of
  /// the run, driven by its motor or braked by the damping of its supports.
  bool stays_clear() const;

 private:
  bool is_stalled() const;

  Parameters parameters_;
  Supports<S> supports_;
  S until_s_, time_of_speed_s_;
  std::optional<S> early_speed_;  ///< rad/s
  std::optional<S> contact_since_s_;
  bool touched_ = false, rolled_ = false;
  BasicInstant<S> last_;
};

using OutcomeWatch = BasicOutcomeWatch<double>;

}  // namespace rotor
