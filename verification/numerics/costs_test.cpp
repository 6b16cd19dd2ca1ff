/// Limits of the cost of runs, in evaluations: unlike times they are the same on all machines. One
/// takes some 300 instructions, and twice as many where the synchronous motion is subtracted, so
/// that more of them can be worth less: a limit may rise if valgrind counts fewer instructions at
/// the same error.
#include <gtest/gtest.h>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/instant.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

/// The limits for a run. Compilers round differently, which shifts some steps.
struct Cost {
  const char* name;
  double friction, mass_loss_s, until_s;
  long right_hand_sides, contact_evaluations, events;
};

void PrintTo(const Cost& cost, std::ostream* out) { *out << cost.name; }

class Costs : public testing::TestWithParam<Cost> {};

TEST_P(Costs, AreNoHigherThanTheyWere) {
  const Cost& cost = GetParam();
  const Scenario scenario{
      .parameters = {.friction = cost.friction, .mass_loss_time = cost.mass_loss_s},
      .equations = Equations::published,
      .until = cost.until_s};
  Simulation simulation(scenario);
  if (scenario.loses_mass()) simulation.run_up(cost.mass_loss_s, nobody);  // counted from there
  const Counters before = simulation.counters();
  simulation.run_to_end(nobody);
  const Counters& now = simulation.counters();
  constexpr double compilers = 1.01;
  EXPECT_LE(now.right_hand_sides - before.right_hand_sides,
            compilers * static_cast<double>(cost.right_hand_sides));
  EXPECT_LE(now.contact_evaluations - before.contact_evaluations,
            compilers * static_cast<double>(cost.contact_evaluations));
  EXPECT_EQ(now.located_events - before.located_events, cost.events);
}

INSTANTIATE_TEST_SUITE_P(
    OfScenes, Costs,
    testing::Values(Cost{"run-up", 0.3, 99, 29.1, 35188, 0, 1},
                    Cost{"rub at mu = 0.3", 0.3, 29.1, 29.2, 17399, 16778, 20},
                    Cost{"rub at mu = 0.2", 0.2, 29.1, 29.35, 39505, 38359, 35},
                    Cost{"rub at mu = 0.08", 0.08, 29.1, 29.35, 23457, 19030, 121},
                    Cost{"no contact", 0.3, 9.4, 10.4, 5668, 0, 0}));

// 13,600 rad of rotation: with steps that followed it, the numbers were 55,000 and 130,000.
TEST(Costs, OfARunUpFollowItsSlowMotionAlone) {
  for (const Equations equations : {Equations::published, Equations::corrected})
    for (const auto& [tolerance, most] : {std::pair(1e-8, 20'000), std::pair(1e-11, 40'000)}) {
      Scenario scenario{.equations = equations, .until = 29.1, .tolerance = tolerance};
      scenario.parameters.loses_mass = false;
      EXPECT_LT(run(scenario, nobody).counters.right_hand_sides, most);
    }
}

TEST(Costs, DoNotFollowTheClockWhereNothingMoves) {
  Scenario scenario{.until = 1e12};
  scenario.parameters.eccentricity = scenario.parameters.gravity = scenario.parameters.torque = 0;
  SummaryObserver summary(scenario);
  EXPECT_LT(run(scenario, summary).counters.right_hand_sides, 2000);
}

TEST(Costs, OfASummaryAreLittleBesideThoseOfTheRun) {
  const Scenario scenario{.until = 29.2, .tolerance = 1e-8};
  SummaryObserver summary(scenario);
  Simulation run_up(scenario);
  run_up.run_up(29.1, nobody);
  const auto right_hand_sides = [&](Observer& observer) {
    Simulation simulation = run_up;
    simulation.run_to_end(observer);
    return simulation.counters().right_hand_sides - run_up.counters().right_hand_sides;
  };
  EXPECT_LT(static_cast<double>(right_hand_sides(summary)),
            1.12 * static_cast<double>(right_hand_sides(nobody)));
}

}  // namespace
}  // namespace rotor
