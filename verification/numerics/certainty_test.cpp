/// What the digits of a run are told by: computations that have no number in common, and margins
/// that would change its course if they were a little different: no digit of such a run is sure.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "figures/input/names.hpp"
#include "figures/record/columns.hpp"
#include "figures/results/certified_result.hpp"
#include "model/certified/comparison.ipp"
#include "model/certified/digits.hpp"
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
    p.mass_loss_time = loss_s;
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
  ASSERT_EQ(found->values.touch_downs, 0);
  const auto misses = margins_of(*found, "miss");
  ASSERT_EQ(misses.size(), 1U);
  EXPECT_NEAR(misses[0], 0.01 * reached, 1e-6 * reached);
  // In the end it is still free, and reaches less than the clearance.
  const auto reaches = margins_of(*found, "reach");
  ASSERT_EQ(reaches.size(), 1U);
  EXPECT_LT(reaches[0], 1.01 * reached);
}

TEST(UnsureCourse, LeavesOnlyWhatIsStatedWithDigits) {
  auto found = compare<double>(short_run(0.02), 1e-10, always);
  ASSERT_TRUE(found && has_digits(*found, 3));
  EXPECT_EQ(complaint(*found, 3), "");
  found->margins.front() = {.name = "miss", .estimate = Estimate{1, 2}};
  EXPECT_FALSE(has_digits(*found, 3));
  EXPECT_NE(complaint(*found, 3), "");
  found->invalidate_path_dependent_values();
  for (const EventEstimate& event : found->events)
    for (const NamedEstimate& value : event.values)
      EXPECT_TRUE(sure_digits(value) == 0 || value.of_tolerance == 0) << value.name;
  for (const NamedEstimate& value : found->summary)
    EXPECT_TRUE(!value.estimate || sure_digits(value) == 0 || value.name == "final_time_s")
        << value.name;
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
  const auto numbers = [](const RotorSystem<double>& of, const Instant& at,
                          const MassLoss<double>& lost) {
    const auto& [supports, ring] = std::tie(of.supports, of.ring);
    std::vector<double> all = {supports.springs.force(1), supports.damping, supports.gravity,
                               supports.torque, of.motor_off};
    for (const double number : {ring.clearance, ring.rotor_radius, ring.stiffness, ring.damping,
                                ring.friction, at.state[0], at.state[1], at.state[5]})
      all.push_back(number);
    for (const Body<double>& body : {at.body, lost.after})
      for (const double number : {body.mass, body.inertia, body.eccentricity})
        all.push_back(number);
    all.push_back(lost.lost_mass);
    all.push_back(lost.piece_distance);
    return all;
  };
  const auto before = numbers(rotor, start, loss), after = numbers(off_rotor, off_start, off_loss);
  int raised = 0;
  for (std::size_t n = 0; n < before.size(); ++n) {
    EXPECT_NEAR(std::abs(after[n] / before[n] - 1), share, 1e-12) << n;
    raised += std::abs(after[n]) > std::abs(before[n]);
  }
  EXPECT_GT(raised, 5);
  EXPECT_LT(raised, 16);
}

}  // namespace
}  // namespace rotor
