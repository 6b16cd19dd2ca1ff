/// Integration with error control, phase by phase, each ending at a located event: no step
/// straddles a jump, and every step has the full order of its Odeint stepper. Scalar (for higher
/// precision) and stepper are template parameters.
#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "model/integration/verner.hpp"
#include "model/methods/run_check.hpp"
#include "model/methods/show_step.hpp"
#include "model/methods/step_limit.hpp"
#include "model/phases/flight.hpp"

namespace rotor {

/// A phase as a system of the integration library. Counts its evaluations.
template <class S, PhaseOf<S> Phase>
class PhaseSystem {
 public:
  using Unknowns = typename Phase::Unknowns;
  static constexpr std::size_t event_count = Phase::event_count;

  PhaseSystem(const Phase& phase, Counters& counters) : phase_(phase), counters_(counters) {}

  const Phase& phase() const { return phase_; }

  void operator()(const Unknowns& x, Unknowns& rates, const S& time) const {
    ++counters_.right_hand_sides;
    if constexpr (Phase::contact_in_rates) ++counters_.contact_evaluations;
    phase_(x, rates, time);
  }
  S event(std::size_t i, const Unknowns& x) const {
    if (phase_.guard_takes_loads(i)) ++counters_.contact_evaluations;
    return with_exit<event_count>(i, [&](auto exit) { return phase_.guard(exit, x); });
  }
  using Point = rotor::Point<S, Unknowns>;
  auto bounds(const Point& from, const Point& to) const { return phase_.bounds(from, to); }
  Unknowns scale(const Unknowns& x) const { return phase_.scale(x); }

 private:
  const Phase& phase_;
  Counters& counters_;
};

/// A run up to its present instant. A copy continues independently: runs that differ only later
/// share their beginning. Throws std::runtime_error, with time and reason, if it cannot continue.
template <class S, class Stepper = Verner87<std::array<S, 6>, S>>
class EventMethod {
 public:
  /// Starts at an instant. `tolerance`: error allowed in a step, relative to the phases' scale.
  EventMethod(const Scenario& scenario, const S& tolerance, const BasicInstant<S>& from)
      : EventMethod(RotorSystem<S>(scenario.parameters, scenario.equations), tolerance, from) {}

  /// The same for a rotor whose numbers need not be doubles.
  EventMethod(const RotorSystem<S>& rotor, const S& tolerance, const BasicInstant<S>& from)
      : control_(tolerance),
        check_(RunCheck<S>::truncation_of(tolerance)),
        limit_(tolerance),
        rotor_(rotor) {
    restart(from);
    flight_step_ = S(0.01) / rotor_.flight_frequency(at_.state[5]);
  }

  /// Runs to `until_s`, in contact or not.
  void advance(const S& until_s, BasicObserver<S>& observer) {
    advance(until_s, observer, Extent::everything);
  }

  /// Takes all whole steps that end before `until_s`, so that the steps do not depend on when other
  /// runs branch off, and stops before the step that touches the ring.
  void run_up(const S& until_s, BasicObserver<S>& observer) {
    if (at_.contact == ContactState::free) advance(until_s, observer, Extent::clear_whole_steps);
  }

  /// Continues from another instant, such as one after a jump.
  void restart(const BasicInstant<S>& from) {
    at_ = from;
    at_.event = Event::none;
    rotor_.body = at_.body;
    rotor_.motor_on = at_.motor_on;
    chart_ = {};
    phase_is_new_ = true;
    if (at_.contact != ContactState::free) enter(resume_contact(rotor_, at_.state, at_.contact));
    check_.begin(rotor_, at_);
  }

  /// The same motion with the ring of another scenario, and the speed at which that switches its
  /// motor off; its run-up part is the same otherwise.
  EventMethod branch(const Scenario& scenario) const {
    EventMethod other = *this;
    other.rotor_ = rotor_.with_ring_of(scenario.parameters, scenario.equations);
    return other;
  }

  const BasicInstant<S>& instant() const { return at_; }
  const Counters& counters() const { return counters_; }
  bool stopped() const { return stopped_; }  ///< by an observer

 private:
  using Unknowns = std::array<S, 6>;
  using Point = rotor::Point<S, Unknowns>;
  enum class Extent { everything, clear_whole_steps };

