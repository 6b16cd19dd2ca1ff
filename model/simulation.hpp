/// A whole run: run-up, mass loss, rub. The run-up knows nothing of friction, contact and mass loss
/// as long as the rotor stays clear of the ring, so that runs which differ only in those can share
/// it.
#pragma once

#include "model/instant.hpp"
#include "model/mass_loss.hpp"
#include "model/scenario.hpp"

namespace rotor {

/// What a run has cost.
struct Work {
  long steps = 0;                ///< that have been kept
  long right_hand_sides = 0;     ///< in these and all other steps
  long contact_evaluations = 0;  ///< of Eqs. (15)-(25), inside right-hand sides and in guards
  long located_events = 0;
};

/// The rotor at t = 0, which is where every run starts.
Instant start(const Scenario& scenario);

/// Goes on from `from`, clear of the ring, by whole steps of the method, for as long as they end
/// before `until_s` and the rotor stays clear. So the run-up does not depend on who leaves it when.
/// `work` is added to. Throws std::runtime_error if the run cannot go on.
Instant run_up(const Scenario& scenario, const Instant& from, double until_s, Observer& observer,
               Work& work);

/// Goes on from `from` to the end of the scenario, through the mass loss if it is still to come and
/// through all contacts. Otherwise as run_up.
Instant run(const Scenario& scenario, const Instant& from, Observer& observer, Work& work);

/// The part of a scenario on which its run-up depends. Scenarios whose parts are equal share it.
Scenario run_up_part(const Scenario& scenario);

/// Where the run-up of a scenario ends if the rotor does not touch the ring before, s.
double run_up_end(const Scenario& scenario);

/// The course of a run by a method that knows `run_up` and `rub`, in its own precision.
template <class Method, class S>
BasicInstant<S> run_by(Method& method, BasicObserver<S>& observer, const Scenario& scenario,
                       BasicInstant<S> at) {
  if (!at.separated) {
    const S end(run_up_end(scenario));
    at = method.rub(method.run_up(at, end), end);
    if (!scenario.loses_mass()) return at;
    const MassLoss<S> loss(scenario.parameters);
    at.state = loss.separate(at.state, scenario.equations);
    at.body = loss.after;
    at.separated = true;
    at.event = Event::mass_loss;
    if (at.contact == ContactState::rolling) at.contact = ContactState::sliding;  // until it proves
    observer.see(at);
  }
  return method.rub(at, S(scenario.until));
}

}  // namespace rotor
