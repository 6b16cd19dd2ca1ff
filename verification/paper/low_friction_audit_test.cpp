/// The audit at low friction, where single runs say little, and of collisions and the contact's
/// damping.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "figures/scenes/account.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// In how many runs the rotor comes to roll, over the rounding of t_1 = 29.1 s.
int count_that_rolls(const Parameters& parameters, int draws) {
  RunUps run_ups;
  Observer null_observer;
  int rolls = 0;
  for (int n = 0; n < draws; ++n) {
    Scenario scenario{.parameters = parameters, .tolerance = 1e-9};
    // By the golden section: at equal distances the rotor would meet the loss at but four angles.
    scenario.parameters.separation_time = 29.05 + 0.1 * std::fmod(n * std::numbers::phi, 1);
    scenario.until = scenario.parameters.separation_time + 0.25;
    const Account account =
        finish(run_ups.depart(scenario, null_observer), scenario, std::nullopt, null_observer);
    rolls += account.summary.rolling_onset_s.has_value();
  }
  return rolls;
}

// One run says nothing here: near the border whether the rotor rolls is a matter of t_1's digits.
TEST(Audit, TheDampingOfTheContactDecidesWhetherTheRotorRollsAtLowFriction) {
  constexpr int draws = 300, few = 60;
  const auto with = [](double times_damping, double times_stiffness, double friction, int count) {
    Parameters p{.friction = friction};
    p.contact_damping *= times_damping;
    p.contact_stiffness *= times_stiffness;
    return count_that_rolls(p, count);
  };
  EXPECT_EQ(with(0.5, 1, 0.08, draws), draws);
  EXPECT_EQ(with(1, 1, 0.08, draws), 0);
  EXPECT_EQ(with(2, 1, 0.08, few), 0);
  const int slightly_less = with(0.9, 1, 0.08, draws);
  // 46 % of 3000 runs. Counts of 300 have a standard error of 8.7: three of them.
  EXPECT_NEAR(slightly_less, 138, 26);
  EXPECT_NEAR(with(1, 1, 0.0849, few), 29, 12);  // 3.9
  EXPECT_LT(with(1, 1.1, 0.08, few), 15);
}

TEST(Audit, TwiceTheContactsDampingMakesMoreTouchDownsBeforeRolling) {
  const auto touch_downs = [](double damping) {
    return summary_of({.parameters = {.contact_damping = damping}}).collisions;
  };
  EXPECT_EQ(touch_downs(1e4), 7);
  EXPECT_EQ(touch_downs(2e4), 10);
}

// A single run at low friction is no result: all three of these round to the printed d_t or nearly.
TEST(Audit,
     AtLowFrictionTheRubDiesOutOrGoesOverIntoSlidingOrRollingWithinAFifthOfThePrintedDamping) {
  const auto with = [](double damping) {
    return summary_of({.parameters = {.contact_damping = damping, .friction = 0.08}});
  };
  const Summary dies = with(1.2e4), slides = with(1e4), rolls = with(9510);
  EXPECT_EQ(dies.outcome, Outcome::freed);
  EXPECT_EQ(slides.outcome, Outcome::sliding);
  EXPECT_EQ(rolls.outcome, Outcome::rolling);
}

TEST(Audit, ACollisionMayBeShorterThanThatOfAFreeSpringAndDashpot) {
  const Scenario scenario{.parameters = {.friction = 0.0525}};
  EventRecorder events;
  run(scenario, events);
  double shortest = 1, touch_down = 0;
  for (const Instant& at : events.events()) {
    if (at.event == Event::touch_down) touch_down = at.time_s;
    if (at.event == Event::release && touch_down > 0)
      shortest = std::min(shortest, at.time_s - touch_down);
  }
  const Parameters& p = scenario.parameters;
  const double w_0 = std::sqrt(p.contact_stiffness / p.mass);
  const double zeta = p.contact_damping / (2 * std::sqrt(p.contact_stiffness * p.mass));
  const double free_impact = 2 * std::acos(zeta) / (w_0 * std::sqrt(1 - zeta * zeta));
  EXPECT_NEAR(free_impact, 2.366e-4, 0.001e-4);
  EXPECT_NEAR(shortest, 1.49e-4, 0.005e-4);
}

TEST(Audit, ANanometreOfClearanceChangesTheTouchDownsAtLowFrictionAndTheFinalSpeedByLittle) {
  Scenario scenario{.parameters = {.friction = 0.08}};
  const Summary printed = summary_of(scenario);
  scenario.parameters.stator_radius += 1e-9;
  const Summary wider = summary_of(scenario);
  EXPECT_EQ(printed.collisions, 41);
  EXPECT_EQ(wider.collisions, 40);
  EXPECT_NEAR(wider.final_speed_Hz / printed.final_speed_Hz, 1 - 0.003, 0.0005);
}

}  // namespace
}  // namespace rotor
