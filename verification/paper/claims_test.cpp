/// The claims of the paper's text, and the rules by which they are judged.
#include "verification/paper/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "figures/data/csv.hpp"

namespace rotor {
namespace {

/// The share of draws that have a value.
double values_share(const std::vector<double>& values) {
  return spread(values, [](double value) { return !std::isnan(value); }).share;
}

const std::vector<Claim>& claims() {
  static const auto all = judged_claims(ROTOR_REFERENCE_DATA);
  return all;
}

TEST(Policy, TakesHalfAUnitOfTheLastDigit) {
  for (const auto& [printed, half] : {std::pair("0.283", 0.0005),
                                      {"237", 0.5},
                                      {"4000", 50.},
                                      {"150", 5.},
                                      {"1050", 5.},
                                      {"400", 5.},
                                      {"45", 0.5},
                                      {"3", 0.5},
                                      {"8.91e-3", 0.5e-5},
                                      {"1e-4", 0.5e-4},
                                      {"10", 0.5},
                                      {"713.3", 0.05},
                                      {"770", 5.}})
    EXPECT_NEAR(half_digit(printed) / half, 1, 1e-12) << printed;
}

TEST(Policy, AllowsWhatItsTableSays) {
  const auto expect = [](const char* printed, const char* rule, double least, double greatest) {
    const Allowed found = allowed(printed, rule);
    EXPECT_NEAR(found.least, least, 1e-12) << printed << ' ' << rule;
    EXPECT_NEAR(found.greatest, greatest, 1e-12) << printed << ' ' << rule;
  };
  expect("455", "digits", 454.5, 455.5);
  expect("770", "about", 731.5, 808.5);
  expect("0.02", "about", 0.015, 0.025);  // whose digit allows more
  expect("400-450", "range", 395, 455);
  expect("", "few", 2, 10);
  expect("", "minor", -10, 10);
  expect("", "slight", -5, 5);
  expect("", "agrees", -5, 5);
  expect("", "negligible", -1, 1);
  expect("-1", "is", -1, -1);
  EXPECT_TRUE(allowed("", "major").holds(99));
  EXPECT_FALSE(allowed("", "major").holds(49));
  EXPECT_THROW(allowed("1", "roughly"), std::invalid_argument);
  EXPECT_THROW(allowed("one", "digits"), std::invalid_argument);
}

TEST(Claims, HaveTheVerdictsThatTheTableStates) {
  for (const Claim& claim : claims()) EXPECT_EQ(claim.verdict, claim.expected_verdict) << claim.id;
}

TEST(Claims, ThatAreNotReproducedHaveAReason) {
  for (const Claim& claim : claims())
    if (claim.verdict != "reproduced") {
      EXPECT_FALSE(claim.reason.empty()) << claim.id;
    }
}

TEST(Claims, StandOnceAndUseEveryReading) {
  std::set<std::string> ids, used;
  for (const Claim& claim : claims()) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    for (const ClaimReading& reading : claim.readings) used.insert(reading.name);
  }
  for (const std::string& reading : all_readings()) EXPECT_TRUE(used.contains(reading)) << reading;
}

// A refutation that would also refute a paper that is right would be none.
TEST(Claims, ThatAreRefutedWouldHoldForAPaperThatPrintsWhatItsEquationsGive) {
  int refuted = 0;
  for (Claim claim : claims()) {
    if (claim.verdict != "refuted") continue;
    ++refuted;
    const double right = claim.readings.front().converged.value();
    const double off = claim.allowed.least + claim.allowed.greatest;
    const double width = std::isfinite(off) ? claim.allowed.greatest - claim.allowed.least : 1;
    claim.allowed = {right - width / 2, right + width / 2};
    EXPECT_EQ(verdict_of(claim), "reproduced") << claim.id;
    // Nor if its inputs are but rounded otherwise than as printed.
    claim.readings.resize(1);
    claim.readings[0].converged = claim.readings[0].by_rk4 = std::nullopt;
    if (!claim.is_arithmetic) {
      EXPECT_EQ(verdict_of(claim), "within rounding") << claim.id;
    }
  }
  EXPECT_GT(refuted, 5);
}

// A part of the stored ensembles, drawn anew: shares within three standard errors.
TEST(Ensembles, AreWhatRunsGive) {
  const auto inputs = std::filesystem::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv";
  for (const auto& [rounded, count] :
       {std::pair(Rounded::times, 40L), {Rounded::everything, 120L}}) {
    const Draws draws = draw(inputs, rounded, count, 2);
    for (const Claim& claim : claims())
      for (const ClaimReading& reading : claim.readings) {
        const Spread stored = rounded == Rounded::times ? reading.times : reading.everything;
        const Spread anew = spread(draws.at(reading.name),
                                   [&](double value) { return claim.allowed.holds(value); });
        const auto n = static_cast<double>(count);
        const double deviation = std::sqrt(stored.share * (1 - stored.share) / n);
        EXPECT_NEAR(anew.share, stored.share, 3 * deviation + 1 / n) << claim.id << reading.name;
        if (std::isfinite(stored.low)) {  // nine of ten lie between the quantiles
          const Spread inside = spread(draws.at(reading.name), [&](double value) {
            const double rounding = 1e-5 * std::abs(value);  // of six digits
            return stored.low - rounding <= value && value <= stored.high + rounding;
          });
          EXPECT_GT(
              inside.share + 3 * std::sqrt(0.09 / n) + (1 - values_share(draws.at(reading.name))),
              0.9)
              << claim.id << reading.name;
        }
      }
  }
}

TEST(Ensembles, DoNotDependOnTheNumberOfThreads) {
  const auto inputs = std::filesystem::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv";
  const Draws one = draw(inputs, Rounded::everything, 3, 1);
  const Draws two = draw(inputs, Rounded::everything, 3, 2);
  for (const auto& [reading, values] : one)
    for (std::size_t n = 0; n < values.size(); ++n)
      EXPECT_TRUE(values[n] == two.at(reading)[n] ||
                  (std::isnan(values[n]) && std::isnan(two.at(reading)[n])))
          << reading;
}

TEST(Ensembles, HaveTheQuantilesOfTheirValues) {
  std::vector<double> values;
  for (int n = 100; n >= 0; --n) values.push_back(n);
  values.push_back(std::nan(""));
  const Spread found = spread(values, [](double value) { return value < 51; });
  EXPECT_EQ(found.draws, 102);
  EXPECT_EQ(found.median, 50);
  EXPECT_EQ(found.low, 5);
  EXPECT_EQ(found.high, 95);
  EXPECT_EQ(found.share, 0.5);
}

TEST(PrintedInputs, AreTheNomenclaturesWithHalfAUnitOfTheirLastDigit) {
  const Scenario printed;
  int own_digits = 0;
  for (const CsvRow& row : read_csv(std::string(ROTOR_REFERENCE_DATA) + "/printed-inputs.csv")) {
    const double least = static_cast<double>(row.number("least")),
                 greatest = static_cast<double>(row.number("greatest"));
    const double number = std::stod(row["printed"]);
    PaperInputs inputs;
    inputs.set(row["input"], number);
    if (const Statable* const statable = find_statable(row["input"]);
        statable && statable->quantity.in) {
      EXPECT_NEAR(statable->quantity.of(printed) / number, 1, 1e-12) << row["input"];
    }
    EXPECT_LT(least, number);
    EXPECT_GT(greatest, number);
    if (!row["why"].empty()) continue;
    ++own_digits;
    EXPECT_NEAR(greatest - least, 2 * half_digit(row["printed"]), 1e-9 * number) << row["input"];
  }
  EXPECT_GE(own_digits, 15);
}

}  // namespace
}  // namespace rotor
