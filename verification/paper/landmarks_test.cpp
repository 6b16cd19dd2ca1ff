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

const Convergence& landmark(const std::string& method, const std::string& name) {
  const auto found = std::ranges::find_if(
      all(), [&](const Convergence& c) { return c.method == method && c.landmark == name; });
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
  EXPECT_NEAR(
      landmark("event", "mu = 0.3: first contact after the loss").converged / ms(of("touch_down")),
      1, relative);
  const ReferenceLandmark onset = of("rolling_onset");
  EXPECT_NEAR(landmark("event", "mu = 0.3: onset of rolling after the loss").converged / ms(onset),
              1, relative);
  EXPECT_NEAR(landmark("event", "mu = 0.3: speed there").converged /
                  in_Hz(static_cast<double>(onset.state[5])),
              1, relative);
  EXPECT_NEAR(landmark("event", "mu = 0.3: speed at 29.35 s").converged /
                  in_Hz(static_cast<double>(of("end").state[5])),
              1, relative);
}

TEST(Landmarks, HaveErrorsThatFallWithTheToleranceToThatOfTheDefault) {
  for (const Convergence& c : all()) {
    if (c.method != "event") continue;
    ASSERT_EQ(c.settings.back(), Scenario{}.tolerance);
    // At low friction ten contacts multiply a difference by 3e6, of which 41 leave no more.
    const bool multiplies = c.landmark.starts_with("mu = 0.08");
    EXPECT_LT(c.error(c.settings.size() - 1), multiplies ? 1e-9 : 1e-11) << c.landmark;
    if (c.error(0) > 1e-9) {  // as many errors above rounding as make a slope
      EXPECT_GT(c.power(), 0.8) << c.landmark;
      EXPECT_LT(c.power(), 1.4) << c.landmark;
    }
  }
}

// The paper's method is of fourth order as long as nothing is switched, of first order across
// contacts, and follows no order at all where many contacts multiply its errors.
TEST(Landmarks, HaveTheOrderOfThePapersMethodThatTheirContactsLeave) {
  for (const Convergence& c : all()) {
    if (c.method != "rk4") continue;
    if (c.landmark.starts_with("flight")) {
      EXPECT_NEAR(c.power(), 4, 0.25) << c.landmark;
    } else if (c.landmark.starts_with("mu = 0.3")) {
      EXPECT_NEAR(c.power(), 1, 0.5) << c.landmark;
      // Not a thousandth of it, as the fourth order would have it over four halvings.
      EXPECT_GT(c.error(finest), c.error(papers_own) / 1000) << c.landmark;
    }
  }
  const Convergence& speed = landmark("rk4", "mu = 0.08: speed at 29.35 s");
  EXPECT_GT(speed.error(finest), speed.error(papers_own) / 4);
  EXPECT_GT(speed.error(finest), 0.01);
}

}  // namespace
}  // namespace rotor
