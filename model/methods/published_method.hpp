/// The paper's integration: classical Runge-Kutta of fourth order with fixed steps, the friction's
/// direction decided at every stage by Eq. (23). First order at every contact, and it chatters in
/// rolling; kept exactly as published, for comparison. Source: "Overcritical high-speed rotor
/// systems, full annular rub and accident", Sec. 3.
#pragma once

#include "model/methods/run_check.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// A run up to its present instant; a copy continues independently, as with the event method.
class PublishedMethod {
 public:
  PublishedMethod(const Scenario& scenario, const Instant& from);

  /// Runs by steps of `step_rub` to `until_s`, in contact or not; the last one is shortened.
  void advance(double until_s, Observer& observer);

  /// Takes whole steps of `step_run_up` that end by `until_s`, and stops before the step that
  /// touches the ring.
  void run_up(double until_s, Observer& observer);

  void restart(const Instant& from);
  PublishedMethod branch(const Scenario& scenario) const {
    PublishedMethod other = *this;
    other.scenario_ = scenario;
    other.rotor_ = rotor_.with_ring_of(scenario.parameters, scenario.equations);
    return other;
  }

  const Instant& instant() const { return at_; }
  const Counters& counters() const { return counters_; }
  bool stopped() const { return stopped_; }  ///< by an observer

 private:
  void set_step(double step);
  double step_end_s() const { return origin_s_ + static_cast<double>(steps_ + 1) * step_; }
  void compute_rates(const State<double>& q, State<double>& rates);
  bool take_step(double length, double end_s, bool may_touch, Observer& observer);
  ContactState contact_state(const State<double>& state, double step);
  void check_run(bool touches);

  Scenario scenario_;
  RotorSystem<double> rotor_;
  RunCheck<double> check_;
  Instant at_;
  // Times count from the first step of a length, so that they do not depend on when other runs
  // branch off.
  double step_ = 0, origin_s_ = 0;
  long steps_ = 0;          ///< since then
  double whirl_angle_ = 0;  ///< rad
  Counters counters_;
  bool stopped_ = false;
};

}  // namespace rotor