  void advance(const S& until_s, BasicObserver<S>& observer, Extent extent) {
    while (at_.time_s < until_s && !stopped_) {
      const std::optional<Transition> next = follow_phase(until_s, observer, extent);
      if (const auto fault =
              check_.fault(rotor_, at_, next ? touches(next->contact) : at_.touches()))
        fail(*fault);
      if (next) {
        observer.on_instant(at_);
        enter(*next);
      }
      check_.begin(rotor_, at_);
      if (!next) return;
      observer.on_instant(at_);
      at_.event = Event::none;
    }
  }

  void enter(const Transition& next) {
    at_.contact = next.contact;
    at_.event = next.event;
    at_.slip_sign = next.slip_sign;
    if (next.event == Event::motor_off) {
      rotor_.motor_on = at_.motor_on = false;
      if (auto* chart = std::get_if<FlightChart<S>>(&chart_)) chart->switch_motor_off(start_.x);
    }
  }

  /// The chart of that kind; a new one where the last phase ended, if that had another kind.
  template <class Chart>
  Chart& chart() {
    if (!std::holds_alternative<Chart>(chart_)) {
      chart_.template emplace<Chart>(rotor_, at_.state);
      start_.x = std::get<Chart>(chart_).unknowns(at_.state);
    }
    return std::get<Chart>(chart_);
  }

  std::optional<Transition> follow_phase(const S& until_s, BasicObserver<S>& observer,
                                         Extent extent);

  template <class Phase, MovingChartOf<S> Chart>
  std::optional<Transition> follow(const Phase& phase, Chart& chart, S& step, const S& until_s,
                                   BasicObserver<S>& observer, Extent extent) {
    const PhaseSystem<S, Phase> system(phase, counters_);
    if (phase_is_new_) {
      chart.recentre(start_.x);
      system(start_.x, start_.rates, S(0));
      phase_is_new_ = false;
    }
    for (;;) {
      limit_step(phase.smooth_time(start_.x), step);
      const bool last = !(at_.time_s + step < until_s);
      const Counters before = counters_;
      if (last && extent != Extent::everything) {
        at_.state = chart.state(start_.x);
        return std::nullopt;
      }
      // The step is the difference of rounded times, so that times add up exactly.
      const auto rounded = [&](const S& length) { return S(at_.time_s + length) - at_.time_s; };
      Point end{.time = last ? S(until_s - at_.time_s) : rounded(step)};
      const auto position = [&](const S& now_s, const Unknowns& x) {
        typename StepLimit<S>::Position at{now_s, until_s, chart.speed(x), std::nullopt};
        if constexpr (ContactChartOf<Chart, S>) at.indentation = chart.rim_point(x).indentation;
        return at;
      };
      const auto fail_at_rounding = [&](bool is_finite) {
        fail(limit_.at_rounding(rotor_, position(at_.time_s, start_.x), is_finite));
      };
      if (!(end.time > 0)) fail_at_rounding(true);
      const double error = control_.step(system, start_, end);
      const S next_step = end.time * static_cast<S>(control_.step_factor(error));
      if (!(error <= 1)) {
        step = next_step;
        if (rounded(step) > 0 && rounded(step) < end.time) continue;
        fail_at_rounding(std::isfinite(error));
      }
      system(end.x, end.rates, S(0));
      Step<S, Stepper, PhaseSystem<S, Phase>> taken(control_, system, start_, end);
      const std::optional<std::size_t> event = first_event(taken);
      Point stop = taken.stop();
      const S end_s = last && !event ? until_s : S(at_.time_s + stop.time);
      std::optional<Transition> next;
      if (event)
        next = with_exit<Phase::event_count>(*event, [&](auto n) { return phase.next(n, stop.x); });
      if (next && next->contact != ContactState::free && extent == Extent::clear_whole_steps) {
        counters_ = before;  // advance() takes this step
        at_.state = chart.state(start_.x);
        return std::nullopt;
      }
      ++counters_.steps;
      const auto now = position(end_s, stop.x);
      if (const auto fault = limit_.fault(rotor_, counters_, now, observer)) fail(*fault);
      check_.add_step(stop.time, chart.speed(start_.x), now.speed, now.indentation.value_or(S(0)));
      if (!last) step = next_step;
      show_step(taken, at_, end_s, observer);
      at_.time_s = end_s;
      start_ = {.time = S(0), .x = stop.x, .rates = stop.rates};
      stopped_ = !observer.should_continue(
          {at_.time_s, chart.speed(start_.x), chart.whirl_angle(start_.x)});
      if (event || last || stopped_) {
        at_.state = chart.state(start_.x);
        counters_.located_events += event.has_value();
        phase_is_new_ = true;
        return next;
      }
      if (chart.recentre(start_.x)) system(start_.x, start_.rates, S(0));
    }
  }

