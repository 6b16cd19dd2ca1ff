/// What the digits of a run are told by: that nothing is the same in all computations, where these
/// agree, and of what the digits of a value are counted.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "figures/scenes/certain_account.hpp"
#include "model/simulation/extended/comparison.ipp"
#include "model/simulation/extended/computation.hpp"
#include "model/simulation/extended/digits.hpp"
#include "model/simulation/extended/values.hpp"
#include "model/simulation/simulation.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

// A number that is not disturbed is rounded alike in all computations.
TEST(DisturbedComputation, HasEachNumberOffByTheShareAndNotAllInOneDirection) {
  const Scenario scenario = short_run(0.01);
  const double share = 1e-3;
  const RotorSystem<double> rotor(scenario.parameters, scenario.equations);
  const Instant start = start_of<double>(scenario);
  const MassLoss<double> loss(scenario.parameters);
  RotorSystem<double> off_rotor = rotor;
  Instant off_start = start;
  MassLoss<double> off_loss = loss;
  Disturbance<double>{share, 0x135a8f}.disturb(off_rotor, off_start, off_loss);
  const std::pair<double, double> numbers[] = {
      {rotor.supports.stiffness, off_rotor.supports.stiffness},
      {rotor.supports.damping, off_rotor.supports.damping},
      {rotor.supports.gravity, off_rotor.supports.gravity},
      {rotor.supports.torque, off_rotor.supports.torque},
      {rotor.ring.clearance, off_rotor.ring.clearance},
      {rotor.ring.rotor_radius, off_rotor.ring.rotor_radius},
      {rotor.ring.stiffness, off_rotor.ring.stiffness},
      {rotor.ring.damping, off_rotor.ring.damping},
      {rotor.ring.friction, off_rotor.ring.friction},
      {rotor.motor_off, off_rotor.motor_off},
      {start.state[0], off_start.state[0]},
      {start.state[1], off_start.state[1]},
      {start.state[5], off_start.state[5]},
      {start.body.mass, off_start.body.mass},
      {start.body.inertia, off_start.body.inertia},
      {start.body.eccentricity, off_start.body.eccentricity},
      {loss.lost_mass, off_loss.lost_mass},
      {loss.piece_distance, off_loss.piece_distance},
      {loss.after.mass, off_loss.after.mass},
      {loss.after.inertia, off_loss.after.inertia},
      {loss.after.eccentricity, off_loss.after.eccentricity}};
  int raised = 0;
  for (const auto& [number, off] : numbers) {
    EXPECT_NEAR(std::abs(off / number - 1), share, 1e-12) << &number - &numbers[0].first;
    raised += std::abs(off) > std::abs(number);
  }
  EXPECT_GT(raised, 5);
  EXPECT_LT(raised, 16);
}

TEST(DisturbedComputation, BeginsWithTheShareOfAStepThatItIsTold) {
  // So short a run is one step, unless that begins with less.
  const Scenario scenario = short_run(1e-3);
  const auto usual = compute<double>(scenario, {.tolerance = 1e-6}, always);
  const auto shorter = compute<double>(scenario, {.tolerance = 1e-6, .first_steps = 1e-2}, always);
  EXPECT_GT(shorter.counters.steps, usual.counters.steps);
}

// Small differences and components are as uncertain as what they are made of.
TEST(Computations, AgreeIfTheyHaveAllEventsInCommonAndEndAlike) {
  const Scenario scenario = short_run(0.02);
  const auto run = compute<double>(scenario, {.tolerance = 1e-6}, always);
  ASSERT_GT(run.events.size(), 3U);
  EXPECT_TRUE(agree(run, run));
  const auto others = [&](const auto& change) {
    auto other = run;
    change(other);
    EXPECT_FALSE(agree(run, other));
    EXPECT_FALSE(agree(other, run));
    return common_events(run, other);
  };
  EXPECT_EQ(others([](auto& other) { other.events.push_back(other.events.back()); }),
            run.events.size());
  EXPECT_EQ(others([](auto& other) { other.events[1].event = Event::motor_off; }), 1U);
  EXPECT_EQ(others([](auto& other) { other.events[2].contact = ContactState::rolling; }), 2U);
  others([](auto& other) { other.end.contact = ContactState::rolling; });
  others([](auto& other) { other.summary.outcome = Outcome::stalled; });
}

