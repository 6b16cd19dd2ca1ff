/// What would change the course of a run if it were a little different: no digit of such a run is
/// sure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figures/scenes/certain_account.hpp"
#include "model/simulation/extended/comparison.ipp"
#include "model/simulation/extended/digits.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

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