  /// Verner's error estimate hardly sees what happens at the start of a step: of t^1.5 there, it
  /// shows a 230th of the error. In a step no longer than the smooth time it shows at least a
  /// third. In one as short as the least the error is negligible, for any exponent from 1 on.
  void limit_step(const S& smooth_time, S& step) const {
    using std::max, std::min, std::sqrt;
    if (!(smooth_time < step)) return;
    const S least = sqrt(control_.tolerance()) / rotor_.contact_frequency(at_.state[5]);
    step = min(step, max(least, smooth_time));
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw std::runtime_error(fmt::format("the event run ends at t = {:.9f} s: {}",
                                         static_cast<double>(at_.time_s), reason));
  }

  ErrorControl<S, Stepper> control_;
  RunCheck<S> check_;
  StepLimit<S> limit_;
  RotorSystem<S> rotor_;
  BasicInstant<S> at_;
  std::variant<std::monostate, FlightChart<S>, ContactChart<S>> chart_;  ///< none after a restart
  Point start_;                         ///< of the next step, in that chart
  bool phase_is_new_ = true;            ///< whether the rates are not yet known there
  S flight_step_{0}, contact_step_{0};  ///< to try next; 0 until the first contact
  Counters counters_;
  bool stopped_ = false;
};

/// Runs through the present phase, to its end or that of the extent. Returns what follows the
/// phase, if it has ended. Defined outside the class, so that `extern template` holds for the
/// phases.
template <class S, class Stepper>
std::optional<Transition> EventMethod<S, Stepper>::follow_phase(const S& until_s,
                                                                BasicObserver<S>& observer,
                                                                Extent extent) {
  const auto in = [&](const auto& phase, auto& chart, S& step) {
    return follow(phase, chart, step, until_s, observer, extent);
  };
  // In other precisions the time to compile matters more.
  constexpr bool is_fast_if_linear = std::is_same_v<S, double>;
  if (at_.contact != ContactState::free && contact_step_ == 0)
    contact_step_ = S(0.1) / rotor_.contact_frequency(at_.state[5]);
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
      if (S(at_.slip_sign) * chart.rim_point(start_.x).slip_velocity < 0)
        start_.x = chart.without_slip(start_.x);  // negative only by rounding
      if constexpr (is_fast_if_linear)
        if (rotor_.ring.law.is_linear())
          return in(Sliding<S, ContactChart<S>, LinearContact<S>>(rotor_, chart, at_.slip_sign),
                    chart, contact_step_);
      return in(Sliding<S>(rotor_, chart, at_.slip_sign), chart, contact_step_);
    }
    case ContactState::rolling: {
      auto& chart = this->chart<ContactChart<S>>();
      start_.x = chart.without_slip(start_.x);
      const Rolling<S> rolling(rotor_, chart);
      if (phase_is_new_ && rolling.has_no_grip(start_.x))
        return rolling.next(typename Rolling<S>::BreakAway(), start_.x);
      if constexpr (is_fast_if_linear)
        if (rotor_.ring.law.is_linear())
          return in(Rolling<S, ContactChart<S>, LinearContact<S>>(rotor_, chart), chart,
                    contact_step_);
      return in(rolling, chart, contact_step_);
    }
  }
  return std::nullopt;
}

// Sources compiled with -O1 must not define their functions: a linker may take those.
extern template class SynchronousMotion<double>;
extern template class FlightChart<double>;
extern template class EventMethod<double>;

}  // namespace rotor