// Of a run that ends between the instants which two computations find for an event.
TEST(Comparisons, KnowACourseOnlyIfAllComputationsTakeIt) {
  using Fehlberg = Fehlberg78<std::array<double, 6>, double>;
  const double tolerance = 1e-4;
  const auto coarse = [&](const Scenario& scenario) {
    return compute<double>(scenario, {tolerance}, always);
  };
  const auto finest = [&](const Scenario& scenario) {
    return compute<double>(scenario, {tolerance / Comparison::finest, 3. / 8}, always);
  };
  const auto other = [&](const Scenario& scenario) {
    const Settings<double> settings{tolerance / Comparison::other, 5. / 8,
                                    disturbances<double>().back()};
    return compute<double, Fehlberg>(scenario, settings, always);
  };
  Scenario scenario = short_run(0.04);
  const auto early = coarse(scenario).events, exact = finest(scenario).events;
  int coarse_alone = 0;
  for (std::size_t n = 0; n < std::min(early.size(), exact.size()); ++n) {
    scenario.until = 0.9 * early[n].time_s + 0.1 * exact[n].time_s;
    if (agree(finest(scenario), coarse(scenario))) continue;
    coarse_alone += agree(finest(scenario), other(scenario));
    const auto found = compare<double>(scenario, tolerance, always);
    EXPECT_FALSE(found->same_course) << n;
    EXPECT_LE(found->events.size(), common_events(finest(scenario), coarse(scenario)) + 1) << n;
    EXPECT_LE(found->events.size(), common_events(finest(scenario), other(scenario)) + 1) << n;
  }
  EXPECT_GT(coarse_alone, 5);
}

// What is printed of a value is rounded to double precision.
TEST(Estimates, HaveTheRoundingOfWhatIsPrintedInTheirError) {
  NamedValue<long double> third{.name = "third", .value = 1.0L / 3};
  const double rounding = static_cast<double>(std::abs(*third.value - 1. / 3));
  ASSERT_GT(rounding, 0);
  const auto error = [&] { return estimate(third, third, third, third, 0).estimate->error; };
  EXPECT_GE(error(), rounding);
  EXPECT_LT(error(), 1.5 * rounding);
  third.is_exact = true;
  EXPECT_EQ(error(), rounding);
}

// A value that not all computations have is known to nobody, whichever lacks it.
TEST(Estimates, HaveAnInfiniteErrorWhereAComputationLacksTheValue) {
  const NamedValue<double> known{.name = "speed", .value = 1.0};
  const NamedValue<double> missing{.name = "speed", .value = std::nullopt};
  EXPECT_LT(estimate(known, known, known, known, 0).estimate->error, 1e-12);
  for (const auto& [coarse, disturbed, other] :
       {std::tuple(missing, known, known), {known, missing, known}, {known, known, missing}})
    EXPECT_EQ(estimate(known, coarse, disturbed, other, 0).estimate->error,
              std::numeric_limits<double>::infinity());
  EXPECT_FALSE(estimate(missing, known, known, known, 0).estimate.has_value());
}

/// When q1 changes its sign: it is next to nothing of the displacement then.
double time_of_vanishing_q1(const Scenario& scenario) {
  double time_s = 0;
  MotionObserver look(0, scenario.until, [&](const DenseOutput& motion) {
    double from_s = motion.from_s, until_s = motion.until_s;
    const auto is_positive = [&](double t) { return motion.at(t).state[0] > 0; };
    if (time_s > 0 || is_positive(from_s) == is_positive(until_s)) return;
    for (int halves = 0; halves < 30; ++halves) {
      const double middle_s = (from_s + until_s) / 2;
      (is_positive(middle_s) == is_positive(from_s) ? from_s : until_s) = middle_s;
    }
    time_s = from_s;
  });
  run(scenario, look);
  return time_s;
}

// Of a run to a finer tolerance, in steps of other lengths, with other roundings. A component that
// is next to nothing is as wrong as its vector.
TEST(EstimatedError, IsSoManyTimesTheDistanceOfAFinerRun) {
  const double vanishing_s = time_of_vanishing_q1(short_run(0.02));
  ASSERT_GT(vanishing_s, 0);
  for (const auto& [tolerance, until_s] :
       {std::pair(1e-4, 0.02), {1e-6, 0.02}, {1e-8, 0.02}, {1e-8, vanishing_s}}) {
    Scenario scenario = short_run(until_s);
    scenario.tolerance = tolerance;
    SummaryObserver observer(scenario);
    run(scenario, observer);
    const auto finer = compute<double>(
        scenario, {tolerance / 100, 0.375, Disturbance<double>{8 * 0x1p-52, 0x135a8f}}, always);
    const auto ours = values_of(observer.summary(), scenario.parameters),
               theirs = values_of(finer.summary, scenario.parameters);
    double largest = 0;
    for (std::size_t i = 0; i < ours.size(); ++i)
      if (const auto value = ours[i].value)
        largest = std::max(largest, std::abs(*value - *theirs[i].value) /
                                        std::max(std::abs(*value), ours[i].size));
    const double estimate = estimated_relative_error(scenario, observer.summary(), always);
    EXPECT_NEAR(estimate, 20 * largest, 1e-9 * estimate) << tolerance;
    EXPECT_LT(estimate, 1e4 * tolerance);
  }
}

// A run with another number of touch-downs, or another outcome, is another one altogether.
TEST(EstimatedError, IsThatOfTheWholeWhereTheCourseDiffers) {
  const Scenario scenario = short_run(0.02);
  SummaryObserver observer(scenario);
  run(scenario, observer);
  const Summary summary = observer.summary();
  EXPECT_LT(estimated_relative_error(scenario, summary, always), 1e-3);
  Summary other = summary;
  ++other.collisions;
  EXPECT_EQ(estimated_relative_error(scenario, other, always), 1);
  other = summary;
  other.outcome = Outcome::stalled;
  EXPECT_EQ(estimated_relative_error(scenario, other, always), 1);
}

