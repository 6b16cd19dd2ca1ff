#include "model/run/time_at_speed.hpp"

#include <algorithm>

namespace rotor {
namespace {

/// Watches a run-up whose motor is switched off at the speed that is looked for. Stops it there, at
/// a contact, or when the monitor does.
class SpeedWatch : public Observer {
 public:
  explicit SpeedWatch(Observer& monitor) : monitor_(monitor) {}

  void on_instant(const Instant& at) override {
    if (reached.time_s || reached.touches) return;
    reached.looked_until_s = at.time_s;
    reached.greatest_Hz = std::max(reached.greatest_Hz, in_Hz(at.state[5]));
    reached.touches = at.touches();
    if (at.event == Event::motor_off) reached.time_s = at.time_s;
  }
  bool should_continue(const Progress& now) override {
    if (reached.time_s || reached.touches) return false;
    reached.greatest_Hz = std::max(reached.greatest_Hz, in_Hz(now.speed));
    return monitor_.should_continue(now);
  }

  SpeedReached reached{};

 private:
  Observer& monitor_;
};

}  // namespace

Scenario run_up_to_speed(const Scenario& scenario) {
  Scenario run_up = scenario;
  run_up.parameters.loses_mass = false;
  run_up.method = Method::event;
  return run_up;
}

SpeedReached time_at_speed(const Simulation& from, const Scenario& scenario, double speed_Hz,
                           std::optional<double> until_s, Observer& monitor) {
  Scenario run_up = run_up_to_speed(scenario);
  Parameters& p = run_up.parameters;
  const double start_Hz = in_Hz(from.instant().state[5]);
  constexpr double speed_rounding = 1e-12;
  if (start_Hz >= (1 - speed_rounding) * speed_Hz)
    return {from.instant().time_s, 0, start_Hz, false};
  if (p.torque == 0 || !from.instant().motor_on) return {std::nullopt, 0, start_Hz, false};
  run_up.until = until_s.value_or(2 * p.inertia * two_pi * speed_Hz / p.torque);
  p.motor_off_Hz = std::min(p.motor_off_Hz, speed_Hz);
  SpeedWatch watch(monitor);
  from.with(run_up).finish(watch);
  if (p.motor_off_Hz < speed_Hz) watch.reached.time_s = std::nullopt;
  return watch.reached;
}

}  // namespace rotor
