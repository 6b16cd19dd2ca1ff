/// How a run has ended, in one word.
#pragma once

#include <optional>

#include "model/scenario/instant.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// Decided at the end of a run by the first of these that holds:
enum class Outcome {
  rolling,  ///< the onset of rolling has occurred, whatever followed
  stalled,  ///< the motor drives and hardly raises the speed, which is below 1.5 times the critical
  sliding,  ///< the contact lasts: longer by now than a natural period of the contact
  freed,    ///< there were contacts, and the free rotor reaches the ring no more at this speed
  no_contact,  ///< there were none, and the free rotor does not reach the ring at this speed
  bouncing,    ///< there were contacts, and there can be more
  undecided,   ///< there were none, and there can be some
};

/// How far O can get from O_a while the rotor stays clear of the ring and its speed what it is, m:
/// the steady response to the unbalance, and a vibration about it that can but die out. By how much
/// gravity makes the speed ripple, and that O swing, is left out. Infinite unless the springs of
/// the supports are linear.
template <class S>
S reach(const Body<S>& body, const Supports<S>& supports, const Motion<S>& motion);

/// Gathers what decides the outcome. Definitions: outcome.ipp.
template <class S>
class BasicOutcomeWatch {
 public:
  explicit BasicOutcomeWatch(const Scenario& scenario);

  /// When the speed is to be shown by note_speed, if the motor drives then, s.
  const S& time_of_speed_s() const { return time_of_speed_s_; }
  void note_speed(const std::optional<S>& speed) { early_speed_ = speed; }
  const std::optional<S>& early_speed() const { return early_speed_; }

  /// Takes all events, and the end.
  void note(const BasicInstant<S>& at);

  /// As of now.
  Outcome outcome() const;

  /// Whether the free rotor does not reach the ring at any speed either that it can come to until
  /// the end of the run: driven by its motor, braked by the damping of its supports.
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
