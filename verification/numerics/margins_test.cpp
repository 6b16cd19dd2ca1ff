/// What would change the course of a run if it were a little different: no digit of such a run is
/// sure.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "figures/scenes/certain_account.hpp"
#include "figures/scenes/columns.hpp"
#include "figures/scenes/names.hpp"
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

/// What has to stay positive for a rotor to stay in its state of contact: clearance^2 - rho^2, or
/// F_n and the slip, or F_n and what friction can do beyond what holds the rim, or the indentation
/// and the force that the ring lacks; and how far the motor is from its limit.
std::vector<double> reserves(const Scenario& scenario, const Instant& at) {
  const Parameters& p = scenario.parameters;
  const Motion<double> m = at.motion();
  const double clearance = p.stator_radius - p.rotor_radius, rho = m.displacement.norm();
  const auto k = Ring<double>(p).rim_point(m);
  const double force = p.contact_stiffness * k.indentation + p.contact_damping * k.normal_velocity;
  const double motor =
      at.motor_on ? 2 * std::numbers::pi * p.motor_off_Hz - m.speed : 1;  // off for good
  switch (at.contact) {
    case ContactState::free:
      return {clearance * clearance - rho * rho, motor};
    case ContactState::indented:
      return {k.indentation, -force, motor};
    case ContactState::sliding:
      return {force, std::abs(k.slip_velocity), motor};
    default: {
      const ColumnContext context(scenario);
      const double friction = View(at, context).friction();  // that holds the rim
      return {force, p.friction * p.friction * force * force - friction * friction, motor};
    }
  }
}

/// Those of a run are how hard it touches down, and what is left before the next event at the mass
/// loss, on both sides, and in the end.
void expect_margins(const Scenario& scenario, const EventRecorder& recorder) {
  const auto found = compare<double>(scenario, 1e-10, always);
  ASSERT_TRUE(found && found->same_course);
  const auto hits = margins_of(*found, "touch"), left = margins_of(*found, "reserve");
  const auto touches = recorder.events(Event::touch_down);
  ASSERT_EQ(hits.size(), touches.size());
  const Ring<double> ring(scenario.parameters);
  for (std::size_t i = 0; i < hits.size(); ++i)
    EXPECT_NEAR(hits[i], ring.rim_point(touches[i].motion()).normal_velocity, 1e-6 * hits[i]);
  std::vector<double> expected;
  for (const Instant& at :
       {recorder.before_mass_loss(), recorder.first(Event::mass_loss), recorder.last()})
    for (const double reserve : reserves(scenario, at)) expected.push_back(reserve);
  ASSERT_EQ(left.size(), expected.size());
  for (std::size_t i = 0; i < left.size(); ++i) EXPECT_NEAR(left[i] / expected[i], 1, 1e-5) << i;
}

TEST(Margins, AreTakenWhereTheCourseCouldHaveBeenAnother) {
  Scenario scenario = short_run(0.03);
  EventRecorder whole;
  run(scenario, whole);
  std::set<ContactState> ends;
  for (std::size_t n = 0; n < whole.events().size(); ++n) {
    const Instant& from = whole.events()[n];
    if (!ends.insert(from.contact).second) continue;
    const bool is_last = n + 1 == whole.events().size();
    scenario.until = (from.time_s + (is_last ? 0.03 : whole.events()[n + 1].time_s)) / 2;
    EventRecorder recorder;
    run(scenario, recorder);
    SCOPED_TRACE(n);
    expect_margins(scenario, recorder);
  }
  EXPECT_EQ(ends.size(), 4U);
}

// A loss in rolling changes what is left; from it the rim slides to either side.
TEST(Margins, AreThoseOfBothSidesOfALossInContact) {
  Scenario scenario{.equations = Equations::published};
  Parameters& p = scenario.parameters;
  p.stator_radius = p.rotor_radius + 1e-3;
  p.friction = 0.8;
  int forward = 0, backward = 0;
  for (const double loss_s : {2.4, 2.4025, 2.405, 2.4075}) {
    p.separation_time = loss_s;
    scenario.until = loss_s + 1e-6;
    EventRecorder recorder;
    run(scenario, recorder);
    ASSERT_EQ(recorder.before_mass_loss().contact, ContactState::rolling);
    const Instant& after = recorder.first(Event::mass_loss);
    if (after.contact == ContactState::sliding)
      ++(Ring<double>(p).rim_point(after.motion()).slip_velocity > 0 ? forward : backward);
    SCOPED_TRACE(loss_s);
    expect_margins(scenario, recorder);
  }
  EXPECT_GT(forward, 0);
  EXPECT_GT(backward, 0);
}

// Each computation still touches the ring, but none knows for how long.
TEST(Margins, TellThatARunEndsTooShortlyBeforeItsNextEvent) {
  Scenario scenario = short_run(0.03);
  EventRecorder recorder;
  run(scenario, recorder);
  for (const Event event :
       {Event::touch_down, Event::release, Event::ring_clear, Event::rolling_onset}) {
    ASSERT_GT(recorder.count(event), 0) << name_of(event);
    const double event_s = recorder.first(event).time_s;
    double left_s = 1e-7;
    std::optional<Comparison> found;
    do {
      left_s /= 2;
      scenario.until = event_s - left_s;
      found = compare<double>(scenario, 1e-8, always);
      ASSERT_TRUE(found);
    } while (found->is_course_sure());
    EXPECT_TRUE(found->same_course) << name_of(event) << ' ' << left_s;
    for (const NamedEstimate& value : found->summary) {
      EXPECT_FALSE(value.estimate && value.of_tolerance > 0 && sure_digits(value) > 0)
          << name_of(event) << ' ' << value.name;
    }
  }
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
  // Flights after a contact that nearly touch reach less than what has been reached.
  scenario.parameters.stator_radius = scenario.parameters.rotor_radius + 0.99 * reached;
  scenario.until = 0.2;
  const auto touching = compute<double>(scenario, {.tolerance = 1e-10}, always);
  ASSERT_GT(touching.summary.collisions, 0);
  const auto touch_down = std::ranges::find(touching.events, Event::touch_down, &Instant::event);
  const auto until_contact = static_cast<std::size_t>(touch_down + 1 - touching.events.begin());
  ASSERT_FALSE(touching.misses.empty());
  EXPECT_GT(touching.misses.rbegin()->first, until_contact);
}

// A course hangs on a margin that may be none; one that only some computations take for near is
// none.
TEST(Margins, MakeACourseUnsureOnceTheirErrorReachesThem) {
  Comparison comparison;
  comparison.same_course = true;
  EXPECT_TRUE(comparison.is_course_sure());
  const auto is_sure = [&](double value, double error) {
    comparison.margins = {{.name = "miss", .estimate = Estimate{value, error}},
                          {.name = "reserve"}};
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
  int least = most_digits;
  for (const NamedEstimate& value : found->summary)
    if (value.estimate) least = std::min(least, sure_digits(value));
  for (const EventEstimate& event : found->events)
    for (const NamedEstimate& value : event.values)
      if (value.estimate) least = std::min(least, sure_digits(value));
  EXPECT_TRUE(short_of_digits(*found, least).empty());
  EXPECT_FALSE(short_of_digits(*found, least + 1).empty());
  const auto short_ones = short_of_digits(*found, most_digits);  // which lacks most stands first
  ASSERT_GT(short_ones.size(), 10U);
  EXPECT_EQ(short_ones.front().digits, least);
  EXPECT_TRUE(std::ranges::is_sorted(short_ones, {}, &ShortOfDigits::digits));
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
