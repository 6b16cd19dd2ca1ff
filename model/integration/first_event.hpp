/// The first event in a step. A system with events has event functions, event(i, x) for i below
/// event_count; an event is where one of them becomes negative. Its bounds(from, to) has in
/// `events` what is known about them before a step between two points is searched.
#pragma once

#include "model/integration/step.hpp"

namespace rotor {

/// What is known about an event function over a whole step.
template <class S>
struct EventBound {
  bool stays_positive = false;
  std::optional<S> curvature{};  ///< bound on its second derivative
};

/// Which of the system's events ends a step, if one does. The step stops there.
template <class S, class Stepper, class System>
std::optional<std::size_t> first_event(Step<S, Stepper, System>& step) {
  std::optional<std::size_t> first;
  for (std::size_t i = 0; i < System::event_count; ++i) {
    const EventBound<S>& bound = step.bounds().events[i];
    if (bound.stays_positive) continue;
    const auto value = [&step, i](const auto& x) { return step.system().event(i, x); };
    // Only up to the stop, which an event found before may have moved.
    if (const auto crossing = step.crossing(value, step.observe(value, step.start()),
                                            step.observe(value, step.stop()), bound.curvature)) {
      step.stop_at(*crossing);
      first = i;
    }
  }
  return first;
}

}  // namespace rotor
