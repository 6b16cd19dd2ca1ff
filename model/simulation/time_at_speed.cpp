#include "model/simulation/time_at_speed.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

#include "model/simulation/simulation.hpp"

namespace rotor {
namespace {

/// Notes when the motor is switched off, and asks another observer whether to go on.
class Watch : public Observer {
 public:
  explicit Watch(Observer& monitor) : monitor_(monitor) {}

  void on_instant(const Instant& at) override {
    if (at.event == Event::motor_off) motor_off_s = at.time_s;
  }
  bool goes_on(const Progress& now) override { return monitor_.goes_on(now); }

  std::optional<double> motor_off_s;

 private:
  Observer& monitor_;
};

double speed_Hz_of(const Simulation& simulation) { return in_Hz(simulation.instant().state[5]); }

}  // namespace

SpeedReached time_at_speed(Scenario scenario, double speed_Hz, std::optional<double> until_s,
                           Observer& monitor) {
  const Parameters& p = scenario.parameters;
  scenario.parameters.separates = false;
  scenario.method = Method::event;
  Simulation before(scenario);
  double greatest = speed_Hz_of(before);
  if (greatest >= speed_Hz) return {before.instant().time_s, 0, greatest};
  if (p.torque == 0) return {std::nullopt, 0, greatest};

  const double without_resistance = p.inertia * 2 * std::numbers::pi * speed_Hz / p.torque;
  const double end = until_s.value_or(2 * without_resistance);
  const auto at = [&](double time_s, Watch& watch) {
    Scenario until = scenario;
    until.until = time_s;
    Simulation there = before.with(until);
    there.finish(watch);
    return there;
  };
  // In parts, of which only the last one is repeated.
  constexpr int parts = 100;
  for (int n = 1; n <= parts; ++n) {
    Watch watch(monitor);
    const Simulation after = at(end * n / parts, watch);
    if (after.stopped()) break;
    // A part may pass the greatest speed, at which the motor is switched off.
    const double last_s = watch.motor_off_s.value_or(after.instant().time_s);
    const double last = watch.motor_off_s ? p.motor_off_Hz : speed_Hz_of(after);
    constexpr double rounding = 1e-12;
    if (watch.motor_off_s && std::abs(last / speed_Hz - 1) < rounding) return {last_s, end, last};
    greatest = std::max(greatest, last);
    if (last >= speed_Hz) {
      const auto excess = [&](double time_s) {
        Watch ignored(monitor);
        return speed_Hz_of(at(time_s, ignored)) / speed_Hz - 1;
      };
      std::uintmax_t iterations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          excess, before.instant().time_s, last_s, boost::math::tools::eps_tolerance<double>(),
          iterations);
      return {high, end, speed_Hz};
    }
    before = after;
  }
  return {std::nullopt, end, greatest};
}

}  // namespace rotor
