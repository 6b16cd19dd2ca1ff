/// One computation of a run in one precision, with an optional disturbance.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/certified/comparison.hpp"
#include "model/methods/event_method.ipp"
#include "model/methods/stages.hpp"
#include "model/results/summary.ipp"
#include "model/scenario/start.hpp"

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
    for (S* of : {&rotor.supports.damping, &rotor.supports.gravity,  &rotor.supports.torque,
                  &stator_radius,          &rotor.ring.rotor_radius, &rotor.ring.stiffness,
                  &rotor.ring.damping,     &rotor.ring.friction,     &rotor.motor_off,
                  &start.state[0],         &start.state[1],          &start.state[5],
                  &start.body.mass,        &start.body.inertia,      &start.body.eccentricity,
                  &loss.lost_mass,         &loss.piece_distance,     &loss.after.mass,
                  &loss.after.inertia,     &loss.after.eccentricity})
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
  bool stopped = false;  ///< by goes_on
};

/// Gathers what a Computation needs from a run.
template <class S>
class CourseObserver : public BasicSummaryObserver<S> {
 public:
  CourseObserver(const Scenario& scenario, const GoesOn& goes_on)
      : BasicSummaryObserver<S>(scenario),
        clearance_(Ring<S>(scenario.parameters).clearance),
        goes_on_(goes_on) {}

  void on_instant(const BasicInstant<S>& at) override {
    BasicSummaryObserver<S>::on_instant(at);
    is_free_ = at.contact == ContactState::free;
    if (at.event == Event::mass_loss) course.before_loss = previous_;
    if (at.event != Event::none) course.events.push_back(at);
    previous_ = at;
  }
  bool goes_on(const BasicProgress<S>& now) override {
    return BasicSummaryObserver<S>::goes_on(now) && goes_on_(static_cast<double>(now.time_s));
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
  const GoesOn& goes_on_;
  bool is_free_ = true;
  BasicInstant<S> previous_;
};

/// When the stated speed of the mass loss is reached, by the secant method from the time known in
/// double precision.
template <class S, class Stepper>
S time_at_speed(EventMethod<S, Stepper> way, const Scenario& scenario, const GoesOn& goes_on) {
  using std::abs;
  struct Monitor : BasicObserver<S> {
    explicit Monitor(const GoesOn& asked) : goes_on_(asked) {}
    bool goes_on(const BasicProgress<S>& now) override {
      return goes_on_(static_cast<double>(now.time_s));
    }
    const GoesOn& goes_on_;
  } monitor(goes_on);
  const S turns = stated<S>(scenario.mass_loss_speed_Hz);
  const S speed = RotorSystem<S>::radians_per_turn() * turns;
  const Parameters& p = scenario.parameters;
  S before = stated<S>(p.mass_loss_time);
  way.run_up(before - 1 / turns, monitor);
  const auto excess = [&](const S& time_s) {
    EventMethod<S, Stepper> there = way;
    there.advance(time_s, monitor);
    return S(there.instant().state[5] - speed);
  };
  S excess_before = excess(before), time = before - excess_before * S(p.inertia) / S(p.torque);
  const S rounding = 64 * std::numeric_limits<S>::epsilon() * speed;
  for (int more = 8; more > 0 && abs(excess_before) > rounding && time != before; --more) {
    const S now = excess(time), change = now - excess_before;
    const S next = change == 0 ? time : S(time - now * (time - before) / change);
    before = time;
    excess_before = now;
    time = next;
  }
  return time;
}

template <class S, class Stepper = Verner87<std::array<S, 6>, S>>
Computation<S> compute(const Scenario& scenario, const Settings<S>& settings,
                       const GoesOn& goes_on) {
  CourseObserver<S> observer(scenario, goes_on);
  RotorSystem<S> rotor(scenario.parameters, scenario.equations);
  BasicInstant<S> start = start_of<S>(scenario);
  MassLoss<S> loss(scenario.parameters);
  settings.disturbance.disturb(rotor, start, loss);
  const auto at_start = [&] {
    EventMethod<S, Stepper> method(rotor, settings.tolerance, start);
    method.shorten_first_steps(settings.first_steps);
    method.disturb_touch_downs(settings.disturbance.at_touch_downs());
    return method;
  };
  if (scenario.mass_loss_speed_Hz > 0) loss.time_s = time_at_speed(at_start(), scenario, goes_on);
  EventMethod<S, Stepper> method = at_start();
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

}  // namespace rotor
