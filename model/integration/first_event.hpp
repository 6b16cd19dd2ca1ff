/// The first event in a step. A system with events has event functions, event(i, x) for i up to
/// event_count, and an event is where one of them becomes negative. It may bound them over a step
/// beforehand, by event_bounds(from, to) for a step between two points.
#pragma once

#include "model/integration/step.hpp"

namespace rotor {

/// What is known of an event function over a whole step.
template <class S>
struct EventBound {
  bool stays_positive = false;
  std::optional<S> curvature{};  ///< bound of its second derivative
};

/// Where a step ends: at its first event, if there is one.
template <class Point>
struct StepEnd {
  Point point;
  std::optional<std::size_t> event;  ///< which of the system's
};

template <class S, class Stepper, class System>
auto first_event(Step<S, Stepper, System>& step) {
  const System& system = step.system();
  StepEnd<typename Step<S, Stepper, System>::Point> end{step.end(), std::nullopt};
  const auto bounds = system.event_bounds(step.start(), step.end());
  for (std::size_t i = 0; i < System::event_count; ++i) {
    if (bounds[i].stays_positive) continue;
    const auto value = [&system, i](const auto& x) { return system.event(i, x); };
    // Up to the end, which an earlier event may have moved already.
    if (const auto crossing = step.crossing(value, step.observe(value, step.start()),
                                            step.observe(value, end.point), bounds[i].curvature))
      end = {*crossing, i};
  }
  return end;
}

}  // namespace rotor
