/// Integration with error control, phase by phase, each ending at a located event: no step
/// straddles a jump, and every step has the full order of its Odeint stepper. Scalar (for higher
/// precision) and stepper are template parameters. Definitions: event_method.ipp.
#pragma once

#include <array>
#include <optional>
#include <variant>

#include "model/integration/first_event.hpp"
#include "model/integration/verner.hpp"
#include "model/methods/switch_limit.hpp"
#include "model/phases/contact_chart.hpp"
#include "model/phases/flight_chart.hpp"
#include "model/scenario/counters.hpp"
#include "model/scenario/observer.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// A run up to its present instant. A copy continues independently: runs that differ only later
/// share their beginning. Throws std::runtime_error, with time and reason, if it cannot continue.
template <class S, class Stepper = Verner87<std::array<S, 6>, S>>
class EventMethod {
 public:
  /// Starts at an instant. `tolerance`: error allowed in a step, relative to the phases' scale.
  EventMethod(const Scenario& scenario, const S& tolerance, const BasicInstant<S>& from);

  /// The same for a rotor whose numbers need not be doubles.
  EventMethod(const RotorSystem<S>& rotor, const S& tolerance, const BasicInstant<S>& from);

  /// Runs to `until_s`, in contact or not.
  void advance(const S& until_s, BasicObserver<S>& observer);

  /// Takes all whole steps that end before `until_s`, so that the steps do not depend on when other
  /// runs branch off.
  void approach(const S& until_s, BasicObserver<S>& observer);

  /// The same, and stops before the step that touches the ring.
  void run_up(const S& until_s, BasicObserver<S>& observer);

  /// Continues from another instant, such as one after a jump.
  void restart(const BasicInstant<S>& from);

  /// The same motion with the ring of another scenario, whose run-up part is the same.
  EventMethod with(const Scenario& scenario) const;

  /// Scales the first steps in flight and in contact, whatever the tolerance. To be called at the
  /// start.
  void shorten_first_steps(const S& share);
  /// Disturbs the slip at each touch-down by a share. It is rounded there, and the velocity of O is
  /// the small difference between slip and velocity of the rim.
  void disturb_touch_downs(const S& share) { slip_disturbance_ = share; }

  const BasicInstant<S>& instant() const { return at_; }
  const Counters& counters() const { return counters_; }
  bool stopped() const { return stopped_; }  ///< by an observer

 private:
  using Unknowns = std::array<S, 6>;
  using Point = rotor::Point<S, Unknowns>;
  enum class Extent { everything, whole_steps, clear_whole_steps };

  void advance(const S& until_s, BasicObserver<S>& observer, Extent extent);
  std::optional<Transition> follow_phase(const S& until_s, BasicObserver<S>& observer,
                                         Extent extent);
  template <class Phase, class Chart>
  std::optional<Transition> follow(const Phase& phase, Chart& chart, S& step, const S& until_s,
                                   BasicObserver<S>& observer, Extent extent);
  void enter(const Transition& next);
  template <class Chart>
  Chart& chart();

  void count_step();
  void require_progress(const S& step) const;
  void limit_switches();
  [[noreturn]] void fail(const std::string& reason) const;

  ErrorControl<S, Stepper> control_;
  RotorSystem<S> rotor_;
  BasicInstant<S> at_;
  std::variant<std::monostate, FlightChart<S>, ContactChart<S>> chart_;  ///< none after a restart
  Point start_;                         ///< of the next step, in that chart
  bool phase_is_new_ = true;            ///< whether the rates are not yet known there
  S flight_step_{0}, contact_step_{0};  ///< to try next; 0 until the first contact
  S first_steps_{1};                    ///< factor on their usual length
  S slip_disturbance_{0};               ///< relative, at each touch-down
  Counters counters_;
  SwitchLimit<S> switch_limit_;
  bool stopped_ = false;
};

extern template class EventMethod<double>;
extern template class EventMethod<long double>;

}  // namespace rotor
