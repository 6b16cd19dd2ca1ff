/// One computation of a run in one precision: its numbers by name, and what decides its course.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/digits/digits.hpp"
#include "model/methods/event_method.hpp"
#include "model/methods/whole_run.hpp"

namespace rotor {

template <class S>
struct Computation {
  BasicSummary<S> summary;
  std::vector<BasicInstant<S>> events;
  BasicInstant<S> end;
  Counters counters;
  /// What stays positive, or zero by its nature, as long as the course is the same: times between
  /// events, from the last one to the end, and from there to the next one; how far the reach of a
  /// rotor that is free at the end is from the clearance.
  std::vector<S> margins;
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
    if (at.event != Event::none) course.events.push_back(at);
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
};

/// When the next event comes, or the next of one kind; `until_s` if none does before.
template <class S>
S time_of_next(EventMethod<S> run, std::optional<Event> kind, const S& until_s,
               const ShouldContinue& should_continue) {
  struct Watch : BasicObserver<S> {
    Watch(std::optional<Event> of, const ShouldContinue& asked)
        : kind(of), should_continue_(asked) {}
    void on_instant(const BasicInstant<S>& at) override {
      if (!time_s && (kind ? at.event == kind : at.event != Event::none)) time_s = at.time_s;
    }
    bool should_continue(const BasicProgress<S>& now) override {
      return !time_s && should_continue_(static_cast<double>(now.time_s));
    }
    std::optional<Event> kind;
    std::optional<S> time_s;
    const ShouldContinue& should_continue_;
  } watch(kind, should_continue);
  run.advance(until_s, watch);
  return watch.time_s.value_or(run.instant().time_s);
}

template <class S>
Computation<S> compute(const Scenario& scenario, const S& tolerance,
                       const ShouldContinue& should_continue) {
  using std::abs;
  CourseObserver<S> observer(scenario, should_continue);
  RotorSystem<S> rotor(scenario.parameters, scenario.equations);
  const BasicInstant<S> start = start_of<S>(scenario);
  MassLoss<S> loss(scenario.parameters);
  if (const auto speed_Hz = scenario.stated_mass_loss_speed_Hz()) {
    RotorSystem<S> to_speed = rotor;
    to_speed.motor_off = rotor.radians_per_turn() * as_typed<S>(*speed_Hz);
    // Precision moves it by far less.
    const S latest_s = S(1.01) * S(scenario.parameters.mass_loss_time);
    loss.time_s = time_of_next(EventMethod<S>(to_speed, tolerance, start), Event::motor_off,
                               latest_s, should_continue);
  }
  EventMethod<S> method(rotor, tolerance, start);
  observer.on_instant(method.instant());
  run_to_end(method, scenario, loss, observer);
  Computation<S> result = observer.course;
  result.summary = observer.summary();
  const BasicInstant<S>& end = result.end = method.instant();
  result.end.event = Event::none;
  result.counters = method.counters();
  result.stopped = method.stopped();
  if (result.stopped) return result;

  S last_s = start.time_s;
  const auto add_time = [&](const S& time_s) {
    result.margins.push_back(time_s - last_s);
    last_s = time_s;
  };
  for (const BasicInstant<S>& event : result.events) add_time(event.time_s);
  add_time(end.time_s);
  const S soon = S(1) / 1000 / rotor.contact_frequency(end.state[5]);  // a short part of a contact
  add_time(time_of_next(method, std::nullopt, S(end.time_s + soon), should_continue));
  if (end.contact == ContactState::free && end.body.eccentricity > 0)
    result.margins.push_back(
        abs(rotor.ring.clearance - reach(end.body, rotor.acting.supports, end.motion())));
  return result;
}

/// A real number of a run, and what its digits are relative to.
template <class S>
struct NamedValue {
  std::string_view name;
  std::optional<S> value;
  S size{0};              ///< least reference of its digits
  bool is_exact = false;  ///< stated, not computed
};

/// A value that is less than the clearance, or a radian, by this factor is negligible: digits are
/// relative to that limit instead.
constexpr long negligible = 1'000'000;

/// Those of a summary.
template <class S>
std::vector<NamedValue<S>> values_of(const BasicSummary<S>& summary, const Parameters& p) {
  const S length = Ring<S>(p).clearance / negligible,
          force = as_typed<S>(p.support_stiffness) * length;
  std::vector<NamedValue<S>> all;
  for (const SummaryField<S>& field : summary_fields<S>) {
    const S size = field.scale == ErrorScale::length  ? length
                   : field.scale == ErrorScale::force ? force
                                                      : S(0);
    const auto add = [&](const std::optional<S>& value) {
      all.push_back({field.key, value, size, field.scale == ErrorScale::exact});
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
  const State<S>& q = at.state;
  const Motion<S> m = at.motion();
  const S least = Ring<S>(scenario.parameters).clearance / negligible, angle = S(1) / negligible;
  const S length = max(least, S(m.displacement.norm()));
  const S velocity = max(S(least * abs(m.speed)), S(m.velocity.norm()));
  const bool is_stated = at.event == Event::none ||  // the end
                         (at.event == Event::mass_loss && !scenario.stated_mass_loss_speed_Hz());
  return {{"time_s", at.time_s, S(0), is_stated},
          {"q1_m", q[0], length},
          {"q2_m", q[1], length},
          {"q3_rad", q[2], angle},
          {"q1_rate_m_per_s", q[3], velocity},
          {"q2_rate_m_per_s", q[4], velocity},
          {"q3_rate_rad_per_s", q[5]}};
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
