/// What the method, the paper's steps and the printed digits leave open, and which input decides.
#include "verification/paper/uncertainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verification/paper/judged.hpp"

namespace rotor {
namespace {

const std::vector<Influence>& ranking() {
  static const auto all = read_ranking(ROTOR_REFERENCE_DATA "/ranking.csv");
  return all;
}

const std::vector<Uncertainty>& all() {
  static const auto found = uncertainties(judged(), ranking());
  return found;
}

const Uncertainty& of(const std::string& number) {
  return *std::ranges::find(all(), number, &Uncertainty::number);
}

TEST(Uncertainty, OfTheMethodIsAtMostAHundredthOfWhatThePrintedDigitsLeaveOpen) {
  EXPECT_GT(all().size(), 50U);
  for (const Uncertainty& u : all())
    if (u.u_input > 0) {
      EXPECT_LT(u.u_num, u.u_input / 100) << u.number;
    }
}

TEST(Uncertainty, OfThePapersStepsIsLessThanWhatThePrintedDigitsLeaveOpenButForOneDifference) {
  for (const Uncertainty& u : all()) {
    if (std::isnan(u.u_num_own) || u.u_input == 0) continue;
    EXPECT_EQ(u.u_num_own < u.u_input, u.number != "F_in_agrees") << u.number;
  }
}

TEST(Uncertainty, OfTheInstantAloneIsNoneOfItsOwn) {
  for (const Uncertainty& u : all()) EXPECT_LE(u.u_times, u.u_input * (1 + 1e-9)) << u.number;
}

TEST(Uncertainty, IsRelativeToTheSimulatedValue) {
  const Uncertainty& peak = of("peak_force");
  EXPECT_NEAR(peak.error, (peak.simulated - 455) / peak.simulated, 1e-12);
  EXPECT_NEAR(peak.u_printed, 0.5 / peak.simulated, 1e-12);
  EXPECT_TRUE(std::isnan(of("onset_at_peak").error));  // which has no number printed
}

// Two runs to different tolerances never agree to the bit.
TEST(Uncertainty, OfTheMethodIsMoreThanNothingAndLessThanItsTolerance) {
  const Uncertainty& peak = of("peak_force");
  EXPECT_GT(peak.u_num, 0);
  EXPECT_LT(peak.u_num, 1e-11);
  EXPECT_EQ(peak.decided_by.at(0).input, "clearance");
  EXPECT_EQ(peak.decided_by.at(1).input, "mass");
}

// A fixed part of what `make ranking` writes, without OpenTURNS.
TEST(Ranking, HasWhatRunsGiveOneAtATime) {
  const auto ranges = read_input_ranges(ROTOR_REFERENCE_DATA "/printed-inputs.csv");
  const auto readings = readings_to_draw(read_numbers(ROTOR_REFERENCE_DATA "/claims.csv"));
  const Draws draws = one_at_a_time(readings, ranges, 2);
  const double digits = 2e-5;  // of six that are written, and another compiler's last ones
  for (const Influence& row : ranking()) {
    const auto input = static_cast<std::size_t>(
        std::ranges::find(ranges, row.input, &InputRange::input) - ranges.begin());
    ASSERT_LT(input, ranges.size()) << row.input;
    for (const auto& [stored, anew] :
         {std::pair(row.at_least, draws.at(row.reading)[2 * input]),
          std::pair(row.at_greatest, draws.at(row.reading)[2 * input + 1])}) {
      EXPECT_EQ(std::isnan(stored), std::isnan(anew)) << row.reading << ' ' << row.input;
      if (!std::isnan(stored)) {
        EXPECT_NEAR(stored, anew, digits * std::abs(anew)) << row.reading << ' ' << row.input;
      }
    }
  }
}

// Where a reading varies nearly linearly, an input's share of the variance follows from the ends of
// its range: another way to Sobol's index.
TEST(Ranking, HasTheSharesOfALinearResultWhereItIsNearlyOne) {
  for (const char* reading : {"resonance_s", "c_radial", "onset_mm", "onset_velocity", "whirl_5_ms",
                              "q1_5_ms", "elastic_N", "damping_N", "onset_rolling_Hz"}) {
    const std::vector<Influence> its = ranked(ranking(), reading);
    ASSERT_GE(its.size(), 2U) << reading;
    double sum = 0;
    for (const Influence& input : its) sum += std::pow(input.at_greatest - input.at_least, 2);
    for (const Influence& input : its) {
      const double share = std::pow(input.at_greatest - input.at_least, 2) / sum;
      // 95 % of estimates lie in their intervals; curvature takes a few hundredths more.
      EXPECT_NEAR(input.total.value, share, 0.05 + (input.total.high - input.total.low) / 2)
          << reading << ' ' << input.input;
    }
  }
}

TEST(Ranking, HasTheGreatestTotalIndexFirst) {
  const std::vector<Influence> its = ranked(ranking(), "peak_kN");
  ASSERT_GE(its.size(), 5U);
  for (std::size_t n = 1; n < its.size(); ++n) {
    EXPECT_GE(its[n - 1].total.value, its[n].total.value);
    EXPECT_EQ(its[n].reading, "peak_kN");
  }
}

TEST(Ranking, HasEachEstimateWithinItsInterval) {
  for (const Influence& row : ranking())
    for (const Estimate& e : {row.first, row.total}) {
      EXPECT_LE(e.low, e.value) << row.reading << ' ' << row.input;
      EXPECT_GE(e.high, e.value) << row.reading << ' ' << row.input;
    }
}

}  // namespace
}  // namespace rotor
