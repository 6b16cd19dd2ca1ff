#include "model/simulation/time_at_speed.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>

#include "model/simulation/simulation.hpp"

namespace rotor {
namespace {

struct Seen : Observer {
  void on_instant(const Instant& at) override {
    if (at.event == Event::motor_off) motor_off_s = at.time_s;
  }
  std::optional<double> motor_off_s;
};

double in_Hz(const Instant& at) { return at.state[5] / (2 * std::numbers::pi); }

}  // namespace

SpeedReached time_at_speed(Scenario scenario, double speed_Hz, std::optional<double> until_s) {
  const Parameters& p = scenario.parameters;
  scenario.parameters.separates = false;
  scenario.method = Method::event;
  const double without_resistance = p.inertia * 2 * std::numbers::pi * speed_Hz / p.torque;
  const double end = until_s.value_or(std::min(2 * without_resistance, 1e9));
  const auto at = [&](const Simulation& from, double time_s) {
    Scenario until = scenario;
    until.until = time_s;
    Simulation there = from.with(until);
    Seen seen;
    there.finish(seen);
    return std::pair(there, seen.motor_off_s);
  };

  // In parts, of which only the last one is repeated.
  Simulation before(scenario);
  double greatest = in_Hz(before.instant());
  if (greatest >= speed_Hz) return {before.instant().time_s, end, greatest};
  constexpr int parts = 100;
  for (int n = 1; n <= parts; ++n) {
    const auto [after, motor_off_s] = at(before, end * n / parts);
    // The motor is switched off at the greatest speed that it drives.
    if (motor_off_s && std::abs(p.motor_off_Hz / speed_Hz - 1) < 1e-12)
      return {motor_off_s, end, speed_Hz};
    const double last = in_Hz(after.instant());
    greatest = std::max(greatest, last);
    if (last >= speed_Hz) {
      std::uintmax_t iterations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          [&](double time_s) { return in_Hz(at(before, time_s).first.instant()) / speed_Hz - 1; },
          before.instant().time_s, after.instant().time_s,
          boost::math::tools::eps_tolerance<double>(), iterations);
      return {high, end, speed_Hz};
    }
    before = after;
  }
  return {std::nullopt, end, greatest};
}

}  // namespace rotor
