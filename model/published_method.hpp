/// The paper's integration: classical Runge-Kutta of fourth order with fixed steps, the friction's
/// direction decided at every stage by Eq. (23). First order at every contact, and it chatters in
/// rolling; kept exactly as published to be compared with. Source: Sec. 3.
#pragma once

#include "model/simulation.hpp"

namespace rotor {

class PublishedMethod {
 public:
  PublishedMethod(const Scenario& scenario, const Observer& observer, Work& work);

  /// Steps with `step_run_up` until `until_s`, or until just before the step that would touch.
  Instant run_up(Instant from, double until_s);
  /// Steps with `step_rub` until `until_s`, in contact or not.
  Instant rub(Instant from, double until_s);

 private:
  enum class AtTouch { go_on, stop };
  Instant advance(Instant at, double until_s, double step, AtTouch at_touch);
  ContactState contact_state(const Body<double>& body, const State<double>& state,
                             double step) const;

  const Scenario& scenario_;
  const Observer& observer_;
  Work& work_;
  Supports<double> supports_;
  Ring<double> ring_;
};

}  // namespace rotor
