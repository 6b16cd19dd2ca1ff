/// The event-located method against the reference in quadruple precision.
#include <gtest/gtest.h>

#include "figures/input/names.hpp"
#include "model/digits/computation.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/reference_tables.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

std::vector<ReferenceLandmark> reference(const std::string& run) {
  return reference_run(ROTOR_REFERENCE_DATA "/high-precision.csv", run);
}

/// Largest relative error of a state: of the position relative to the clearance, of the velocity,
/// of the speed and of the angle relative to themselves.
double relative_error(const State<double>& q, const State<long double>& exact_one) {
  State<double> exact{};
  std::ranges::copy(exact_one, exact.begin());
  const double length = 3e-3, velocity = std::hypot(exact[3], exact[4]) + length * exact[5];
  return std::max({std::hypot(q[0] - exact[0], q[1] - exact[1]) / length,
                   std::hypot(q[3] - exact[3], q[4] - exact[4]) / velocity,
                   std::abs(q[5] / exact[5] - 1), std::abs(q[2] / exact[2] - 1)});
}

struct FrictionCase {
  double friction;
  std::string run;  ///< in the reference data
  long contacts;
  double time_accuracy_s;
};

void PrintTo(const FrictionCase& c, std::ostream* out) { *out << "mu = " << c.friction; }

class ReferenceRub : public testing::TestWithParam<FrictionCase> {};

TEST_P(ReferenceRub, AgreesWithTheReferenceInQuadruplePrecision) {
  const std::vector<ReferenceLandmark> exact = reference(GetParam().run);
  EventRecorder recorder;
  const RunEnd end = run({.parameters = {.friction = GetParam().friction},
                          .equations = Equations::published,
                          .tolerance = 1e-12},
                         recorder);
  EXPECT_EQ(recorder.count(Event::touch_down), GetParam().contacts);
  EXPECT_LT(relative_error(end.last.state, exact.back().state), 1e-9);
  for (const ReferenceLandmark& landmark : exact) {  // is itself good to ten digits and more
    EXPECT_LT(landmark.time_error_s, 1e-14) << landmark.time_s;
    EXPECT_LT(landmark.state_error, 1e-11) << landmark.time_s;
  }

  const std::vector<Instant>& events = recorder.events();
  ASSERT_EQ(events.size(), exact.size() - 1);  // the last landmark is the end
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(name_of(events[i].event), exact[i].kind) << i;
    EXPECT_NEAR(events[i].time_s, static_cast<double>(exact[i].time_s), GetParam().time_accuracy_s)
        << i << ' ' << exact[i].kind;
  }
}

// At mu = 0.08 the 41 contacts multiply a rounding error of the first by some 1e5 until the late
// ones, which are nearly tangential: double precision cannot resolve their times to 1e-12 s.
INSTANTIATE_TEST_SUITE_P(Frictions, ReferenceRub,
                         testing::Values(FrictionCase{0.3, "fig03: mu = 0.3", 7, 1e-12},
                                         FrictionCase{0.2, "fig03: mu = 0.2", 12, 1e-12},
                                         FrictionCase{0.08, "fig03: mu = 0.08", 41, 3e-10}),
                         [](const auto& c) {
                           return "Contacts" + std::to_string(c.param.contacts);
                         });

TEST(EventMethod, GainsADigitForEveryDigitOfTheToleranceDownToRounding) {
  const State<long double> exact = reference("fig03: mu = 0.3").back().state;
  // Seven contacts and 1,000 rad of whirl in rolling multiply the errors of steps: 360 is the worst
  // seen, and five times that allowed. Rounding, multiplied by the contacts, stays below 1e-9.
  const double multiplied = 5 * 360, rounding = 1e-9;
  for (int digits = 4; digits <= 13; ++digits) {
    const double tolerance = std::pow(10, -digits);
    const Scenario scenario{.equations = Equations::published, .tolerance = tolerance};
    const double error = relative_error(run(scenario, nobody).last.state, exact);
    EXPECT_LT(error, multiplied * tolerance + rounding) << tolerance;
  }
}

TEST(EventMethod, GivesEightDigitsOfEverySummaryValueAtItsDefaultTolerance) {
  for (const double friction : {0.3, 0.2, 0.08}) {
    Scenario scenario{.parameters = {.friction = friction}, .equations = Equations::published};
    const Summary summary = summary_of(scenario);
    scenario.tolerance = 1e-13;
    const Summary finer = summary_of(scenario);
    EXPECT_EQ(summary.touch_downs, finer.touch_downs);
    const auto ours = values_of(summary, scenario.parameters),
               theirs = values_of(finer, scenario.parameters);
    for (std::size_t i = 0; i < ours.size(); ++i) {
      ASSERT_EQ(ours[i].value.has_value(), theirs[i].value.has_value()) << ours[i].name;
      // Time in contact is a sum of differences of times, each as uncertain as these.
      if (ours[i].value && *theirs[i].value != 0 && ours[i].name != "contact_time_s") {
        EXPECT_NEAR(*ours[i].value / *theirs[i].value, 1, 0.5e-8)
            << ours[i].name << ' ' << friction;
      }
    }
  }
}

}  // namespace
}  // namespace rotor
