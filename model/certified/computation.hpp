/// One computation of a run in one precision, with an optional disturbance; its values, the
/// references of their digits, and what decides the course.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "model/certified/comparison.hpp"
#include "model/methods/event_method.hpp"
#include "model/methods/whole_run.hpp"
#include "model/results/summary.hpp"

namespace rotor {

/// Changes every number of the computation by a share, up or down as a bit of `signs` says, so that
/// neither a law of similarity nor rounding that all runs share hides the change.
template <class S>
struct Disturbance {
  S share{0};
  unsigned signs = 0;

  void disturb(RotorSystem<S>& rotor, BasicInstant<S>& start, MassLoss<S>& loss) const {
    unsigned bits = signs;
    const auto disturb = [&](S* number) {
      *number *= 1 + (bits % 2 == 0 ? share : S(-share));
      bits /= 2;
    };
    S stator_radius = rotor.ring.clearance + rotor.ring.rotor_radius;
    const S undisturbed = stator_radius;
    for (S* of : rotor.supports.springs.numbers()) disturb(of);
    for (S* of : {&rotor.supports.damping, &rotor.supports.gravity, &rotor.supports.torque,
                  &stator_radius, &rotor.ring.rotor_radius})
      disturb(of);
    for (S* of : rotor.ring.law.numbers()) disturb(of);
    for (S* of :
         {&rotor.ring.friction, &rotor.motor_off, &start.state[0], &start.state[1], &start.state[5],
          &start.body.mass, &start.body.inertia, &start.body.eccentricity, &loss.lost_mass,
          &loss.piece_distance, &loss.after.mass, &loss.after.inertia, &loss.after.eccentricity})
      disturb(of);
    // The clearance is a difference of radii; their rounding is less than this.
    rotor.ring.clearance += (stator_radius - undisturbed) / 4;
  }
  S at_touch_downs() const { return signs % 2 == 0 ? share : S(-share); }
};

/// How a run is computed.
template <class S>
struct Settings {
  S tolerance;
  S first_steps{1};  ///< factor on their usual length
  Disturbance<S> disturbance{};
};

template <class S>
struct Computation {
  BasicSummary<S> summary;
  std::vector<BasicInstant<S>> events;
  BasicInstant<S> before_loss;  ///< if mass is lost
  BasicInstant<S> end;
  Counters counters;
  /// By how much flights near the ring missed it, m; the key is the number of events before.
  std::map<std::size_t, S> misses;
  bool stopped = false;  ///< by should_continue
};

/// Gathers what a Computation needs from a run.
template <class S>
class CourseObserver : public BasicSummaryObserver<S> {
 public:
  CourseObserver(const Scenario& scenario, const ShouldContinue& should_continue)
      : BasicSummaryObserver<S>(scenario),
        clearance_(Ring<S>(scenario.parameters).clearance),
        should_continue_(should_continue) {}

  void on_instant(const BasicInstant<S>& at) override {
    BasicSummaryObserver<S>::on_instant(at);
    is_free_ = at.contact == ContactState::free;
    if (at.event == Event::mass_loss) course.before_loss = previous_;
    if (at.event != Event::none) course.events.push_back(at);
    previous_ = at;
  }
  bool should_continue(const BasicProgress<S>& now) override {
    return BasicSummaryObserver<S>::should_continue(now) &&
           should_continue_(static_cast<double>(now.time_s));
  }
  S threshold(Extreme of, const S& from_s, const S& until_s) const override {
    const S usual = BasicSummaryObserver<S>::threshold(of, from_s, until_s);
    const S near = S(9) / 10 * clearance_;
    return of == Extreme::displacement && is_free_ && near < usual ? near : usual;
  }
  void on_maximum(const BasicMaximum<S>& maximum) override {
    BasicSummaryObserver<S>::on_maximum(maximum);
    if (maximum.of != Extreme::displacement || !is_free_) return;
    const S miss = clearance_ - maximum.at.motion().displacement.norm();
    const auto [nearest, is_new] = course.misses.try_emplace(course.events.size(), miss);
    if (miss < nearest->second) nearest->second = miss;
  }

  Computation<S> course;

