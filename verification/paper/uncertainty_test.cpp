/// The uncertainty due to the method, the paper's steps and the printed digits.
#include "verification/paper/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace rotor {
namespace {

const std::vector<Uncertainty>& all() {
  static const auto found = uncertainties(judged());
  return found;
}

const Uncertainty& of(std::string_view number) {
  return *std::ranges::find(all(), number, &Uncertainty::number);
}

TEST(Uncertainty, OfTheMethodIsAtMostAHundredthOfWhatThePrintedDigitsLeaveOpen) {
  EXPECT_GT(all().size(), 50U);
  for (const Uncertainty& u : all())
    if (u.u_input > 0) {
      EXPECT_LT(u.u_num, u.u_input / 100) << u.number;
    }
}

TEST(Uncertainty, IsRelativeToTheSimulatedValue) {
  const Uncertainty& peak = of("peak_force");
  EXPECT_NEAR(peak.error, (peak.simulated - 455) / peak.simulated, 1e-12);
  EXPECT_NEAR(peak.u_printed, 0.5 / peak.simulated, 1e-12);
  const Spread b = read_ensembles(ROTOR_REFERENCE_DATA "/ensembles.csv")
                       .at({"published", "b", "peak_force", "peak_kN"})
                       .spread;
  EXPECT_NEAR(2 * peak.u_input * peak.simulated, b.high - b.low, 1e-9);
  EXPECT_TRUE(std::isnan(of("onset_at_peak").error));  // which has no number printed
}

// Two runs to different tolerances never agree to the bit.
TEST(Uncertainty, OfTheMethodIsMoreThanNothingAndLessThanItsTolerance) {
  const Uncertainty& peak = of("peak_force");
  EXPECT_GT(peak.u_num, 0);
  EXPECT_LT(peak.u_num, 1e-11);
}

}  // namespace
}  // namespace rotor
