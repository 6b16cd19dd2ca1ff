/// What the README says of the paper's claims and reasons.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "figures/data/csv.hpp"
#include "model/theory/mass_loss_response.hpp"
#include "model/theory/whirl.hpp"
#include "verification/paper/claims_table.hpp"
#include "verification/paper/judged.hpp"
#include "verification/paper/reasons.hpp"
#include "verification/support/readme.hpp"

namespace rotor {
namespace {

// Over the rounding of the inputs, in both sets of equations.
TEST_F(Readme, SaysWhichAccidentsSurviveTheCorrection) {
  const auto accidents = read_accidents(ROTOR_REFERENCE_DATA "/accidents.csv");
  const auto percent = [&](const char* loss, const char* equations) {
    return fmt::format("{:.0f} %", 100 * accidents.at({loss, equations}).rolls);
  };
  expect_said(fmt::format(
      "of [10,000 draws](reference-data/accidents.csv) of the printed digits {} roll as published, "
      "{} put right. That at half of it does not at the inputs as printed; of the draws {} and {} "
      "roll, and at two thirds of it {} and {}.",
      percent("29.1 s", "published"), percent("29.1 s", "consistent"),
      percent("14.15 s", "published"), percent("14.15 s", "consistent"),
      percent("19.1 s", "published"), percent("19.1 s", "consistent")));
  expect_said("after one at 1 s, at the inputs as printed, the motor stalls at resonance.");
  for (const char* equations : {"published", "consistent"})
    EXPECT_EQ(summary(fmt::format("--separation-time 1 --until 12 --tolerance 1e-8 --equations {}",
                                  equations))["outcome"],
              "stalled");
}

TEST_F(Readme, SaysHowOftenTheReasonsFail) {
  std::map<std::string, std::string> shares;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/reasons-tried.csv"))
    shares[row["reason"] + row["equations"]] =
        fmt::format("{:.0f} %", 100 * static_cast<double>(row.number("share")));
  const auto rows = table("| the text, in our words |");
  const auto reasons = read_reasons(ROTOR_REFERENCE_DATA "/reasons.csv");
  ASSERT_EQ(rows.size(), reasons.size());
  for (std::size_t n = 0; n < rows.size(); ++n)
    EXPECT_EQ(rows[n], (Cells{reasons[n].says, shares[reasons[n].id + "published"],
                              shares[reasons[n].id + "consistent"]}));
  EXPECT_EQ(shares["speed_forcepublished"], "0 %");  // without exception
}

TEST_F(Readme, SaysWhereWhirlCanLast) {
  const Whirl whirl(Parameters{});
  const double speed = 2 * std::numbers::pi * 150;
  expect_said(
      fmt::format("could last from mu = {:.4f} on at 150 Hz", whirl.rolling_friction(speed)));
  expect_said(fmt::format("lasts up to mu = {:.3f};", whirl.synchronous_friction(speed)));
  expect_said("the border of contact begins at 51.80 or 94.29 Hz");
  const auto touches = [](Equations set, double speed_Hz) {
    return MassLossResponse({}, set, 2 * std::numbers::pi * speed_Hz).first_contact().has_value();
  };
  for (const auto& [set, border_Hz] :
       {std::pair(Equations::published, 51.80), {Equations::consistent, 94.29}}) {
    EXPECT_FALSE(touches(set, border_Hz - 0.005));
    EXPECT_TRUE(touches(set, border_Hz + 0.005));
  }
  // TheoryOfMaps finds it so; 120, 123 ... 180 Hz are BorderOfFriction's.
  expect_said(
      "above it, in these maps and well above the resonance, every contact ends in backward "
      "rolling "
      "or in none");
  expect_said(
      "of 21 speeds from 120 to 180 Hz none rolls at mu = 0.08 and all do at 0.1, with d_t as "
      "printed, but none at 0.15 where d_t is tenfold");
  expect_said(
      "Among these rotors speed raises the force in rolling without exception");  // as the table
                                                                                  // has it
  const Parameters p;
  expect_said(fmt::format("C moves alike to {:.1f} % wherever the piece was",
                          100 * 2 * p.eccentricity / p.rotor_radius));
}

TEST_F(Readme, CountsVerdicts) {
  std::map<std::string, int> verdicts;
  int arithmetic = 0;
  const auto& numbers = judged();
  const auto claims = verdicts_of_claims(numbers);
  for (const auto& [claim, verdict] : claims) ++verdicts[verdict];
  for (const Number& number : numbers) arithmetic += number.kind == Kind::arithmetic;
  expect_said(fmt::format(
      "Of the text's {} claims, {} are reproduced, {} lie within the rounding of its inputs, and "
      "{} "
      "are refuted",
      claims.size(), verdicts["reproduced"], verdicts["within rounding"], verdicts["refuted"]));
  expect_said(fmt::format("each of the {} numbers", numbers.size()));
  EXPECT_EQ(figures_without_claim(numbers), (std::vector{8, 9, 15, 16}));
  expect_said("About Figs. 8, 9, 15 and 16 it claims nothing");
  for (const Number& number : numbers)
    if (number.kind == Kind::simulated) {
      EXPECT_EQ(number.readings.front().everything.draws, 10000);
      EXPECT_EQ(number.readings.front().times.draws, 10000);
    }
  expect_said("over 10,000 draws of the printed digits");
  expect_said(fmt::format("{} of them arithmetic on printed numbers", arithmetic));
  const auto converged = [&](const std::string& id) {
    const auto found = std::ranges::find(numbers, id, &Number::id);
    return found->readings.front().converged.value();
  };
  expect_said(
      fmt::format("The frequency of q1 in rolling, {:.0f} Hz, is not that of the whirl, {:.0f} Hz",
                  converged("f_q1"), converged("f_rol")));
  expect_said(fmt::format("at {:.0f} % of it", 100 - converged("onset_at_peak")));
  expect_said(fmt::format(
      "Friction takes {:.0f} % of the energy until rolling, not 75 %: that is what is gone by all "
      "causes, {:.0f} %",
      converged("share_dissipated"), converged("share_lost")));
  expect_said(fmt::format("it changes the largest force by {:.0f} %, but doubles the time",
                          converged("location_force")));
  EXPECT_NEAR(converged("location_time"), 100, 10);
  const auto everything = [&](const std::string& id) {
    return std::ranges::find(numbers, id, &Number::id)->readings.front().everything;
  };
  expect_said(fmt::format("in {:.0f} % of the draws it changes the force by more than 10 %",
                          100 * (1 - everything("location_force").share)));
  expect_said(fmt::format("change that by {:.0f} to {:.0f} % in nine of ten draws",
                          everything("damping_time").low, everything("damping_time").high));
  expect_said(fmt::format(
      "over the rounding of the inputs in {:.0f} % of the draws; its 49.8 Hz without contact in "
      "{:.0f} %.",
      100 * everything("contacts_2").share, 100 * everything("contacts_9").share));
  expect_said(fmt::format("Twice and half k_t change the largest force by up to {:.0f} %",
                          converged("stiffness_force")));
}

}  // namespace
}  // namespace rotor
