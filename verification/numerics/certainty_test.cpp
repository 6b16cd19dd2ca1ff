/// What makes the digits of a run certain: computations that share no number but take the same
/// course, and margins that exclude any other course. digits_test.cpp tests whether the digits are
/// right.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "figures/input/names.hpp"
#include "figures/results/certified_result.hpp"
#include "model/certified/comparison.hpp"
#include "model/certified/comparison.ipp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

// Each computation still touches the ring, but the duration is uncertain.
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

// The run ends between the times that two computations find for an event.
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

// A number that is not disturbed is rounded in the same way in all computations.
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
    const auto& [stiffness, damping] = ring.law.linear("this test");
    for (const double number : {ring.clearance, ring.rotor_radius, stiffness, damping,
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
  const std::size_t clearance = 5;  // which is off by a quarter of what the stator's radius is
  for (std::size_t n = 0; n < before.size(); ++n) {
    const double of = n == clearance ? 0.25 * scenario.parameters.stator_radius : before[n];
    EXPECT_NEAR(std::abs(after[n] - before[n]) / std::abs(of), share, 1e-12) << n;
    raised += std::abs(after[n]) > std::abs(before[n]);
  }
  EXPECT_GT(raised, 5);
  EXPECT_LT(raised, 16);
}

}  // namespace
}  // namespace rotor
