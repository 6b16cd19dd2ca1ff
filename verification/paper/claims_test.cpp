/// The claims of the paper's text, and what becomes of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "verification/paper/claims_table.hpp"
#include "verification/paper/judged.hpp"
#include "verification/support/in_folder.hpp"

namespace rotor {
namespace {

class ClaimsInFolder : public InFolder {};

TEST(Claims, HaveTheVerdictsThatTheTableStates) {
  for (const Number& number : judged())
    EXPECT_EQ(number.verdict, number.expected_verdict) << number.id;
}

TEST(Claims, ThatAreNotReproducedHaveAReason) {
  for (const Number& number : judged())
    if (number.verdict != "reproduced") {
      EXPECT_FALSE(number.reason.empty()) << number.id;
    }
}

TEST(Claims, StandOnceAndUseEveryReading) {
  const auto of_accidents = readings_of_accidents();
  std::set<std::string> ids, used(of_accidents.begin(), of_accidents.end());
  for (const Number& number : judged()) {
    EXPECT_TRUE(ids.insert(number.id).second) << number.id;
    for (const Reading& reading : number.readings) used.insert(reading.name);
  }
  for (const std::string& reading : all_readings()) EXPECT_TRUE(used.contains(reading)) << reading;
}

// What policy.md says of it, by the shares themselves rather than by quantiles.
TEST(Claims, ThatAreRefutedFailInAtLeast95PercentOfTheDraws) {
  int refuted = 0;
  for (const Number& number : judged()) {
    if (number.verdict != "refuted" || number.kind != Kind::simulated) continue;
    ++refuted;
    for (const Reading& reading : number.readings) {
      EXPECT_LE(reading.times.share, 0.05) << number.id << ' ' << reading.name;
      EXPECT_LE(reading.everything.share, 0.05) << number.id << ' ' << reading.name;
      EXPECT_FALSE(number.allowed.holds(reading.converged.value())) << number.id;
    }
  }
  EXPECT_GT(refuted, 5);
}

// A refutation that would also refute a paper that is right would be none: with what its equations
// give printed instead, each number is reproduced, and the table's verdict of today is wrong.
TEST_F(ClaimsInFolder, ThatAreNotReproducedWouldBeIfThePaperPrintedWhatItsEquationsGive) {
  std::ifstream table(ROTOR_REFERENCE_DATA "/claims.csv");
  std::string changed;
  std::set<std::string> ids;
  for (std::string line; std::getline(table, line);) {
    for (const Number& number : judged()) {
      if (number.verdict == "reproduced" || !line.starts_with(number.claim + ',' + number.id + ','))
        continue;
      const std::string as_printed = ',' + number.printed + ',' + number.rule + ',';
      const auto at = line.find(as_printed);
      ASSERT_NE(at, std::string::npos) << line;
      const double right = number.readings.front().converged.value();
      line.replace(at, as_printed.size(), fmt::format(",{:.3g},digits,", right));
      ids.insert(number.id);
    }
    changed += line + '\n';
  }
  write("claims.csv", changed);
  std::filesystem::copy_file(ROTOR_REFERENCE_DATA "/ensembles.csv", folder_ / "ensembles.csv");
  EXPECT_GT(ids.size(), 20U);
  for (const Number& number : judged_numbers(folder_)) {
    if (!ids.contains(number.id)) continue;
    EXPECT_EQ(number.verdict, "reproduced") << number.id;
    EXPECT_NE(number.verdict, number.expected_verdict) << number.id;
  }
}

TEST(Claims, HaveTheFirstVerdictThatAppliesByAnyReading) {
  const Spread outside{.draws = 1, .median = 4, .low = 3, .high = 5, .share = 0};
  const Spread overlapping{.draws = 1, .median = 3, .low = 1.9, .high = 4, .share = 0.1};
  const auto verdict = [&](Kind kind, double converged, double by_rk4, const Spread& times,
                           const Spread& everything) {
    Number number;
    number.kind = kind;
    number.allowed = {1, 2};
    number.readings = {{"other", 9, {}, outside, outside},
                       {"this", converged, by_rk4, times, everything}};
    return verdict_of(number);
  };
  const auto simulated = Kind::simulated;
  EXPECT_EQ(verdict(simulated, 1.5, 3, outside, outside), "reproduced");
  EXPECT_EQ(verdict(simulated, 3, 1.5, outside, outside), "reproduced");
  EXPECT_EQ(verdict(simulated, 3, 3, overlapping, outside), "within rounding");
  EXPECT_EQ(verdict(simulated, 3, 3, outside, overlapping), "within rounding");
  EXPECT_EQ(verdict(simulated, 3, 3, outside, outside), "refuted");
  for (const Kind at_printed_numbers : {Kind::arithmetic, Kind::method})
    EXPECT_EQ(verdict(at_printed_numbers, 3, 3, overlapping, overlapping), "refuted");
}

TEST(Claims, HaveTheWorstVerdictOfTheirNumbers) {
  const auto number = [](const char* claim, const char* verdict) {
    Number n;
    n.claim = claim;
    n.verdict = verdict;
    return n;
  };
  const auto verdicts = verdicts_of_claims(
      {number("a", "reproduced"), number("b", "within rounding"), number("b", "reproduced"),
       number("c", "within rounding"), number("c", "refuted"), number("c", "reproduced")});
  EXPECT_EQ(verdicts.at("a"), "reproduced");
  EXPECT_EQ(verdicts.at("b"), "within rounding");
  EXPECT_EQ(verdicts.at("c"), "refuted");
}

TEST(Claims, OfArithmeticHaveNoEnsembleAndEmptyCellsForIt) {
  const std::string csv = to_csv(judged());
  EXPECT_NE(csv.find(",speed_rad,942.478,942.478,,,,,,,,,,,"), std::string::npos);
  const auto drawn = readings_to_draw(judged());
  EXPECT_EQ(std::ranges::count(drawn, "speed_rad"), 0);
  EXPECT_EQ(std::ranges::count(drawn, "whirl_off"), 0);
  EXPECT_EQ(std::ranges::count(drawn, "peak_kN"), 1);
}

TEST(Claims, ArePrintedFigureByFigureThenSectionBySectionWithTheirNumbersBelow) {
  const std::string table = claims_table(judged());
  std::size_t last = 0;
  for (const char* heading : {"Fig. 2", "Fig. 3", "Fig. 12", "Fig. 17", "Nomenclature", "Sec. 2.2",
                              "Sec. 2.3", "Sec. 3", "Eq. (27)", "Sec. 4"}) {
    const std::size_t at = table.find('\n' + std::string(heading) + '\n');
    EXPECT_NE(at, std::string::npos) << heading;
    EXPECT_GT(at, last) << heading;
    last = at;
  }
  const std::size_t claim = table.find("  stiffness: refuted, as the worst of\n");
  ASSERT_NE(claim, std::string::npos);
  const std::size_t force = table.find("change of the largest force by twice and half k_t");
  EXPECT_GT(force, claim);
  EXPECT_GT(table.find("change of the time to rolling by twice and half k_t"), force);
}

TEST(Claims, AreNoneAboutTheTrajectoriesAndTheBeginningOfFig14) {
  EXPECT_TRUE(std::ranges::includes(figures_without_claim(judged()), std::vector{8, 9, 15, 16}));
  const std::string table = claims_table(judged());
  for (const Number& number : judged())
    EXPECT_NE(table.find(number.says), std::string::npos) << number.id;
}

}  // namespace
}  // namespace rotor
