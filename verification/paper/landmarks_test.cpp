/// What the report says of the convergence of the text's landmarks.
#include <gtest/gtest.h>

#include <cmath>

#include "model/simulation/instant.hpp"
#include "model/simulation/scenario.hpp"
#include "verification/paper/convergence.hpp"
#include "verification/support/reference_tables.hpp"

namespace rotor {
namespace {

const std::vector<Convergence>& all() {
  static const auto studied = studied_convergence();
  return studied;
}

const Convergence& landmark(const std::string& name) {
  const auto found = std::ranges::find(all(), name, &Convergence::landmark);
  if (found == all().end()) throw std::out_of_range(name);
  return *found;
}

constexpr std::size_t papers_own = 2, finest = 6;  // of the steps

TEST(Landmarks, ConvergeToTheHighPrecisionReference) {
  const auto reference =
      reference_run(ROTOR_REFERENCE_DATA "/high-precision.csv", "fig03: mu = 0.3");
  const auto of = [&](const std::string& kind) {
    return *std::ranges::find(reference, kind, &ReferenceLandmark::kind);
  };
  const auto ms = [](const ReferenceLandmark& at) {
    return static_cast<double>(1000 * (at.time_s - 29.1L));
  };
  const double relative = 1e-10;  // of 29.1 s, its last double is 1e-12 of a landmark's 4 ms
  EXPECT_NEAR(landmark("mu = 0.3: first contact after the loss").converged / ms(of("touch_down")),
              1, relative);
  const ReferenceLandmark onset = of("rolling_onset");
  EXPECT_NEAR(landmark("mu = 0.3: onset of rolling after the loss").converged / ms(onset), 1,
              relative);
  EXPECT_NEAR(
      landmark("mu = 0.3: speed there").converged / in_Hz(static_cast<double>(onset.state[5])), 1,
      relative);
  EXPECT_NEAR(landmark("mu = 0.3: speed at 29.35 s").converged /
                  in_Hz(static_cast<double>(of("end").state[5])),
              1, relative);
}

TEST(Landmarks, HaveErrorsThatFallWithTheToleranceToThatOfTheDefault) {
  ASSERT_EQ(studied_tolerances().back(), Scenario{}.tolerance);
  for (const Convergence& c : all()) {
    // At low friction ten contacts multiply a difference by 3e6, of which 41 leave no more.
    const bool multiplies = c.landmark.starts_with("mu = 0.08");
    EXPECT_LT(c.error_by_tolerance(studied_tolerances().size() - 1), multiplies ? 1e-9 : 1e-11)
        << c.landmark;
    const double power = c.power_of_tolerance();
    if (c.error_by_tolerance(0) > 1e-9) {  // as many errors above rounding as make a slope
      EXPECT_GT(power, 0.8) << c.landmark;
      EXPECT_LT(power, 1.4) << c.landmark;
    }
  }
}

TEST(Landmarks, BeforeAnyContactAreOfFourthOrderInThePapersStepAndTheGridConvergenceIndexHolds) {
  int found = 0;
  for (const Convergence& c : all()) {
    if (!c.landmark.starts_with("flight")) continue;
    ++found;
    EXPECT_EQ(c.orders.size(), 5U);
    for (const double order : c.orders) EXPECT_NEAR(order, 4, 0.25) << c.landmark;
    const auto index = c.grid_convergence_index();
    ASSERT_TRUE(index) << c.landmark;
    const double error = c.error_by_steps(papers_own);
    EXPECT_GT(*index, error) << c.landmark;  // it is a bound, by a factor of safety
    EXPECT_LT(*index, 1.5 * error) << c.landmark;
  }
  EXPECT_EQ(found, 2);
}

TEST(Landmarks, BeyondAContactAreOfFirstOrderAboutInThePapersStepAndHaveNoGridConvergenceIndex) {
  for (const Convergence& c : all()) {
    if (c.landmark.starts_with("flight")) continue;
    EXPECT_FALSE(c.grid_convergence_index()) << c.landmark;
    if (!c.landmark.starts_with("mu = 0.3")) continue;
    EXPECT_GT(c.power_of_step(), 0.5) << c.landmark;
    EXPECT_LT(c.power_of_step(), 1.5) << c.landmark;
    // Not a thousandth of it, as the fourth order would have it over four halvings.
    EXPECT_GT(c.error_by_steps(finest), c.error_by_steps(papers_own) / 1000) << c.landmark;
  }
}

TEST(Landmarks, HaveAGridConvergenceIndexOnlyWhereSuccessiveOrdersAgree) {
  // Of second order, errors of 16, 4 and 1 %: the last change over 2^2 - 1, times 1.25.
  Convergence c{.landmark = {},
                .unit = {},
                .converged = 1,
                .by_tolerance = {},
                .by_steps = {1.16, 1.04, 1.01},
                .orders = {2, 2.1}};
  EXPECT_NEAR(c.grid_convergence_index().value(), 1.25 * 0.03 / 1.01 / 3, 1e-12);
  c.orders = {2, 2.3};
  EXPECT_FALSE(c.grid_convergence_index());
  c.orders = {2, std::nan("")};
  EXPECT_FALSE(c.grid_convergence_index());
  c.orders = {2};
  EXPECT_FALSE(c.grid_convergence_index());
}

TEST(Landmarks, OfManyContactsDoNotConvergeByThePapersStepsAtAll) {
  const Convergence& speed = landmark("mu = 0.08: speed at 29.35 s");
  EXPECT_GT(speed.error_by_steps(finest), speed.error_by_steps(papers_own) / 4);
  EXPECT_GT(speed.error_by_steps(finest), 0.01);
}

TEST(Landmarks, AreAllPrintedAndWritten) {
  const std::string table = convergence_table(all()), csv = to_csv(all());
  for (const Convergence& c : all()) {
    EXPECT_NE(table.find("  " + c.landmark), std::string::npos);
    EXPECT_NE(csv.find(c.landmark + ','), std::string::npos);
  }
  const auto lines = static_cast<std::size_t>(std::ranges::count(csv, '\n'));
  EXPECT_EQ(lines, 1 + all().size() * (1 + studied_tolerances().size() + studied_steps().size()));
}

}  // namespace
}  // namespace rotor
