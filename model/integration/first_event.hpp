/// The first event in each of a series of steps. A system with events has event functions,
/// events(x), and an event is where one of them becomes negative. It may bound them over a step
/// beforehand, by event_bounds(x, y, duration) for a step from x to y.
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

/// Looks for events step by step. Each step starts where the last one ended, until a reset.
template <class S>
class FirstEvent {
 public:
  /// The system or its unknowns have jumped.
  void reset() { at_start_.reset(); }

  template <class Stepper, class System>
  auto in(Step<S, Stepper, System>& step) {
    const System& system = step.system();
    StepEnd<typename Step<S, Stepper, System>::Point> end{step.end(), std::nullopt};
    const auto bounds = system.event_bounds(step.start().x, step.end().x, step.end().time);
    if (bounds && std::all_of(bounds->begin(), bounds->end(),
                              [](const EventBound<S>& b) { return b.stays_positive; })) {
      at_start_.reset();
      return end;
    }
    Values before = at_start_ ? *at_start_ : observe(step, step.start());
    Values after = observe(step, end.point);
    for (std::size_t i = 0; i < System::event_count; ++i) {
      if (bounds && (*bounds)[i].stays_positive) continue;
      before[i].time = 0;
      const auto value = [&](const auto& x) { return system.events(x)[i]; };
      const auto curvature = bounds ? (*bounds)[i].curvature : std::nullopt;
      // Up to the end, which an earlier event may have moved already.
      if (const auto crossing = step.crossing(value, before[i], after[i], curvature)) {
        end = {*crossing, i};
        after = observe(step, end.point);
      }
    }
    at_start_ = after;
    return end;
  }

 private:
  static constexpr std::size_t most_events = 4;
  using Values = std::array<ValueAndSlope<S>, most_events>;

  /// All event functions at a point, with their slopes along the motion.
  template <class Step, class Point>
  static Values observe(const Step& step, const Point& at) {
    const S later = step.look_ahead();
    const auto here = step.system().events(at.x), there = step.system().events(at.ahead(later));
    static_assert(std::tuple_size_v<std::remove_const_t<decltype(here)>> <= most_events);
    Values values;
    for (std::size_t i = 0; i < here.size(); ++i)
      values[i] = {at.time, here[i], (there[i] - here[i]) / later};
    return values;
  }

  std::optional<Values> at_start_;  ///< of the next step, if they are known
};

}  // namespace rotor
