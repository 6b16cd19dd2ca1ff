/// How runs end, in a word; how far a free rotor reaches; and where runs stop or are at a speed.
#include "model/results/outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "figures/input/names.hpp"
#include "figures/results/run_result.hpp"
#include "figures/runs/run_ups.hpp"
#include "model/run/time_at_speed.hpp"
#include "model/scenario/start.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

// By either method, and wherever the run-up ends that runs share.
TEST(Outcome, OfARotorThatHangsAtItsCriticalSpeedIsAStallByEitherMethod) {
  for (const auto& [loss_s, until_s, stalls] :
       {std::tuple(1., 8., true), {29.5, 30., true}, {2., 6., true}, {29.1, 29.35, false}})
    for (const Method method : {Method::event, Method::rk4}) {
      Scenario scenario{.method = method, .until = until_s};
      scenario.parameters.mass_loss_time = loss_s;
      if (loss_s > 29.2) scenario.parameters.support_stiffness = 1.2e5;
      const Outcome outcome = summary_until(until_s, scenario).outcome;
      EXPECT_EQ(outcome == Outcome::stalled, stalls) << loss_s << ' ' << name_of(method);
      if (method == Method::rk4) continue;
      RunUps run_ups;
      Observer null_observer;
      EXPECT_EQ(finish(run_ups.checkpoint_before(scenario, null_observer), scenario, std::nullopt,
                       null_observer)
                    .summary.outcome,
                outcome);
    }
}

// A contact lasts once it is longer than a vibration on the ring; a new one begins anew, though the
// ring may not be back.
TEST(Outcome, IsSlidingAfterANaturalPeriodOfTheContactAndNotBefore) {
  Scenario scenario;
  const Parameters& p = scenario.parameters;
  OutcomeWatch watch(scenario);
  Instant at = at_rest<double>(p);
  at.state[0] = p.stator_radius - p.rotor_radius;
  const double period = 2 * std::numbers::pi * std::sqrt(p.mass / p.contact_stiffness);
  for (const ContactState before : {ContactState::free, ContactState::indented}) {
    at.contact = before;
    watch.note(at);
    at.contact = ContactState::sliding;
    const double begin_s = at.time_s;
    for (const auto& [periods, outcome] :
         {std::pair(0.0, Outcome::bouncing), {0.99, Outcome::bouncing}, {1.01, Outcome::sliding}}) {
      at.time_s = begin_s + periods * period;
      watch.note(at);
      EXPECT_EQ(watch.outcome(), outcome) << periods;
    }
  }
}

// Still at the critical speed, but on its way through it.
TEST(Outcome, OfARotorThatPassesItsCriticalSpeedIsNotStalled) {
  Scenario scenario;
  scenario.parameters.loses_mass = false;
  EXPECT_NE(summary_until(1.9, scenario).outcome, Outcome::stalled);
  scenario.parameters.torque = 0.03;  // slowly, and far below it
  EXPECT_EQ(summary_until(20, scenario).outcome, Outcome::no_contact);
}

// What drives nothing does not fail to drive.
TEST(Outcome, OfARotorThatRunsDownNearItsCriticalSpeedIsNoStall) {
  Scenario scenario{.start_speed_Hz = 9};
  scenario.parameters.loses_mass = false;
  scenario.parameters.torque = 0;
  EXPECT_EQ(summary_until(5, scenario).outcome, Outcome::no_contact);
  scenario.parameters.torque = Parameters{}.torque;  // nor does a motor that is off
  scenario.parameters.motor_off_Hz = 9;
  EXPECT_EQ(summary_until(5, scenario).outcome, Outcome::no_contact);
}

// Exactly as far as it says: a free rotor that is let go with a vibration reaches it, and not more.
class Reach : public testing::TestWithParam<double> {};

TEST_P(Reach, IsThatOfAnUndampedVibrationAboutTheSteadyResponse) {
  Scenario scenario{.until = 30};
  Parameters& p = scenario.parameters;
  p.support_damping = p.gravity = p.torque = 0;
  p.loses_mass = false;
  p.motor_off_Hz = 0;
  p.stator_radius = 0.08;
  scenario.start_speed_Hz = GetParam();
  Instant start = start_of(scenario);
  start.state[1] += 0.8e-3;
  start.state[4] += 0.05;
  const Supports<double> supports(p, scenario.equations);
  const double bound = reach(start.body, supports, start.motion());
  SummaryObserver summary(scenario);
  run(scenario, start, summary);
  const double greatest = summary.summary().max_displacement_before_loss_m;
  EXPECT_LE(greatest, bound);
  // Of amplitudes that only add up when they happen to meet, one of them an ellipse's diagonal.
  EXPECT_GT(greatest, 0.96 * bound);
}

INSTANTIATE_TEST_SUITE_P(BelowAndAboveTheCriticalSpeed, Reach, testing::Values(6.3, 60.));

// The bounds of energy between which the speed is looked for, written out anew: the springs, the
// vibration and gravity take it from the rotation or give it, the damping takes, the motor gives.
// The response of O to the unbalance is that without damping, of which there is next to none.
class Clear : public testing::TestWithParam<double> {};