 private:
  S clearance_;
  const ShouldContinue& should_continue_;
  bool is_free_ = true;
  BasicInstant<S> previous_;
};

/// When a run switches its motor off, which must be before `until_s`.
template <class S, class Stepper>
S motor_off_time(EventMethod<S, Stepper> run, const S& until_s,
                 const ShouldContinue& should_continue) {
  struct Watch : BasicObserver<S> {
    explicit Watch(const ShouldContinue& asked) : should_continue_(asked) {}
    void on_instant(const BasicInstant<S>& at) override {
      if (at.event == Event::motor_off) time_s = at.time_s;
    }
    bool should_continue(const BasicProgress<S>& now) override {
      return !time_s && should_continue_(static_cast<double>(now.time_s));
    }
    std::optional<S> time_s;
    const ShouldContinue& should_continue_;
  } watch(should_continue);
  run.advance(until_s, watch);
  return watch.time_s.value_or(run.instant().time_s);
}

template <class S, class Stepper = Verner87<std::array<S, 6>, S>>
Computation<S> compute(const Scenario& scenario, const Settings<S>& settings,
                       const ShouldContinue& should_continue) {
  CourseObserver<S> observer(scenario, should_continue);
  RotorSystem<S> rotor(scenario.parameters, scenario.equations);
  BasicInstant<S> start = start_of<S>(scenario);
  MassLoss<S> loss(scenario.parameters);
  settings.disturbance.disturb(rotor, start, loss);
  const auto at_start = [&](const RotorSystem<S>& of) {
    EventMethod<S, Stepper> method(of, settings.tolerance, start);
    method.shorten_first_steps(settings.first_steps);
    method.disturb_touch_downs(settings.disturbance.at_touch_downs());
    return method;
  };
  if (scenario.mass_loss_speed_Hz > 0) {
    RotorSystem<S> to_speed = rotor;
    to_speed.motor_off = rotor.radians_per_turn() * as_typed<S>(scenario.mass_loss_speed_Hz);
    // Precision and disturbance move it by far less.
    const S latest_s = S(1.01) * S(scenario.parameters.mass_loss_time);
    loss.time_s = motor_off_time(at_start(to_speed), latest_s, should_continue);
  }
  EventMethod<S, Stepper> method = at_start(rotor);
  observer.on_instant(start);
  finish(method, scenario, loss, observer);
  Computation<S> result = observer.course;
  result.summary = observer.summary();
  result.end = method.instant();
  result.end.event = Event::none;
  result.counters = method.counters();
  result.stopped = method.stopped();
  return result;
}

template <class S>
struct NamedValue {
  std::string_view name;
  std::optional<S> value;
  S size{0};              ///< least reference of its digits
  bool is_exact = false;  ///< stated, not computed
  bool follows = false;   ///< from another value or the inputs: it has no independent error
  S error_base{0};        ///< the larger, rounded quantity of which it is a difference or component
};

/// A value that is less than the clearance, or a radian, by this factor is negligible: digits are
/// relative to that limit instead.
constexpr long negligible = 1'000'000;

/// The real numbers of a summary.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicSummary<S>& summary, const Parameters& p) {
  const S length = Ring<S>(p).clearance / negligible, force = SupportSprings<S>(p).force(length);
  std::vector<NamedValue<S>> all;
  for (const SummaryField<S>& field : summary_fields<S>) {
    const auto add = [&](const std::optional<S>& value) {
      all.push_back({.name = field.key,
                     .value = value,
                     .size = field.scale == ErrorScale::length  ? length
                             : field.scale == ErrorScale::force ? force
                                                                : S(0),
                     .is_exact = field.scale == ErrorScale::exact,
                     .follows = field.scale == ErrorScale::of_another,
                     .error_base = field.error_base ? field.error_base(summary) : S(0)});
    };
    if (const auto* always = std::get_if<S BasicSummary<S>::*>(&field.value))
      add(summary.**always);
    else if (const auto* perhaps = std::get_if<std::optional<S> BasicSummary<S>::*>(&field.value))
      add(summary.**perhaps);
  }
  return all;
}

/// Time and state. Digits of a vector's components are relative to its length; those of the rates
/// in the rotating axes, which nearly cancel in synchronous motion, to that of the velocity of O.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicInstant<S>& at, const Scenario& scenario) {
  using std::abs, std::max;
  const S clearance = Ring<S>(scenario.parameters).clearance;
  const State<S>& q = at.state;
  const Motion<S> m = at.motion();
  const S least = clearance / negligible, angle = S(1) / negligible;
  const S length = max(least, S(m.displacement.norm()));
  const S velocity = max(S(least * abs(m.speed)), S(m.velocity.norm()));
  const bool is_end = at.event == Event::none;
  const bool is_stated =
      is_end || (at.event == Event::mass_loss && scenario.mass_loss_speed_Hz == 0);
  return {{"time_s", at.time_s, S(0), is_stated},
          {"q1_m", q[0], length},
          {"q2_m", q[1], length},
          {"q3_rad", q[2], angle},
          {"q1_rate_m_per_s", q[3], velocity},
          {"q2_rate_m_per_s", q[4], velocity},
          {"q3_rate_rad_per_s", q[5]}};
}

