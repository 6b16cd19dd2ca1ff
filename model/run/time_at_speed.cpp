#include "model/run/time_at_speed.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>

namespace rotor {
namespace {

/// Asks another observer after every step until that ends the run.
class CancellationMonitor : public Observer {
 public:
  explicit CancellationMonitor(Observer& monitor) : monitor_(monitor) {}

  bool goes_on(const Progress& now) override {
    is_over = is_over || !monitor_.goes_on(now);
    return !is_over;
  }

  bool is_over = false;

 private:
  Observer& monitor_;
};

/// Stops a run-up after the step in which it reaches a speed, or the motor is switched off.
class Watch : public Observer {
 public:
  Watch(double start_s, double speed_Hz, CancellationMonitor& monitor)
      : after_s(start_s), speed_Hz_(speed_Hz), monitor_(monitor) {}

  void on_instant(const Instant& at) override {
    greatest_Hz = std::max(greatest_Hz, in_Hz(at.state[5]));
    motor_off = motor_off || !at.motor_on;
  }
  bool goes_on(const Progress& now) override {
    if (motor_off) return false;  // the speed cannot rise further
    after_s = now.time_s;
    greatest_Hz = std::max(greatest_Hz, in_Hz(now.speed));
    return monitor_.goes_on(now) && in_Hz(now.speed) < speed_Hz_;
  }

  double after_s;  ///< end of the last step
  double greatest_Hz = 0;
  bool motor_off = false;

 private:
  double speed_Hz_;
  CancellationMonitor& monitor_;
};

/// Stops a run that touches the ring.
class UntilContact : public Observer {
 public:
  explicit UntilContact(CancellationMonitor& monitor) : monitor_(monitor) {}

  void on_instant(const Instant& at) override {
    if (!touches) until_s = at.time_s;
    if (!touches) greatest_Hz = std::max(greatest_Hz, in_Hz(at.state[5]));
    touches = touches || at.touches();
  }
  bool goes_on(const Progress& now) override { return !touches && monitor_.goes_on(now); }

  double until_s = 0, greatest_Hz = 0;
  bool touches = false;

 private:
  CancellationMonitor& monitor_;
};

/// Bound of the moment with which gravity and springs drive and brake the turning rotor, N m.
double ripple(const Scenario& scenario, const Instant& at) {
  const Parameters& p = scenario.parameters;
  const Supports<double> supports(p, scenario.equations);
  const Motion<double> m = at.motion();
  const double displacement = m.displacement.norm() + p.eccentricity;
  return p.mass * p.gravity * displacement +
         p.eccentricity * supports.greatest_bearing_force(displacement, m.velocity.norm());
}

}  // namespace

Scenario run_up_to_speed(const Scenario& scenario) {
  Scenario run_up = scenario;
  run_up.parameters.loses_mass = false;
  run_up.method = Method::event;
  return run_up;
}

SpeedReached time_at_speed(const Simulation& from, const Scenario& scenario, double speed_Hz,
                           std::optional<double> until_s, Observer& monitor) {
  const Parameters& p = scenario.parameters;
  const double start_Hz = in_Hz(from.instant().state[5]);
  constexpr double speed_rounding = 1e-12;
  if (start_Hz >= (1 - speed_rounding) * speed_Hz)
    return {from.instant().time_s, 0, start_Hz, false};
  if (p.torque == 0) return {std::nullopt, 0, start_Hz, false};
  const double end_s = until_s.value_or(2 * p.inertia * two_pi * speed_Hz / p.torque);

  Simulation way = from;
  CancellationMonitor cancellation(monitor);
  Watch watch(from.instant().time_s, speed_Hz, cancellation);
  way.run_up(end_s, watch);
  const auto nothing = [&watch] {
    return SpeedReached{std::nullopt, watch.after_s, watch.greatest_Hz, false};
  };
  if (cancellation.is_over) return nothing();
  // The speed may still differ by its ripple.
  const auto whole_steps_to = [&](double time_s) {
    Simulation whole_steps = from;
    whole_steps.run_up(time_s, cancellation);
    return whole_steps;
  };
  Simulation before = whole_steps_to(watch.after_s);
  Scenario run_up = run_up_to_speed(scenario);
  std::optional<UntilContact> look;
  const auto excess = [&](double time_s) {
    run_up.until = time_s;
    Simulation there = before.with(run_up);
    there.finish(look.emplace(cancellation));
    const double share = in_Hz(there.instant().state[5]) / speed_Hz - 1;
    return std::abs(share) < speed_rounding && watch.motor_off ? 0 : share;  // at the motor's limit
  };
  double before_s = before.instant().time_s, after_s = way.stopped() ? watch.after_s : end_s;
  const auto may_become_faster = [&] { return !watch.motor_off && !look->touches; };
  while (after_s < end_s && excess(after_s) < 0 && may_become_faster() && !cancellation.is_over)
    after_s = std::min(end_s, after_s + (watch.after_s - before_s));
  if (excess(after_s) < 0)
    return {std::nullopt, look->until_s, std::max(watch.greatest_Hz, look->greatest_Hz),
            look->touches};
  // If the ripple brakes the rotor more than the motor drives it, the speed may be reached several
  // times; if it drives the rotor, possibly before the last step begins.
  const double moment = ripple(scenario, before.instant());
  const bool may_slow_down = moment > p.torque / 2;
  if (may_slow_down || excess(before_s) >= 0) {
    const double back_s = 4 * moment / (two_pi * speed_Hz * p.torque);
    before = whole_steps_to(std::max(before_s - back_s, from.instant().time_s));
    before_s = before.instant().time_s;
  }
  if (may_slow_down) {
    const double part_s = 1 / (16 * speed_Hz);
    double next_s = before_s + part_s;
    while (next_s < after_s && !cancellation.is_over) {
      if (excess(next_s) >= 0) {
        after_s = next_s;
      } else {
        before.run_up(next_s, cancellation);
        before_s = next_s;
        next_s += part_s;
      }
    }
  }
  if (cancellation.is_over) return nothing();
  std::uintmax_t iterations = 100;
  const auto [low_s, high_s] = boost::math::tools::toms748_solve(
      excess, before_s, after_s, boost::math::tools::eps_tolerance<double>(), iterations);
  if (cancellation.is_over) return nothing();
  return {high_s, end_s, speed_Hz, false};
}

}  // namespace rotor
