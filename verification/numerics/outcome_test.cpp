/// Outcomes of runs; how far a free rotor reaches; and where runs stop or reach a speed.
#include "model/results/outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "figures/input/names.hpp"
#include "figures/results/run_result.hpp"
#include "figures/runs/run_ups.hpp"
#include "model/scenario/instant.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

// The critical speed is 10 Hz. By either method, and also if runs share their run-up.
TEST(Outcome, IsAStallWhereTheMotorDoesNotGetTheRotorThroughItsCriticalSpeed) {
  constexpr double never_s = 99;
  for (const auto& [what, start_Hz, torque, motor_off_Hz, mass_loss_s, until_s, stalls] :
       {std::tuple("hangs after an early loss", 0., 0.3, 150., 1., 8., true),
        {"gets through and away", 0, 0.3, 150, 29.1, 29.35, false},
        {"is on its way through", 0, 0.3, 150, never_s, 1.9, false},
        {"rises slowly and is far below", 0, 0.03, 150, never_s, 20, false},
        {"runs down without a torque", 9, 0, 150, never_s, 5, false},
        {"runs down with its motor off", 9, 0.3, 9, never_s, 5, false}})
    for (const Method method : {Method::event, Method::rk4}) {
      Scenario scenario{.method = method, .start_speed_Hz = start_Hz, .until = until_s};
      Parameters& p = scenario.parameters;
      p.torque = torque;
      p.motor_off_Hz = motor_off_Hz;
      p.mass_loss_time = mass_loss_s;
      p.loses_mass = mass_loss_s < never_s;
      const Outcome outcome = summary_of(scenario).outcome;
      EXPECT_EQ(outcome == Outcome::stalled, stalls) << what << ' ' << name_of(method);
      RunUps run_ups;
      EXPECT_EQ(finish(run_ups.checkpoint_before(scenario, nobody), scenario, std::nullopt, nobody)
                    .summary.outcome,
                outcome)
          << what;
    }
}

// A fan of 400 kg, 14 ms before it rolls: its motor is on, its speed 1.3 times the critical one and
// falling.
TEST(Outcome, IsNoStallWhileTheRingDrivesTheRotorBackwards) {
  const Scenario scenario{.parameters = {.mass = 400,
                                         .inertia = 90,
                                         .eccentricity = 5e-5,
                                         .support_stiffness = 8e5,
                                         .support_damping = 1810,
                                         .torque = 300,
                                         .motor_off_Hz = 50,
                                         .contact_stiffness = 1e8,
                                         .contact_damping = 2e4,
                                         .friction = 0.1,
                                         .rotor_radius = 0.9,
                                         .stator_radius = 0.905,
                                         .unbalance_factor = 135,
                                         .mass_loss_time = 2},
                          .start_speed_Hz = 24,
                          .until = 2.25};
  EXPECT_EQ(summary_of(scenario).outcome, Outcome::sliding);
}

// A contact counts as lasting once it is longer than a vibration on the ring; the time restarts
// with a new contact, even if the ring has not sprung back.
TEST(Outcome, IsSlidingAfterANaturalPeriodOfTheContactAndNotBefore) {
  Scenario scenario;
  const Parameters& p = scenario.parameters;
  OutcomeWatch watch(scenario);
  Instant at = at_rest<double>(p);
  at.state[0] = Ring<double>(p).clearance;
  const double period = two_pi * std::sqrt(p.mass / p.contact_stiffness);
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

// The reach is exact: a free rotor that starts with a vibration reaches it, and no more.
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

// At rest, without supports: it does not move.
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

// A step of the published method may touch the ring and end above its indentation.
TEST(Outcome, CountsTheContactsThatTheSummaryCounts) {
  Scenario scenario{
      .equations = Equations::corrected, .method = Method::rk4, .start_speed_Hz = 60, .until = 0.3};
  Parameters& p = scenario.parameters;
  p.mass_loss_time = 0;
  scenario.step_rub = 5e-5;
  p.contact_damping = 1e4;
  p.stator_radius = p.rotor_radius + 0.002114292636948066;
  const Summary summary = summary_of(scenario);
  EXPECT_EQ(summary.touch_downs, 1);
  EXPECT_EQ(summary.outcome, Outcome::freed);
}

// The speed ripples as the rotor turns, and the first of several times is needed. Due to gravity it
// may be before the last step of the run-up.
TEST(TimeAtSpeed, IsTheFirstOneWhereTheSpeedRipples) {
  Scenario rippling{.equations = Equations::corrected, .start_speed_Hz = 55};
  Parameters& p = rippling.parameters;
  p.eccentricity = 3e-3;
  p.stator_radius = p.rotor_radius + 20e-3;
  p.torque = 0.02;
  p.support_damping = 1;
  p.unbalance_factor = 1.1;
  Scenario from_rest{.equations = Equations::corrected}, slow = from_rest;
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
    const SpeedReached found = RunUps().time_at_speed(scenario, speed_Hz, std::nullopt, nobody);
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
