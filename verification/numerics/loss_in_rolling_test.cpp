/// Mass losses that leave velocities as they are, and stops and speeds on the way.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "figures/scenes/columns.hpp"
#include "model/simulation/extended/comparison.hpp"
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

// Its slip stays zero, whatever rounding makes of it, and its whirl is that of the whole rolling,
// though the angle begins anew. So it is where the jump that counts twice is none.
TEST(LossInRolling, OfNothingChangesNothing) {
  for (const Equations& equations : {Equations::consistent, Equations::published})
    for (const Method method : {Method::event, Method::rk4}) {
      Scenario without = rolling_before(0, 2.8);
      without.equations = equations;
      without.method = method;
      without.parameters.separates = false;
      const Summary expected = summary_of(without);
      ASSERT_EQ(expected.outcome, Outcome::rolling);
      for (const double loss_s : {2.4, 2.45, 2.5, 2.55, 2.65, 2.75}) {
        Scenario scenario = without;
        scenario.parameters.separates = true;
        scenario.parameters.separation_time = loss_s;
        EventRecorder events;
        run(scenario, events);
        if (method == Method::event) {
          const auto& all = events.events();
          ASSERT_EQ(events.count(Event::mass_loss), 1);
          EXPECT_EQ(all.back().event, Event::mass_loss) << loss_s;
          EXPECT_EQ(all.back().contact, ContactState::rolling) << loss_s;
        }
        const Summary summary = summary_of(scenario);
        EXPECT_NEAR(*summary.whirl_from_s, *expected.whirl_from_s, 1e-9) << loss_s;
        EXPECT_EQ(summary.whirl_until_s, expected.whirl_until_s) << loss_s;
        const double error = method == Method::event ? 1e-8 : 1e-3;
        EXPECT_NEAR(*summary.whirl_frequency_Hz / *expected.whirl_frequency_Hz, 1, error) << loss_s;
      }
    }
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

/// Of instants in rolling the largest share of mu |F_n| that friction has, and of those just before
/// and at the loss.
struct Grip : Observer {
  explicit Grip(const Scenario& scenario)
      : context(scenario), friction(scenario.parameters.friction) {}
  void on_instant(const Instant& at) override {
    if (at.event == Event::mass_loss) {
      before_loss = last;
      loss_s = at.time_s;
      at_loss = share(at);
    }
    if (at.contact == ContactState::rolling) last = share(at);
    if (at.time_s > loss_s && at.contact == ContactState::rolling)
      largest_after = std::max(largest_after, last);
  }
  double share(const Instant& at) const {
    View view(at, context);
    return std::abs(view.friction()) / (friction * std::abs(view.normal_force()));
  }

  ColumnContext context;
  double friction, loss_s = std::numeric_limits<double>::infinity(), last = 0, before_loss = 0,
                   at_loss = 0, largest_after = 0;
};

// The lighter rotor needs more friction than there is: it breaks away where it loses its mass.
TEST(LossInRolling, IsItsEndWhereFrictionCannotHoldTheRimAnyMore) {
  Scenario scenario{.equations = Equations::consistent, .until = 0.1708};
  Parameters& p = scenario.parameters;
  p.stator_radius = p.rotor_radius + 0.001475357217480754;
  p.friction = 0.37190941845000236;
  p.eccentricity = 0.0020541422388225413;
  p.torque = 3.34606887213461;
  p.contact_stiffness = 531646519.4155671;
  p.contact_damping = 129.3553134786258;
  p.inertia = 0.0032870302767832728;
  p.unbalance_factor = 1.5;
  p.separation_time = 0.17064984521861742;
  Grip grip(scenario);
  run(scenario, grip);
  EXPECT_LT(grip.before_loss, 1);
  EXPECT_GT(grip.at_loss, 1.01);
  EXPECT_LT(grip.largest_after, 1 + 1e-9);
  EventRecorder events;
  run(scenario, events);
  const auto& all = events.events();
  const auto loss = std::ranges::find(all, Event::mass_loss, &Instant::event);
  ASSERT_NE(loss + 1, all.end());
  EXPECT_EQ((loss + 1)->event, Event::break_away);
  EXPECT_EQ((loss + 1)->time_s, loss->time_s);
  scenario.until = p.separation_time + 1e-6;  // its digits are known nevertheless
  const auto found = compare<double>(scenario, 1e-10, [](double /*time_s*/) { return true; });
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_course_sure());
}

// Gravity may have brought it there before the last step of a run-up without it begins.
TEST(TimeAtSpeed, IsFoundWhereTheRippleReachesTheSpeedBeforeTheLastStep) {
  Observer nobody;
  for (const auto& [speed_Hz, torque, tolerance] : {std::tuple(20.32162, 0.3, 1e-11),
                                                    {20.84116, 0.3, 1e-11},
                                                    {24.37898, 0.3, 1e-11},
                                                    {30.16081, 0.036, 1e-14}}) {
    Scenario scenario{.equations = Equations::consistent};
    Parameters& p = scenario.parameters;
    p.stator_radius = p.rotor_radius + 0.1;
    p.torque = torque == 0.3 ? Parameters{}.torque : torque;
    scenario.tolerance = tolerance;
    const SpeedReached found =
        time_at_speed(Simulation(scenario), scenario, speed_Hz, std::nullopt, nobody);
    ASSERT_TRUE(found.time_s) << speed_Hz;
    scenario.until = *found.time_s;
    p.separates = false;
    EXPECT_NEAR(run(scenario, nobody).last.state[5] / (2 * std::numbers::pi * speed_Hz), 1, 1e-9);
  }
}

}  // namespace
}  // namespace rotor