TEST(SizesOfValues, AreThoseOfWhatTheyAreMadeOf) {
  const Scenario scenario = short_run(0.02);
  auto run = compute<double>(scenario, {.tolerance = 1e-9}, always);
  run.summary.contact_time_s = 1e-3;
  run.summary.whirl_frequency_Hz = -700;
  run.summary.whirl_from_s = 0.01;
  run.summary.whirl_until_s = 0.0101;
  const auto all = values_of(run.summary, scenario.parameters);
  const auto named = [&](std::string_view name) {
    return *std::ranges::find(all, name, &NamedValue<double>::name);
  };
  EXPECT_DOUBLE_EQ(named("contact_time_s").made_of, 0.02);
  EXPECT_NEAR(named("whirl_frequency_Hz").made_of, 700 * 0.0101 / 1e-4, 1e-6);
  const double rho = std::hypot(run.end.state[0], run.end.state[1]);
  const double negligible = 1e-6 * 3e-3;  // a millionth of the clearance
  for (const char* component : {"final_q1_m", "final_q2_m"}) {
    EXPECT_DOUBLE_EQ(named(component).made_of, rho) << component;
    EXPECT_NEAR(named(component).size, negligible, 1e-15) << component;
  }
  EXPECT_NEAR(named("peak_bearing_force_N").size, 2e4 * negligible, 1e-9);
  EXPECT_EQ(named("final_speed_Hz").size, 0);
  EXPECT_TRUE(named("final_time_s").is_exact);
  EXPECT_FALSE(named("critical_speed_Hz").is_exact);
}

TEST(SizesOfValues, OfAVelocityAreThoseInTheStator) {
  const auto run = compute<double>(short_run(0.02), {.tolerance = 1e-9}, always);
  const auto all = values_of(run.end, 3e-3);
  ASSERT_EQ(all[4].name, "q1_rate_m_per_s");
  EXPECT_DOUBLE_EQ(all[4].size, run.end.motion().velocity.norm());
  EXPECT_DOUBLE_EQ(all[1].size, run.end.motion().displacement.norm());
  EXPECT_TRUE(all[0].is_exact);  // the end is stated
  for (const Instant& event : run.events)
    EXPECT_EQ(values_of(event, 3e-3)[0].is_exact, event.event == Event::mass_loss);
  Instant resting;  // in the stator's middle
  resting.state[5] = 900;
  EXPECT_DOUBLE_EQ(values_of(resting, 3e-3)[4].size, 3e-9 * 900);
  EXPECT_DOUBLE_EQ(values_of(resting, 3e-3)[3].size, 1e-6);  // of an angle: a millionth of 1 rad
}

TEST(SureDigits, AreThoseThatTheErrorIsLessThanHalfOf) {
  const auto of = [](double value, double error) {
    return sure_digits({.name = "", .estimate = Estimate{value, error}, .size = std::abs(value)});
  };
  EXPECT_EQ(of(2, 0.9e-3), 3);
  EXPECT_EQ(of(2, 1.1e-3), 2);
  EXPECT_EQ(of(2, 1.2), 0);
  EXPECT_EQ(of(-5, 0), most_digits);
}

// Relative to the clearance, and to the velocity that the rotation makes of it.
TEST(Distance, OfTwoInstantsIsThatOfPlacesAndOfVelocities) {
  const double clearance = 3e-3, speed = 99;
  Instant here, apart, faster;
  here.state = apart.state = faster.state = {0, 0, 0, 0, 0, speed};
  apart.state[0] = clearance;
  apart.state[4] = -speed * clearance;  // it stands still, too
  faster.state[3] = 100 * clearance;
  EXPECT_NEAR(distance(here, apart, clearance), 1, 1e-12);
  EXPECT_NEAR(distance(here, faster, clearance), 1, 1e-12);
}

// What has parted is compared where it was together for the last time, whichever is the shorter.
TEST(Amplification, IsToTheLastCommonEventWhereOneRunHasFewer) {
  const Scenario scenario = short_run(0.03);
  const auto run = compute<double>(scenario, {.tolerance = 1e-9}, always);
  auto shorter = compute<double>(scenario, {.tolerance = 1e-7}, always);
  const auto whole = amplification(run, shorter, 3e-3);
  shorter.events.pop_back();
  shorter.end.state[0] += 1;  // elsewhere
  const auto first = amplification(run, shorter, 3e-3), second = amplification(shorter, run, 3e-3);
  ASSERT_TRUE(whole && first && second);
  EXPECT_NEAR(*second / *first, 1, 1e-3);
  EXPECT_LT(*second, 1e3 * *whole);
}

}  // namespace
}  // namespace rotor
