/// What the digits of a run are told by: that nothing is the same in all computations, of what the
/// digits of a value are counted, and what would change the course if it were a little different.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "figures/scenes/certain_account.hpp"
#include "model/simulation/extended/comparison.ipp"
#include "model/simulation/extended/computation.hpp"
#include "model/simulation/extended/digits.hpp"
#include "model/simulation/extended/values.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

const GoesOn always = [](double /*time_s*/) { return true; };

/// From steady motion through the mass loss into contact, and out of it.
Scenario short_run(double until_s) {
  Scenario scenario{.equations = Equations::published, .start_speed_Hz = 150.5, .until = until_s};
  scenario.parameters.separation_time = 1e-3;
  scenario.parameters.motor_off_Hz = 151;
  return scenario;
}

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
TEST(SizesOfValues, AreThoseOfWhatTheyAreMadeOf) {
  const Scenario scenario = short_run(0.02);
  auto run = compute<double>(scenario, {.tolerance = 1e-9}, always);
  run.summary.contact_time_s = 1e-3;
  run.summary.whirl_frequency_Hz = -700;
  run.summary.whirl_from_s = 0.01;
  run.summary.whirl_until_s = 0.0101;
  const auto all = values_of(run, scenario);
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

/// The margins of a name, which come in the order of the run.
std::vector<double> margins_of(const Comparison& found, std::string_view name) {
  std::vector<double> all;
  for (const NamedEstimate& margin : found.margins)
    if (margin.name == name && margin.estimate) all.push_back(margin.estimate->value);
  return all;
}

TEST(Margins, AreTakenWhereTheCourseCouldHaveBeenAnother) {
  const Scenario scenario = short_run(0.02);
  const auto found = compare<double>(scenario, 1e-10, always);
  ASSERT_TRUE(found && found->same_course);
  EventRecorder recorder;
  const RunEnd end = run(scenario, recorder);
  const Ring<double> ring(scenario.parameters);
  const double clearance = 3e-3;
  const Instant loss = recorder.first(Event::mass_loss);
  const auto touches = recorder.events(Event::touch_down);
  ASSERT_GE(touches.size(), 1U);
  // How hard it touches down,
  const auto hits = margins_of(*found, "touch");
  ASSERT_EQ(hits.size(), touches.size());
  for (std::size_t i = 0; i < hits.size(); ++i)
    EXPECT_NEAR(hits[i], ring.rim_point(touches[i].motion()).normal_velocity, 1e-6 * hits[i]);
  // and at the mass loss and in the end, how far it is from the ring, and from the motor's limit.
  const auto gap = [&](const Instant& at) {
    return std::abs(clearance - at.motion().displacement.norm());
  };
  const auto gaps = margins_of(*found, "gap");
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_NEAR(gaps[0], gap(loss), 1e-9 * clearance);
  EXPECT_NEAR(gaps[1], gap(end.last), 1e-6 * clearance);
  const auto speeds = margins_of(*found, "speed");
  ASSERT_EQ(speeds.size(), end.last.motor_on ? 2U : 1U);
  EXPECT_NEAR(speeds[0], 2 * std::numbers::pi * 151 - loss.motion().speed, 1e-6);
}

TEST(Margins, AreThoseOfFlightsThatNearlyTouch) {
  // As wide as what it reaches, and a little more.
  Scenario scenario = short_run(0.03);
  scenario.parameters.stator_radius = 0.1;
  const auto wide = compare<double>(scenario, 1e-10, always);
  const double reached = wide->values.max_displacement_m.value();
  scenario.parameters.stator_radius = scenario.parameters.rotor_radius + 1.01 * reached;
  const auto found = compare<double>(scenario, 1e-10, always);
  ASSERT_TRUE(found && found->same_course);
  ASSERT_EQ(found->values.collisions, 0);
  const auto misses = margins_of(*found, "miss");
  ASSERT_EQ(misses.size(), 1U);
  EXPECT_NEAR(misses[0], 0.01 * reached, 1e-6 * reached);
  // In the end it is still free, and reaches less than the clearance.
  const auto reaches = margins_of(*found, "reach");
  ASSERT_EQ(reaches.size(), 1U);
  EXPECT_LT(reaches[0], 1.01 * reached);
}

// In sliding, at the end: how fast the rim slips.
TEST(Margins, AreThoseOfSlipInTheEnd) {
  Scenario scenario = short_run(0.02);
  EventRecorder recorder;
  run(scenario, recorder);
  scenario.until = recorder.first(Event::touch_down).time_s + 1e-5;
  const auto found = compare<double>(scenario, 1e-10, always);
  ASSERT_TRUE(found && found->end.last.contact == ContactState::sliding);
  const auto slips = margins_of(*found, "slip");
  ASSERT_EQ(slips.size(), 1U);
  const Ring<double> ring(scenario.parameters);
  const double slip = ring.rim_point(found->end.last.motion()).slip_velocity;
  EXPECT_NEAR(slips[0], std::abs(slip), 1e-6 * std::abs(slip));
  EXPECT_TRUE(margins_of(*found, "reach").empty());  // it has come as far as the ring
}

// A course hangs on a margin that may be none; one that only some computations take for near is
// none.
TEST(Margins, MakeACourseUnsureOnceTheirErrorReachesThem) {
  Comparison comparison;
  comparison.same_course = true;
  EXPECT_TRUE(comparison.is_course_sure());
  const auto is_sure = [&](double value, double error) {
    comparison.margins = {{.name = "miss", .estimate = Estimate{value, error}}, {.name = "gap"}};
    return comparison.is_course_sure();
  };
  EXPECT_TRUE(is_sure(1e-6, 0.9e-6));
  EXPECT_FALSE(is_sure(1e-6, 1e-6));
  EXPECT_FALSE(is_sure(-1e-6, 1e-9));
  EXPECT_TRUE(is_sure(1e-6, std::numeric_limits<double>::infinity()));
  comparison.margins.clear();
  comparison.same_course = false;
  EXPECT_FALSE(comparison.is_course_sure());
}

TEST(UnsureCourse, LeavesOnlyWhatIsStatedWithDigits) {
  const Scenario scenario = short_run(0.02);
  auto found = compare<double>(scenario, 1e-10, always);
  ASSERT_TRUE(found && has_digits(*found, 3));
  EXPECT_EQ(complaint(*found, 3), "");
  const auto without = [&](int values) {
    Comparison lacking = *found;
    for (NamedEstimate& value : lacking.summary)
      if (value.estimate && value.estimate->error > 0 && values-- > 0)
        value.estimate->error = 0.2e-2 * value.size;
    return complaint(lacking, 3);
  };
  EXPECT_TRUE(without(1).starts_with("first_contact_s has 2 of 3 digits")) << without(1);
  EXPECT_EQ(without(1).find("more"), std::string::npos) << without(1);
  EXPECT_NE(without(3).find(", and 2 more have too few"), std::string::npos) << without(3);
  found->margins.front() = {.name = "miss", .estimate = Estimate{1, 2}};
  EXPECT_FALSE(has_digits(*found, 3));
  EXPECT_TRUE(complaint(*found, 3).starts_with(
      "counts and outcome hang on digits that are not there: a glancing contact, "
      "or what comes next at the mass loss or in the end, is closer than its "
      "error"))
      << complaint(*found, 3);
  Comparison other = *found;
  other.same_course = false;
  EXPECT_NE(complaint(other, 3).find(
                fmt::format("computations agree on the first {} events", found->events.size() - 1)),
            std::string::npos)
      << complaint(other, 3);
  EXPECT_GT(to_json(*found, scenario, 3)["estimated_relative_error"], 0);
  found->forget_what_hangs_on_the_course();
  EXPECT_TRUE(to_json(*found, scenario, 3)["estimated_relative_error"].is_null());
  long forgotten = 0;
  for (const EventEstimate& event : found->events)
    for (const NamedEstimate& value : event.values) {
      EXPECT_TRUE(sure_digits(value) == 0 || value.of_tolerance == 0) << value.name;
      forgotten += sure_digits(value) == 0;
    }
  EXPECT_GT(forgotten, 10);
  for (const NamedEstimate& value : found->summary) {
    if (!value.estimate) continue;
    EXPECT_EQ(sure_digits(value) == 0, value.name != "final_time_s") << value.name;
  }
}

}  // namespace
}  // namespace rotor
