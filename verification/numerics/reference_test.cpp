/// The event-located method against the reference in quadruple precision.
#include <gtest/gtest.h>

#include "figures/scenes/scene.hpp"
#include "model/simulation/summary.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/reference_tables.hpp"

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

class Rub : public testing::TestWithParam<FrictionCase> {};

TEST_P(Rub, AgreesWithTheReferenceInQuadruplePrecision) {
  const std::vector<ReferenceLandmark> exact = reference(GetParam().run);
  EventRecorder recorder;
  const RunEnd end =
      run({.parameters = {.friction = GetParam().friction}, .tolerance = 1e-12}, recorder);
  EXPECT_EQ(recorder.count(Event::touch_down), GetParam().contacts);
  EXPECT_LT(relative_error(end.last.state, exact.back().state), 1e-9);

  const std::vector<Instant>& events = recorder.events();
  ASSERT_EQ(events.size(), exact.size() - 1);  // the last landmark is the end
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(name_of(events[i].event), exact[i].kind) << i;
    EXPECT_NEAR(events[i].time_s, static_cast<double>(exact[i].time_s), GetParam().time_accuracy_s)
        << i << ' ' << exact[i].kind;
  }
}

// At mu = 0.08 the 41 contacts multiply a rounding error of the first by some 1e5 until the late
// ones, which are nearly tangential: double precision cannot tell their times to 1e-12 s.
INSTANTIATE_TEST_SUITE_P(Frictions, Rub,
                         testing::Values(FrictionCase{0.3, "fig03: mu = 0.3", 7, 1e-12},
                                         FrictionCase{0.2, "fig03: mu = 0.2", 12, 1e-12},
                                         FrictionCase{0.08, "fig03: mu = 0.08", 41, 3e-10}),
                         [](const auto& c) {
                           return "Contacts" + std::to_string(c.param.contacts);
                         });

TEST(Reference, IsGoodToTenDigitsAndMore) {
  for (const char* run : {"fig03: mu = 0.3", "fig03: mu = 0.2", "fig03: mu = 0.08"})
    for (const ReferenceLandmark& landmark : reference(run)) {
      EXPECT_LT(landmark.time_error_s, 1e-14) << run << ' ' << landmark.time_s;
      EXPECT_LT(landmark.state_error, 1e-11) << run << ' ' << landmark.time_s;
    }
}

TEST(EventMethod, GainsADigitForEveryDigitOfTheToleranceDownToRounding) {
  const State<long double> exact = reference("fig03: mu = 0.3").back().state;
  Observer null_observer;
  // Seven contacts and 1,000 rad of whirl in rolling multiply the errors of steps: 360 is the worst
  // seen, and five times that allowed. Rounding, multiplied by the contacts, stays below 1e-9.
  const double multiplied = 5 * 360, rounding = 1e-9;
  for (int digits = 4; digits <= 13; ++digits) {
    const double tolerance = std::pow(10, -digits);
    const double error =
        relative_error(run({.tolerance = tolerance}, null_observer).last.state, exact);
    EXPECT_LT(error, multiplied * tolerance + rounding) << tolerance;
  }
}

TEST(EventMethod, GivesEightDigitsOfEverySummaryValueAtItsDefaultTolerance) {
  for (const double friction : {0.3, 0.2, 0.08}) {
    std::array<Summary, 2> summaries;
    for (std::size_t i = 0; i < 2; ++i) {
      Scenario scenario{.parameters = {.friction = friction}};
      if (i == 1) scenario.tolerance = 1e-13;
      SummaryObserver observer(scenario);
      run(scenario, observer);
      summaries[i] = observer.summary();
    }
    const auto& [ours, finer] = summaries;
    EXPECT_EQ(ours.collisions, finer.collisions);
    const auto expect_eight_digits = [&](const std::optional<double>& a,
                                         const std::optional<double>& b, const char* what) {
      ASSERT_EQ(a.has_value(), b.has_value()) << what;
      if (a) {
        EXPECT_NEAR(*a / *b, 1, 0.5e-8) << what << " at mu = " << friction;
      }
    };
    expect_eight_digits(ours.first_contact_s, finer.first_contact_s, "first contact");
    expect_eight_digits(ours.rolling_onset_s, finer.rolling_onset_s, "onset of rolling");
    expect_eight_digits(ours.rolling_onset_speed_Hz, finer.rolling_onset_speed_Hz, "its speed");
    expect_eight_digits(ours.rolling_onset_force_N, finer.rolling_onset_force_N, "its force");
    expect_eight_digits(ours.peak_normal_force_N, finer.peak_normal_force_N, "peak force");
    expect_eight_digits(ours.max_displacement_m, finer.max_displacement_m, "displacement");
    expect_eight_digits(ours.motor_off_s, finer.motor_off_s, "motor off");
    expect_eight_digits(ours.final_speed_Hz, finer.final_speed_Hz, "final speed");
    expect_eight_digits(ours.final_kinetic_energy_J, finer.final_kinetic_energy_J, "final T");
    expect_eight_digits(ours.final_q1_m, finer.final_q1_m, "final q1");
    expect_eight_digits(ours.final_q2_m, finer.final_q2_m, "final q2");
  }
}

}  // namespace
}  // namespace rotor
