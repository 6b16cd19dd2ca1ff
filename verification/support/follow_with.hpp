/// The same as follow.hpp in other precisions and by other steppers.
#pragma once

#include "model/methods/event_method.hpp"
#include "model/methods/whole_run.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

/// From an instant to a time by the event method, without run-up and mass loss. The observer is
/// shown both ends.
template <class S, class Stepper = Verner87<std::array<S, 6>, S>>
BasicRunEnd<S> follow_with(const Scenario& scenario, const S& tolerance,
                           const BasicInstant<S>& from, const S& until_s,
                           BasicObserver<S>& observer) {
  EventMethod<S, Stepper> method(scenario, tolerance, from);
  observer.on_instant(method.instant());
  method.advance(until_s, observer);
  observer.on_instant(method.instant());
  return {method.instant(), method.counters()};
}

/// The rotor just after its mass loss, as the scenario's own run-up leads to it.
template <class S>
BasicInstant<S> after_mass_loss_with(const Scenario& scenario, const S& tolerance) {
  EventMethod<S> method(scenario, tolerance, at_rest<S>(scenario.parameters));
  BasicObserver<S> null_observer;
  pass_mass_loss(method, scenario, MassLoss<S>(scenario.parameters), null_observer);
  return method.instant();
}

}  // namespace rotor
