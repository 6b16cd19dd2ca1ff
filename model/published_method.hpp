/// The paper's integration: classical Runge-Kutta of fourth order with fixed steps, the friction's
/// direction decided at every stage by Eq. (23). First order at every contact, and it chatters in
/// rolling; kept exactly as published to be compared with. Source:
/// "Overcritical high-speed rotor systems, full annular rub and accident",
/// Sec. 3.
#pragma once

#include "model/simulation.hpp"

namespace rotor {

class PublishedMethod {
 public:
  PublishedMethod(const Scenario& scenario, Observer& observer, Work& work);

  /// Whole steps of `step_run_up` that end before or at `until_s`, and before the step that
  /// touches.
  Instant run_up(Instant from, double until_s);
  /// Steps of `step_rub` to `until_s`, in contact or not; the last one is shortened.
  Instant rub(Instant from, double until_s);

 private:
  enum class Extent { everything, whole_steps };
  Instant advance(Instant at, double until_s, double step, Extent extent);
  ContactState contact_state(const Body<double>& body, const State<double>& state,
                             double step) const;

  const Scenario& scenario_;
  Observer& observer_;
  Work& work_;
  Supports<double> supports_;
  Ring<double> ring_;
};

}  // namespace rotor
