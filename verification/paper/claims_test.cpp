/// The claims of the paper's text, and the rules by which they are judged.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <regex>
#include <set>

#include "figures/data/csv.hpp"
#include "verification/paper/claims_table.hpp"
#include "verification/paper/judged.hpp"
#include "verification/support/in_folder.hpp"

namespace rotor {
namespace {

/// The share of draws that have a value.
double values_share(const std::vector<double>& values) {
  return spread(values, [](double value) { return !std::isnan(value); }).share;
}

class ClaimsInFolder : public InFolder {};

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

/// What policy.md says of a rule.
std::string policy_of(const std::string& rule) {
  std::ifstream file(ROTOR_REFERENCE_DATA "/policy.md");
  const std::string head = "| `" + rule + "` | ";
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(head)) return line.substr(head.size());
  ADD_FAILURE() << "policy.md has no rule " << rule;
  return {};
}

/// The numbers in a text.
std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex number("[0-9]+(\\.[0-9]+)?");
  return {std::sregex_token_iterator(text.begin(), text.end(), number), {}};
}

void expect_allowed(const std::string& printed, const std::string& rule, double least,
                    double greatest) {
  const Allowed found = allowed(printed, rule);
  EXPECT_NEAR(found.least, least, 1e-12) << printed << ' ' << rule;
  EXPECT_NEAR(found.greatest, greatest, 1e-12) << printed << ' ' << rule;
}

TEST(Policy, AllowsTheNumbersOfItsTable) {
  for (const char* rule : {"minor", "slight", "negligible", "agrees", "unchanged"}) {
    const auto found = numbers_in(policy_of(rule));
    ASSERT_EQ(found.size(), 1U) << rule;
    expect_allowed("", rule, -std::stod(found[0]), std::stod(found[0]));
  }
  const auto few = numbers_in(policy_of("few"));
  expect_allowed("", "few", std::stod(few.at(0)), std::stod(few.at(1)));
  const double half = std::stod(numbers_in(policy_of("major")).at(0));
  EXPECT_FALSE(allowed("", "major").holds(half - 1e-9));
  EXPECT_TRUE(allowed("", "major").holds(half + 1e-9));
  const double about = std::stod(numbers_in(policy_of("about")).at(0)) / 100;
  expect_allowed("770", "about", 770 * (1 - about), 770 * (1 + about));
  expect_allowed("0.02", "about", 0.015, 0.025);  // whose digit allows more
  const std::string digits = policy_of("digits");
  static const std::regex example("([0-9]+) is ([0-9.]+) to ([0-9.]+)");
  int examples = 0;
  for (std::sregex_iterator at(digits.begin(), digits.end(), example), end; at != end; ++at) {
    expect_allowed((*at)[1], "digits", std::stod((*at)[2]), std::stod((*at)[3]));
    ++examples;
  }
  EXPECT_EQ(examples, 3);
  expect_allowed("400-450", "range", 395, 455);
  expect_allowed("-1", "is", -1, -1);
  EXPECT_THROW(allowed("1", "roughly"), std::invalid_argument);
  EXPECT_THROW(allowed("one", "digits"), std::invalid_argument);
}

TEST(Policy, SaysTheStandardErrorOfAShare) {
  std::ifstream file(ROTOR_REFERENCE_DATA "/policy.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto draws = static_cast<double>(judged().back().readings.front().everything.draws);
  ASSERT_EQ(draws, 10000);
  EXPECT_NE(
      text.find(fmt::format("a share of 10,000 runs is {:.1f} % at most", 50 / std::sqrt(draws))),
      std::string::npos);  // where half of them hold
}

TEST(Policy, HasEveryRuleThatTheTableUsesAndNoOther) {
  std::set<std::string> used;
  for (const Number& number : judged()) used.insert(number.rule);
  std::ifstream file(ROTOR_REFERENCE_DATA "/policy.md");
  std::set<std::string> rules;
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("| `")) rules.insert(line.substr(3, line.find('`', 3) - 3));
  EXPECT_EQ(rules, used);
}

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
  std::set<std::string> ids, used;
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

TEST(Claims, AreNoneAboutTheTrajectoriesAndTheBeginningOfFig14) {
  EXPECT_EQ(figures_without_claim(judged()), (std::vector{8, 9, 15, 16}));
  const std::string table = claims_table(judged());
  EXPECT_NE(table.find("nothing is claimed about Figs. 8, 9, 15, 16, which is no success"),
            std::string::npos);
  for (const Number& number : judged())
    EXPECT_NE(table.find(number.says), std::string::npos) << number.id;
}

// A part of the stored ensembles, drawn anew: shares within three standard errors.
TEST(Ensembles, AreWhatRunsGive) {
  const auto inputs = std::filesystem::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv";
  for (const auto& [rounded, count] :
       {std::pair(Rounded::times, 40L), {Rounded::everything, 120L}}) {
    const Draws draws = draw(readings_to_draw(judged()), inputs, rounded, count, 2);
    for (const Number& number : judged())
      for (const Reading& reading : number.readings) {
        if (number.kind != Kind::simulated) continue;
        const Spread stored = rounded == Rounded::times ? reading.times : reading.everything;
        const Spread anew = spread(draws.at(reading.name),
                                   [&](double value) { return number.allowed.holds(value); });
        const auto n = static_cast<double>(count);
        const double deviation = std::sqrt(stored.share * (1 - stored.share) / n);
        EXPECT_NEAR(anew.share, stored.share, 3 * deviation + 1 / n) << number.id << reading.name;
        if (std::isfinite(stored.low)) {  // nine of ten lie between the quantiles
          const Spread inside = spread(draws.at(reading.name), [&](double value) {
            const double rounding = 1e-5 * std::abs(value);  // of six digits
            return stored.low - rounding <= value && value <= stored.high + rounding;
          });
          EXPECT_GT(
              inside.share + 3 * std::sqrt(0.09 / n) + (1 - values_share(draws.at(reading.name))),
              0.9)
              << number.id << reading.name;
        }
      }
  }
}

TEST(Ensembles, DoNotDependOnTheNumberOfThreads) {
  const auto inputs = std::filesystem::path(ROTOR_REFERENCE_DATA) / "printed-inputs.csv";
  const Draws one = draw(readings_to_draw(judged()), inputs, Rounded::everything, 3, 1);
  const Draws two = draw(readings_to_draw(judged()), inputs, Rounded::everything, 3, 2);
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
  const auto ranges = read_input_ranges(ROTOR_REFERENCE_DATA "/printed-inputs.csv");
  const auto operating = std::ranges::find(ranges, "motor_off_hz", &InputRange::input);
  const double rad_s = 2 * std::numbers::pi, as_written = 0.005;
  EXPECT_NEAR(operating->least, (150 * rad_s - 0.5) / rad_s, as_written);
  EXPECT_NEAR(operating->greatest, 943.5 / rad_s, as_written);
}

}  // namespace
}  // namespace rotor
