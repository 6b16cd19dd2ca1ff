/// Outcomes of runs; how far a free rotor reaches; and where runs stop or reach a speed.
#include "model/results/outcome.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "figures/input/names.hpp"
#include "figures/results/run_result.hpp"
#include "figures/runs/run_ups.hpp"
#include "model/scenario/instant.hpp"
#include "verification/support/contradiction.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

// The critical speed is 10 Hz. By either method, and also if runs share their run-up.
TEST(Outcome, IsAStallWhereTheMotorDoesNotGetTheRotorThroughItsCriticalSpeed) {
  struct Case {
    const char* what;
    Parameters parameters{};
    double start_Hz = 0, until_s;
    bool stalls = false;
  };
  for (const Case& c :
       {Case{.what = "hangs after an early loss",
       .parameters = {.mass_loss_time = 1},
       .until_s = 8,
       .stalls = true},
        Case{.what = "gets through and away", .until_s = 29.35},
        Case{.what = "is on its way through", .parameters = {.loses_mass = false}, .until_s = 1.9},
        Case{.what = "rises slowly and is far below",
        .parameters = {.torque = 0.03, .loses_mass = false},
        .until_s = 20},
        Case{.what = "runs down without a torque",
        .parameters = {.torque = 0, .loses_mass = false},
        .start_Hz = 9,
        .until_s = 5},
        Case{.what = "runs down with its motor off",
        .parameters = {.motor_off_Hz = 9, .loses_mass = false},
        .start_Hz = 9,
        .until_s = 5}})
    for (const Method method : {Method::event, Method::rk4}) {
      const Scenario scenario{.parameters = c.parameters,
                              .method = method,
                              .start_speed_Hz = c.start_Hz,
                              .until = c.until_s};
      const Outcome outcome = summary_of(scenario).outcome;
      EXPECT_EQ(outcome == Outcome::stalled, c.stalls) << c.what << ' ' << name_of(method);
      RunUps run_ups;
      EXPECT_EQ(
          complete_run(run_ups.checkpoint_before(scenario, nobody), scenario, std::nullopt, nobody)
              .summary.outcome,
          outcome)
          << c.what;
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
  const Supports<double> supports(p);
  const double bound = reach(start.body, supports, start.motion());
  SummaryObserver summary(scenario);
  run(scenario, start, summary);
  const double greatest = summary.summary().peak_displacement_before_loss_m;
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

/// A rotor that starts over the ring by 0.02 mm, on strongly damped supports, with that velocity
/// along its displacement.
Scenario over_the_ring(double velocity, Method method) {
  Scenario scenario{.equations = Equations::corrected, .method = method, .until = 1};
  scenario.start = Start{.x = 3.02e-3, .velocity_x = velocity};
  Parameters& p = scenario.parameters;
  p.support_damping = 2000;
  p.torque = 0;
  p.loses_mass = false;
  return scenario;
}

// A ring with a dashpot does not follow a rim that leaves it fast: the start is no touch-down.
TEST(Outcome, OfAStartOverTheRingThatDoesNotPressIsNoContact) {
  for (const Method method : {Method::event, Method::rk4}) {
    const Summary left = summary_of(over_the_ring(-2, method));
    EXPECT_EQ(left.outcome, Outcome::no_contact);
    EXPECT_EQ(left.touch_downs, 0);
    EXPECT_EQ(left.first_contact_s, std::nullopt);
    EXPECT_EQ(left.peak_normal_force_N, std::nullopt);
    EXPECT_EQ(left.contact_time_s, 0);
    const Summary pressed = summary_of(over_the_ring(2, method));
    EXPECT_EQ(pressed.first_contact_s, 0);
    EXPECT_GE(pressed.touch_downs, 1);
  }
}

// Renewed contact over a ring that is still indented is a touch-down after a start there, and none
// after a release.
TEST(TouchDowns, CountRenewedContactWhereTheRingHasNotPressedBefore) {
  using enum ContactState;
  const auto count = [](std::initializer_list<ContactState> contacts) {
    TouchDowns touch_downs;
    return std::count_if(contacts.begin(), contacts.end(),
                         [&](ContactState contact) { return touch_downs.begins_with(contact); });
  };
  EXPECT_EQ(count({free, sliding, rolling, indented, sliding, indented, free}), 1);
  EXPECT_EQ(count({free, rolling, free, sliding, free}), 2);
  EXPECT_EQ(count({indented, free}), 0);
  EXPECT_EQ(count({indented, sliding, indented, sliding, free, sliding}), 2);
  EXPECT_EQ(count({free, indented, free}), 1);  // within a fixed step
}

// By itself, without friction, a rim that does not slip does not roll; however small a velocity
// across, the outcome is the same.
TEST(Outcome, IsNoRollingWithoutFriction) {
  for (const Method method : {Method::event, Method::rk4})
    for (const double across : {0., 1e-9}) {
      Scenario scenario{.equations = Equations::corrected, .method = method, .until = 0.05};
      scenario.start = Start{.velocity_x = 2, .velocity_y = across};
      Parameters& p = scenario.parameters;
      p.eccentricity = p.torque = p.friction = 0;
      p.loses_mass = false;
      const Summary bouncing = summary_of(scenario);
      EXPECT_EQ(bouncing.outcome, Outcome::bouncing) << across;
      EXPECT_EQ(bouncing.touch_downs, 6) << across;
      p.friction = 1e-6;  // sticking is rolling, also at 0 Hz
      if (across == 0) {
        EXPECT_EQ(summary_of(scenario).outcome, Outcome::rolling);
      }
    }
}

// What stops a run leaves room for the errors of the rest: a vibration that just reaches the ring
// touches it eight times by rounding.
TEST(Outcome, IsOpenWhereErrorsDecideWhetherTheRingIsReached) {
  Scenario scenario{.equations = Equations::corrected,
                    .start_speed_Hz = 1096,
                    .start = Start{.y = -0.02533},
                    .until = 0.01481,
                    .tolerance = 1e-9};
  Parameters& p = scenario.parameters;
  p = {.mass = 0.002424,
       .inertia = 0.0001592,
       .eccentricity = 0,
       .support_stiffness = 7864,
       .support_damping = 0,
       .gravity = 18.76,
       .drive = Drive::constant_speed,
       .torque = 0,
       .contact_stiffness = 1639,
       .contact_damping = 0.08673,
       .friction = 0.005188,
       .rotor_radius = 0.4298,
       .stator_radius = 0.4298 + 0.02533,
       .loses_mass = false};
  const auto finished = [&](std::optional<StopOn> stop_on) {
    return complete_run(RunUpCheckpoint(scenario), scenario, stop_on, nobody);
  };
  EXPECT_GT(finished(std::nullopt).summary.touch_downs, 0);
  EXPECT_EQ(contradiction(finished(StopOn::outcome), finished(std::nullopt)), "");
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
