/// The stages of a run by any method: run-up, mass loss, rub. The methods are EventMethod, in any
/// precision, and PublishedMethod.
#pragma once

#include "model/mechanics/mass_loss.hpp"
#include "model/scenario/observer.hpp"

namespace rotor {

/// Runs through the scenario's mass loss, if it is still to come.
template <class Method, class S>
void pass_mass_loss(Method& method, const Scenario& scenario, const MassLoss<S>& loss,
                    BasicObserver<S>& observer) {
  if (method.instant().mass_lost || !scenario.loses_mass()) return;
  method.run_up(loss.time_s, observer);
  method.advance(loss.time_s, observer);
  if (method.stopped()) return;
  observer.on_instant(method.instant());
  BasicInstant<S> at = method.instant();
  at.state = loss.lose_mass(at.state, scenario.equations);
  at.body = loss.after;
  at.mass_lost = true;
  const bool jumps = at.state != method.instant().state;
  if (at.contact == ContactState::rolling && jumps) at.contact = ContactState::sliding;
  method.restart(at);
  BasicInstant<S> after = method.instant();
  after.event = Event::mass_loss;
  observer.on_instant(after);
}

/// Runs to the end of the scenario, through its mass loss and all contacts.
template <class Method, class S>
void run_to_end(Method& method, const Scenario& scenario, const MassLoss<S>& loss,
                BasicObserver<S>& observer) {
  const S end = as_typed<S>(scenario.until);
  pass_mass_loss(method, scenario, loss, observer);
  if (!method.stopped()) {
    if (!method.instant().mass_lost) method.run_up(end, observer);
    method.advance(end, observer);
  }
  observer.on_instant(method.instant());
}

}  // namespace rotor
