/// Definitions of event_method.hpp, for instantiation.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "model/methods/event_method.hpp"
#include "model/methods/phase_system.hpp"
#include "model/methods/show_step.hpp"
#include "model/phases/flight.hpp"

namespace rotor {

template <class S, class Stepper>
EventMethod<S, Stepper>::EventMethod(const Scenario& scenario, const S& tolerance,
                                     const BasicInstant<S>& from)
    : EventMethod(RotorSystem<S>(scenario.parameters, scenario.equations), tolerance, from) {}

template <class S, class Stepper>
EventMethod<S, Stepper>::EventMethod(const RotorSystem<S>& rotor, const S& tolerance,
                                     const BasicInstant<S>& from)
    : control_(tolerance), rotor_(rotor) {
  restart(from);
  flight_step_ = S(0.01) / rotor_.flight_frequency(at_.state[5]);
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::restart(const BasicInstant<S>& from) {
  at_ = from;
  at_.event = Event::none;
  rotor_.body = at_.body;
  rotor_.motor_on = at_.motor_on;
  chart_ = {};
  phase_is_new_ = true;
  switch_limit_.restart(at_.time_s);
  if (at_.contact != ContactState::free) enter(resume_contact(rotor_, at_.state, at_.contact));
}

template <class S, class Stepper>
EventMethod<S, Stepper> EventMethod<S, Stepper>::with(const Scenario& scenario) const {
  EventMethod branch = *this;
  branch.rotor_.ring = Ring<S>(scenario.parameters);
  return branch;
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::shorten_first_steps(const S& share) {
  first_steps_ = share;
  flight_step_ *= share;
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::advance(const S& until_s, BasicObserver<S>& observer) {
  advance(until_s, observer, Extent::everything);
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::approach(const S& until_s, BasicObserver<S>& observer) {
  advance(until_s, observer, Extent::whole_steps);
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::run_up(const S& until_s, BasicObserver<S>& observer) {
  advance(until_s, observer, Extent::clear_whole_steps);
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::advance(const S& until_s, BasicObserver<S>& observer, Extent extent) {
  while (at_.time_s < until_s && !stopped_) {
    const std::optional<Transition> next = follow_phase(until_s, observer, extent);
    if (!next) return;
    limit_switches();
    observer.on_instant(at_);
    enter(*next);
    observer.on_instant(at_);
    at_.event = Event::none;
  }
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::enter(const Transition& next) {
  at_.contact = next.contact;
  at_.event = next.event;
  at_.direction = next.direction;
  if (next.event == Event::motor_off) {
    rotor_.motor_on = at_.motor_on = false;
    if (auto* chart = std::get_if<FlightChart<S>>(&chart_)) chart->switch_motor_off(start_.x);
  }
}

/// The chart of that kind; a new one where the last phase ended, if that had another kind.
template <class S, class Stepper>
template <class Chart>
Chart& EventMethod<S, Stepper>::chart() {
  if (!std::holds_alternative<Chart>(chart_)) {
    chart_.template emplace<Chart>(rotor_, at_.state);
    start_.x = std::get<Chart>(chart_).unknowns(at_.state);
    if constexpr (std::is_same_v<Chart, ContactChart<S>>) start_.x[4] *= 1 + slip_disturbance_;
  }
  return std::get<Chart>(chart_);
}

/// Runs through the present phase, to its end or that of the extent. Returns what follows the
/// phase, if it has ended.
template <class S, class Stepper>
std::optional<Transition> EventMethod<S, Stepper>::follow_phase(const S& until_s,
                                                                BasicObserver<S>& observer,
                                                                Extent extent) {
  const auto in = [&](const auto& phase, auto& chart, S& step) {
    return follow(phase, chart, step, until_s, observer, extent);
  };
  if (at_.contact != ContactState::free && contact_step_ == 0)
    contact_step_ = first_steps_ * S(0.1) / rotor_.contact_frequency(at_.state[5]);
  switch (at_.contact) {
    case ContactState::free: {
      auto& chart = this->chart<FlightChart<S>>();
      return in(FreeFlight<S>(rotor_, chart), chart, flight_step_);
    }
    case ContactState::indented: {
      auto& chart = this->chart<ContactChart<S>>();
      return in(IndentedFlight<S>(rotor_, chart), chart, contact_step_);
    }
    case ContactState::sliding: {
      auto& chart = this->chart<ContactChart<S>>();
      if (S(at_.direction) * chart.rim_point(start_.x).slip_velocity < 0)
        start_.x = chart.without_slip(start_.x);  // negative only by rounding
      return in(Sliding<S>(rotor_, chart, at_.direction), chart, contact_step_);
    }
    case ContactState::rolling: {
      auto& chart = this->chart<ContactChart<S>>();
      start_.x = chart.without_slip(start_.x);
      const Rolling<S> rolling(rotor_, chart);
      if (phase_is_new_ && rolling.has_no_grip(start_.x)) return rolling.break_away(start_.x);
      return in(rolling, chart, contact_step_);
    }
  }
  return std::nullopt;
}

template <class S, class Stepper>
template <class Phase, class Chart>
std::optional<Transition> EventMethod<S, Stepper>::follow(const Phase& phase, Chart& chart, S& step,
                                                          const S& until_s,
                                                          BasicObserver<S>& observer,
                                                          Extent extent) {
  const PhaseSystem<S, Phase> system(phase, counters_);
  if (phase_is_new_) {
    chart.recentre(start_.x);
    system(start_.x, start_.rates, S(0));
    phase_is_new_ = false;
  }
  for (;;) {
    const bool last = !(at_.time_s + step < until_s);
    const Counters before = counters_;
    if (last && extent != Extent::everything) {
      at_.state = chart.state(start_.x);
      return std::nullopt;
    }
    // The step is the difference of rounded times, so that times add up exactly.
    Point end{.time = (last ? until_s : S(at_.time_s + step)) - at_.time_s};
    const double error = control_.step(system, start_, end);
    const S next_step = end.time * static_cast<S>(control_.step_factor(error));
    if (!(error <= 1)) {
      step = next_step;
      require_progress(step);
      continue;
    }
    system(end.x, end.rates, S(0));
    Step<S, Stepper, PhaseSystem<S, Phase>> taken(control_, system, start_, end);
    const std::optional<std::size_t> event = first_event(taken);
    Point stop = taken.stop();
    const S end_s = last && !event ? until_s : S(at_.time_s + stop.time);
    std::optional<Transition> next;
    if (event) next = phase.next(*event, stop.x);
    if (next && next->contact != ContactState::free && extent == Extent::clear_whole_steps) {
      counters_ = before;  // advance() takes this step
      at_.state = chart.state(start_.x);
      return std::nullopt;
    }
    count_step();
    if (!last) step = next_step;
    show_step(taken, at_, end_s, observer);
    at_.time_s = end_s;
    start_ = {.time = S(0), .x = stop.x, .rates = stop.rates};
    stopped_ = !observer.goes_on({at_.time_s, chart.speed(start_.x), chart.whirl_angle(start_.x)});
    if (event || last || stopped_) {
      at_.state = chart.state(start_.x);
      counters_.located_events += event.has_value();
      phase_is_new_ = true;
      return next;
    }
    if (chart.recentre(start_.x)) system(start_.x, start_.rates, S(0));
  }
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::count_step() {
  constexpr long most = 20'000'000;  // exceeded only if something is wrong
  if (++counters_.steps > most)
    fail(fmt::format("{} steps have been taken, which is more than any run should need", most));
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::require_progress(const S& step) const {
  if (!(at_.time_s + step > at_.time_s))
    fail(
        fmt::format("no step is short enough: the motion is not finite, or the tolerance {} is "
                    "below rounding",
                    static_cast<double>(control_.tolerance())));
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::limit_switches() {
  const S period = rotor_.radians_per_turn() / rotor_.contact_frequency(at_.state[5]);
  if (switch_limit_.exceeded(at_.time_s, period))
    fail(fmt::format("more than {} changes between free, sliding and rolling within {} s",
                     SwitchLimit<S>::most, static_cast<double>(period)));
}

template <class S, class Stepper>
void EventMethod<S, Stepper>::fail(const std::string& reason) const {
  throw std::runtime_error(fmt::format("the event run ends at t = {:.9f} s: {}",
                                       static_cast<double>(at_.time_s), reason));
}

}  // namespace rotor
