/// What runs may cost.
#include <gtest/gtest.h>

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/start.hpp"
#include "verification/support/sines.hpp"

namespace rotor {
namespace {

/// What a run may cost. Compilers round differently, which shifts a step here and there.
struct Cost {
  const char* name;
  double friction, mass_loss_s, until_s;
  long right_hand_sides, contact_evaluations, events, pairs;  ///< of sine and cosine
};

void PrintTo(const Cost& cost, std::ostream* out) { *out << cost.name; }

class Costs : public testing::TestWithParam<Cost> {};

TEST_P(Costs, AreNoHigherThanTheyWere) {
  const Cost& cost = GetParam();
  const Scenario scenario{
      .parameters = {.friction = cost.friction, .mass_loss_time = cost.mass_loss_s},
      .until = cost.until_s};
  Observer null_observer;
  Simulation simulation(scenario);
  if (scenario.loses_mass())
    simulation.run_up(cost.mass_loss_s, null_observer);  // counted from there
  const Counters before = simulation.counters();
  const long pairs_before = sine_cosine_pairs();
  simulation.finish(null_observer);
  const Counters counted = simulation.counters() - before;
  constexpr double compilers = 1.01, merging = 1.08;  // of equal sines
  EXPECT_LE(counted.right_hand_sides, compilers * static_cast<double>(cost.right_hand_sides));
  EXPECT_LE(counted.contact_evaluations, compilers * static_cast<double>(cost.contact_evaluations));
  EXPECT_LE(sine_cosine_pairs() - pairs_before, merging * static_cast<double>(cost.pairs));
  EXPECT_EQ(counted.located_events, cost.events);
}

INSTANTIATE_TEST_SUITE_P(
    OfScenes, Costs,
    testing::Values(Cost{"run-up", 0.3, 99, 29.1, 34808, 0, 1, 36019},
                    Cost{"rub at mu = 0.3", 0.3, 29.1, 29.2, 17842, 16909, 20, 37995},
                    Cost{"rub at mu = 0.2", 0.2, 29.1, 29.35, 40317, 38623, 35, 85887},
                    Cost{"rub at mu = 0.08", 0.08, 29.1, 29.35, 25839, 19876, 121, 52650},
                    Cost{"no contact", 0.3, 9.4, 10.4, 5563, 0, 0, 5648}));

// 13,600 rad of rotation: steps that followed it took 55,000 and 130,000.
TEST(Costs, OfARunUpFollowItsSlowMotionAlone) {
  for (const Equations equations : {Equations::published, Equations::consistent})
    for (const auto& [tolerance, most] : {std::pair(1e-8, 20'000), std::pair(1e-11, 40'000)}) {
      Scenario scenario{.equations = equations, .until = 29.1, .tolerance = tolerance};
      scenario.parameters.loses_mass = false;
      Observer null_observer;
      EXPECT_LT(run(scenario, null_observer).counters.right_hand_sides, most);
    }
}

TEST(Costs, DoNotFollowTheClockWhereNothingMoves) {
  Scenario scenario{.until = 1e12};
  scenario.parameters.eccentricity = scenario.parameters.gravity = scenario.parameters.torque = 0;
  SummaryObserver summary(scenario);
  EXPECT_LT(run(scenario, summary).counters.right_hand_sides, 2000);
}

// In steady response without damping and gravity O stays on a circle: its distance changes by
// rounding alone, which has no maxima that are worth a search.
TEST(Costs, OfASummaryAreNotThoseOfRoundingsMaxima) {
  Scenario scenario{.start_speed_Hz = 187, .until = 0.04};
  Parameters& p = scenario.parameters;
  p.support_damping = p.gravity = p.torque = 0;
  p.loses_mass = false;
  Observer null_observer;
  SummaryObserver summary(scenario);
  const auto pairs = [&](Observer& observer) {
    const long before = sine_cosine_pairs();
    run(scenario, observer);
    return sine_cosine_pairs() - before;
  };
  const long few = pairs(null_observer);
  EXPECT_LT(pairs(summary), 20 * few);
  const double radius = start_of(scenario).motion().displacement.norm();
  EXPECT_NEAR(summary.summary().max_displacement_before_loss_m / radius, 1, 1e-14);
}

// Where the rotor is a million times as large as its clearance, the velocity of O is a rounding of
// the rim's. Without friction a contact does not depend on the rim's, and neither do its steps,
// however small the tolerance is.
TEST(Costs, OfAContactAreThoseOfItsMotionAndNotOfRounding) {
  const auto steps = [](double radius, double tolerance) {
    const Scenario scenario{.parameters = {.mass = 1.676,
                                           .inertia = 0.095,
                                           .eccentricity = 9.5758e-8,
                                           .support_stiffness = 935867,
                                           .support_damping = 184.7,
                                           .torque = 237.9,
                                           .motor_off_Hz = 1807,
                                           .contact_stiffness = 1.977e8,
                                           .contact_damping = 104870,
                                           .friction = 0,
                                           .rotor_radius = radius,
                                           .stator_radius = radius + 1e-7,
                                           .unbalance_factor = 1.02077,
                                           .mass_loss_time = 0},
                            .equations = Equations::consistent,
                            .start_speed_Hz = 602.39,
                            .until = 0.00069,
                            .tolerance = tolerance};
    SummaryObserver summary(scenario);
    const RunEnd end = run(scenario, summary);
    EXPECT_EQ(summary.summary().touch_downs, 1);
    return end.counters.steps;
  };
  for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11, 1e-13})
    for (const double radius : {1e-4, 1e-2, 1., 10.})
      EXPECT_LE(steps(radius, tolerance), 40) << radius << ' ' << tolerance;
}

TEST(Costs, OfASummaryAreLittleBesideThoseOfTheRun) {
  const Scenario scenario{.until = 29.2, .tolerance = 1e-8};
  Observer null_observer;
  SummaryObserver summary(scenario);
  Simulation run_up(scenario);
  run_up.run_up(29.1, null_observer);
  const auto right_hand_sides = [&](Observer& observer) {
    Simulation simulation = run_up;
    simulation.finish(observer);
    return (simulation.counters() - run_up.counters()).right_hand_sides;
  };
  EXPECT_LT(static_cast<double>(right_hand_sides(summary)),
            1.1 * static_cast<double>(right_hand_sides(null_observer)));
}

}  // namespace
}  // namespace rotor