/// How far the guards of a phase are from zero at a stated time, at which the phase ends: an event
/// just before that time might come just after it, and the reverse.
template <class S, class Phase>
void add_guards(std::vector<NamedValue<S>>& all, const Phase& phase,
                const typename Phase::Unknowns& x) {
  using std::abs;
  for (std::size_t n = 0; n < Phase::event_count; ++n)
    with_end<Phase::event_count>(n, [&](auto end) {
      all.push_back({"reserve", abs(phase.guard(end, x))});
    });
}

/// The same for the phase that the rotor is in.
template <class S>
void add_reserves(std::vector<NamedValue<S>>& all, const BasicInstant<S>& at,
                  const Scenario& scenario) {
  RotorSystem<S> rotor(scenario.parameters, scenario.equations);
  rotor.body = at.body;
  rotor.motor_on = at.motor_on;
  if (at.contact == ContactState::free) {
    const FlightChart<S> chart(rotor, at.state);
    return add_guards(all, FreeFlight<S>(rotor, chart), chart.unknowns(at.state));
  }
  const ContactChart<S> chart(rotor, at.state);
  const auto x = chart.unknowns(at.state);
  switch (at.contact) {
    case ContactState::indented:
      return add_guards(all, IndentedFlight<S>(rotor, chart), x);
    case ContactState::rolling:
      return add_guards(all, Rolling<S>(rotor, chart), x);
    default:  // in either direction the slip is as far from zero
      return add_guards(all, Sliding<S>(rotor, chart, 1), x);
  }
}

/// Quantities that stay positive as long as the course is the same: the normal velocities of
/// touch-downs; by how much flights miss the ring; how far the guards are from zero just before the
/// mass loss, just after it and at the end; and, if the rotor is free at the end, how far its reach
/// is from the clearance.
template <class S>
std::vector<NamedValue<S>> margins_of(const Computation<S>& run, const Scenario& scenario) {
  using std::abs;
  const Ring<S> ring(scenario.parameters);
  std::vector<NamedValue<S>> all;
  for (std::size_t i = 0; i <= run.events.size(); ++i) {
    const auto miss = run.misses.find(i);
    all.push_back({"miss", miss == run.misses.end() ? std::nullopt : std::optional(miss->second)});
    if (i < run.events.size() && run.events[i].event == Event::touch_down)
      all.push_back({"touch", ring.rim_point(run.events[i].motion()).normal_velocity});
    if (i < run.events.size() && run.events[i].event == Event::mass_loss)
      for (const BasicInstant<S>* at : {&run.before_loss, &run.events[i]})
        add_reserves(all, *at, scenario);
  }
  const BasicInstant<S>& end = run.end;
  add_reserves(all, end, scenario);
  if (end.contact == ContactState::free && end.body.eccentricity > 0) {
    const Supports<S> supports(scenario.parameters, scenario.equations);
    all.push_back({"reach", abs(ring.clearance - reach(end.body, supports, end.motion()))});
  }
  return all;
}

template <class S>
Instant in_double(const BasicInstant<S>& at) {
  const auto d = [](const S& x) { return static_cast<double>(x); };
  Instant result{.time_s = d(at.time_s),
                 .body = {d(at.body.mass), d(at.body.inertia), d(at.body.eccentricity)},
                 .motor_on = at.motor_on,
                 .mass_lost = at.mass_lost,
                 .contact = at.contact,
                 .direction = at.direction,
                 .event = at.event};
  std::transform(at.state.begin(), at.state.end(), result.state.begin(), d);
  return result;
}

template <class S>
Summary in_double(const BasicSummary<S>& summary) {
  const auto convert = [](const auto& value) {
    using Value = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, S>)
      return static_cast<double>(value);
    else if constexpr (std::is_same_v<Value, std::optional<S>>)
      return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
    else
      return value;
  };
  Summary result;
  for (std::size_t i = 0; i < summary_fields<S>.size(); ++i)
    std::visit(
        [&](auto from, auto to) {
          const auto value = convert(summary.*from);
          if constexpr (std::is_same_v<decltype(value), const std::decay_t<decltype(result.*to)>>)
            result.*to = value;
        },
        summary_fields<S>[i].value, summary_fields<double>[i].value);
  return result;
}

}  // namespace rotor