TEST_P(Clear, IsARotorThatNoSpeedWithinTheBoundsOfEnergyBringsToTheRing) {
  const bool speeds_up = GetParam() < 10;  // to the critical speed, 10.07 Hz, or down to it
  const double until_s = 1e4;
  Scenario scenario{.until = until_s};
  Parameters& p = scenario.parameters;
  p.loses_mass = false;
  p.support_damping = 1e-3;
  p.stator_radius = 1;
  scenario.start_speed_Hz = GetParam();
  Instant at = start_of(scenario);
  const double amplitude = 0.8e-3, speed = at.state[5], square = p.support_stiffness / p.mass;
  at.state[1] += amplitude;
  at.state[3] += amplitude * speed;  // which leaves C the velocity that it has in steady response
  const auto response = [&](double w) { return p.eccentricity * w * w / std::abs(square - w * w); };
  const double farthest = amplitude + response(speed);
  const double velocity = amplitude * std::sqrt(square) + response(speed) * speed;
  const double exchanged = p.mass * velocity * velocity / 2 + 2 * p.mass * p.gravity * farthest +
                           p.support_stiffness * farthest * farthest / 2;
  const double damped = p.support_damping * velocity * velocity * until_s;
  p.inertia = 2 * exchanged / (0.2 * speed * speed);  // so that a fifth of the energy is at stake
  p.torque = 0.05 * speed * p.inertia / until_s;
  const double bound = speeds_up ? std::sqrt(1.2) * speed + 0.05 * speed
                                 : std::sqrt(0.8 * speed * speed - 2 * damped / p.inertia);
  ASSERT_GT(response(bound), 1.1 * response(speed));  // elsewhere than at the present speed
  at.body = Body<double>::of(p);
  for (const double share : {0.999, 1.001}) {
    p.stator_radius = p.rotor_radius + share * (amplitude + response(bound));
    OutcomeWatch watch(scenario);
    watch.note(at);
    EXPECT_EQ(watch.stays_clear(), share > 1) << share;
  }
}

INSTANTIATE_TEST_SUITE_P(BelowAndAboveTheCriticalSpeed, Clear, testing::Values(6.3, 16.));

// At rest where it would be without supports: it moves nowhere.
TEST(Outcome, OfARotorWithoutSupportsThatMovesNowhereIsNoContact) {
  Scenario scenario{.start_speed_Hz = 50, .until = 1};
  Parameters& p = scenario.parameters;
  p.support_stiffness = p.support_damping = p.eccentricity = 0;
  p.loses_mass = false;
  EXPECT_EQ(summary_of(scenario).outcome, Outcome::no_contact);
  p.eccentricity = Parameters().eccentricity;
  p.gravity = p.torque = scenario.start_speed_Hz = 0;
  p.stator_radius = p.rotor_radius + p.eccentricity / 2;  // which C is off, not O
  EXPECT_EQ(summary_of(scenario).outcome, Outcome::no_contact);
}

// A step of the published method may touch the ring and end over its indentation.
TEST(Outcome, CountsTheContactsThatTheSummaryCounts) {
  Scenario scenario{.equations = Equations::consistent,
                    .method = Method::rk4,
                    .start_speed_Hz = 60,
                    .until = 0.3};
  Parameters& p = scenario.parameters;
  p.mass_loss_time = 0;
  scenario.step_rub = 5e-5;
  p.contact_damping = 1e4;
  p.stator_radius = p.rotor_radius + 0.002114292636948066;
  const Summary summary = summary_of(scenario);
  EXPECT_EQ(summary.touch_downs, 1);
  EXPECT_EQ(summary.outcome, Outcome::freed);
}

// A method with fixed steps stops where the force begins to fall.
TEST(StopOnRolling, EndsAtTheFirstMaximumOfTheForceByEitherMethod) {
  double last_s = 0;
  for (const Method method : {Method::event, Method::rk4}) {
    Scenario scenario{.method = method, .start_speed_Hz = 150, .until = 0.25};
    scenario.parameters.mass_loss_time = 0;
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

// The speed ripples as the rotor turns; the first time is wanted of several. Gravity may have
// brought it there before the last step of a run-up without it begins.
TEST(TimeAtSpeed, IsTheFirstOneWhereTheSpeedRipples) {
  Scenario rippling{.equations = Equations::consistent, .start_speed_Hz = 55};
  Parameters& p = rippling.parameters;
  p.eccentricity = 3e-3;
  p.stator_radius = p.rotor_radius + 20e-3;
  p.torque = 0.02;
  p.support_damping = 1;
  p.unbalance_factor = 1.1;
  Scenario from_rest{.equations = Equations::consistent}, slow = from_rest;
  from_rest.parameters.stator_radius = slow.parameters.stator_radius = p.rotor_radius + 0.1;
  slow.parameters.torque = 0.036;
  slow.tolerance = 1e-14;
  for (auto [scenario, speed_Hz] : {std::pair(rippling, 56.),
                                    {rippling, 56.37},
                                    {rippling, 57.1},
                                    {from_rest, 20.32162},
                                    {from_rest, 20.84116},
                                    {from_rest, 24.37898},
                                    {slow, 30.16081}}) {
    Observer null_observer;
    const SpeedReached found =
        time_at_speed(Simulation(scenario), scenario, speed_Hz, std::nullopt, null_observer);
    ASSERT_TRUE(found.time_s) << speed_Hz;
    scenario.parameters.loses_mass = false;
    scenario.until = *found.time_s;
    double greatest = 0;  // before
    MotionObserver look(0, *found.time_s - 1e-6, [&](const DenseOutput& motion) {
      const double until_s = std::min(motion.until_s, *found.time_s - 1e-6);
      for (double t = std::max(motion.from_s, until_s - 0.05); t < until_s; t += 1e-4)
        greatest = std::max(greatest, in_Hz(motion.at(t).state[5]));
    });
    EXPECT_NEAR(in_Hz(run(scenario, look).last.state[5]) / speed_Hz, 1, 1e-9);
    EXPECT_LT(greatest, speed_Hz);
  }
}

}  // namespace
}  // namespace rotor
