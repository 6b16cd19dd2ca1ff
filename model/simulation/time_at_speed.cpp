#include "model/simulation/time_at_speed.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

namespace rotor {
namespace {

/// Stops a run-up after the step in which it reaches a speed, or the motor is switched off, and
/// asks another observer whether to go on.
class Watch : public Observer {
 public:
  Watch(double start_s, double speed_Hz, Observer& monitor)
      : after_s(start_s), speed_Hz_(speed_Hz), monitor_(monitor) {}

  void on_instant(const Instant& at) override {
    greatest_Hz = std::max(greatest_Hz, in_Hz(at.state[5]));
    motor_off = motor_off || !at.motor_on;
  }
  bool goes_on(const Progress& now) override {
    if (motor_off) return false;  // no greater speed comes
    after_s = now.time_s;
    greatest_Hz = std::max(greatest_Hz, in_Hz(now.speed));
    return monitor_.goes_on(now) && in_Hz(now.speed) < speed_Hz_;
  }

  double after_s;  ///< end of the last step
  double greatest_Hz = 0;
  bool motor_off = false;

 private:
  double speed_Hz_;
  Observer& monitor_;
};

struct Contact : Observer {
  void on_instant(const Instant& at) override { has_occurred = has_occurred || at.touches(); }
  bool has_occurred = false;
};

}  // namespace

Scenario run_up_to_speed(const Scenario& scenario) {
  Scenario run_up = scenario;
  run_up.parameters.separates = false;
  run_up.method = Method::event;
  return run_up;
}

SpeedReached time_at_speed(const Simulation& from, const Scenario& scenario, double speed_Hz,
                           std::optional<double> until_s, Observer& monitor) {
  const Parameters& p = scenario.parameters;
  const double start_Hz = in_Hz(from.instant().state[5]);
  if (start_Hz >= speed_Hz) return {from.instant().time_s, 0, start_Hz};
  if (p.torque == 0) return {std::nullopt, 0, start_Hz};
  const double end_s = until_s.value_or(2 * p.inertia * 2 * std::numbers::pi * speed_Hz / p.torque);

  Simulation way = from;
  Watch watch(from.instant().time_s, speed_Hz, monitor);
  way.run_up(end_s, watch);
  // The speed may still be a ripple away from where it is without.
  const Simulation before = [&] {
    Simulation whole_steps = from;
    Observer null_observer;
    whole_steps.run_up(watch.after_s, null_observer);
    return whole_steps;
  }();
  Scenario run_up = run_up_to_speed(scenario);
  const auto excess = [&](double time_s) {
    run_up.until = time_s;
    Simulation there = before.with(run_up);
    Contact contact;
    there.finish(contact);
    if (contact.has_occurred) return -1.;
    const double share = in_Hz(there.instant().state[5]) / speed_Hz - 1;
    constexpr double rounding = 1e-12;  // of the speed at which the motor is switched off
    return std::abs(share) < rounding && watch.motor_off ? 0 : share;
  };
  const double before_s = before.instant().time_s;
  double after_s = way.stopped() ? watch.after_s : end_s;
  while (!watch.motor_off && after_s < end_s && excess(after_s) < 0)
    after_s = std::min(end_s, after_s + (watch.after_s - before_s));
  if (excess(after_s) < 0) return {std::nullopt, end_s, watch.greatest_Hz};
  std::uintmax_t iterations = 100;
  const auto [low_s, high_s] = boost::math::tools::toms748_solve(
      excess, before_s, after_s, boost::math::tools::eps_tolerance<double>(), iterations);
  return {high_s, end_s, speed_Hz};
}

}  // namespace rotor
