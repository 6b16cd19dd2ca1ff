/// Mass losses that leave velocities as they are, and stops and speeds on the way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/simulation/simulation.hpp"
#include "model/simulation/stop_on.hpp"
#include "model/simulation/summary.hpp"
#include "model/simulation/time_at_speed.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// Rolls from 2.34 s on. A piece of no mass is lost.
Scenario rolling_before(double loss_s, double until_s) {
  Scenario scenario{.equations = Equations::consistent, .until = until_s};
  Parameters& p = scenario.parameters;
  p.stator_radius = p.rotor_radius + 1e-3;
  p.friction = 0.8;
  p.unbalance_factor = 1;
  p.separation_time = loss_s;
  return scenario;
}

// Its slip stays zero, whatever rounding makes of it; the whirl is that from the loss on.
TEST(LossInRolling, OfNothingChangesNothing) {
  const double until_s = 2.8;
  double last = 1e300;
  for (const double loss_s : {2.4, 2.45, 2.5, 2.55, 2.65, 2.75}) {
    const Scenario scenario = rolling_before(loss_s, until_s);
    EventRecorder events;
    run(scenario, events);
    const auto& all = events.events();
    const auto loss = std::find_if(all.begin(), all.end(),
                                   [](const auto& at) { return at.event == Event::mass_loss; });
    ASSERT_NE(loss, all.end());
    EXPECT_EQ(loss->contact, ContactState::rolling) << loss_s;
    EXPECT_EQ(loss + 1, all.end()) << loss_s;
    SummaryObserver observer(scenario);
    run(scenario, observer);
    const Summary& summary = observer.summary();
    EXPECT_GE(*summary.whirl_from_s, loss_s);
    EXPECT_LT(*summary.whirl_from_s, loss_s + 1e-3);
    EXPECT_LT(-*summary.whirl_frequency_Hz, last) << loss_s;  // it slows down
    last = -*summary.whirl_frequency_Hz;
  }
  EXPECT_GT(last, 30);
}

// A method with fixed steps stops where the force begins to fall.
TEST(StopOnRolling, EndsAtTheFirstMaximumOfTheForceByEitherMethod) {
  double last_s = 0;
  for (const Method method : {Method::event, Method::rk4}) {
    Scenario scenario{.method = method, .start_speed_Hz = 150, .until = 0.25};
    scenario.parameters.separation_time = 0;
    for (const StopOn stop_on : {StopOn::rolling, StopOn::outcome}) {
      StopObserver stop(stop_on, scenario);
      const double end_s = run(scenario, stop).last.time_s;
      EXPECT_TRUE(stop.is_reached());
      EXPECT_LT(end_s, 0.03);
      EXPECT_NEAR(end_s, last_s > 0 ? last_s : end_s, 2e-4);
      last_s = end_s;
    }
  }
}

// The speed ripples as the rotor turns; the first time is wanted of several.
TEST(TimeAtSpeed, IsTheFirstOneWhereTheSpeedRipples) {
  Scenario scenario{.equations = Equations::consistent, .start_speed_Hz = 55};
  Parameters& p = scenario.parameters;
  p.eccentricity = 3e-3;
  p.stator_radius = p.rotor_radius + 20e-3;
  p.torque = 0.02;
  p.support_damping = 1;
  p.unbalance_factor = 1.1;
  Observer nobody;
  for (const double speed_Hz : {56., 56.37, 57.1}) {
    const SpeedReached found =
        time_at_speed(Simulation(scenario), scenario, speed_Hz, std::nullopt, nobody);
    ASSERT_TRUE(found.time_s) << speed_Hz;
    Scenario way = scenario;
    way.parameters.separates = false;
    way.until = *found.time_s + 1;
    double first_s = 0;
    MotionObserver look(0, way.until, [&](const DenseOutput& motion) {
      const double part_s = 1e-4;
      for (double t = motion.from_s; t < motion.until_s && first_s == 0; t += part_s)
        if (in_Hz(motion.at(t).state[5]) > speed_Hz) first_s = t;
    });
    run(way, look);
    EXPECT_NEAR(*found.time_s, first_s, 2e-4) << speed_Hz;
  }
}

}  // namespace
}  // namespace rotor
