/// The claims of the paper's text, their verdicts, and the rules that lead to them.
#include "verification/paper/claims.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "verification/paper/readings.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/read_csv.hpp"

namespace rotor {
namespace {

constexpr std::size_t published = 0, corrected = 1;

TEST(Claims, HaveTheVerdictsThatTheTableStates) {
  for (const Number& number : judged())
    for (const std::size_t set : {published, corrected}) {
      const Verdict verdict = verdict_of(number, set);
      EXPECT_EQ(verdict.verdict, number.expected[set])
          << number.id << ' ' << sets[set].name << ' ' << verdict.off_a << ' ' << verdict.off_b;
    }
}

TEST(Claims, ThatAreNotReproducedHaveAReason) {
  for (const Number& number : judged())
    EXPECT_EQ(number.reason.empty(), verdict_of(number, published).verdict == "reproduced")
        << number.id;
}

TEST(Claims, StandOnceAndUseEveryReading) {
  std::set<std::string> ids, used;
  for (const Number& number : judged()) {
    EXPECT_TRUE(ids.insert(number.id).second) << number.id;
    for (const Reading& reading : number.readings) used.insert(reading.name);
  }
  for (const std::string& reading : all_readings()) EXPECT_TRUE(used.contains(reading)) << reading;
}

// A correct paper must not be refuted.
TEST(Claims, ThatAreNotReproducedWouldBeIfThePaperPrintedWhatItsEquationsGive) {
  int changed = 0;
  for (Number number : judged()) {
    if (verdict_of(number, published).verdict == "reproduced") continue;
    const Reading::InSet& in = number.readings.front().in[published];
    number.printed =
        fmt::format("{:.4g}", number.is_drawn() ? in.a.spread.median : in.converged.value());
    number.rule = "digits";
    number.decides = {};
    EXPECT_EQ(verdict_of(number, published).verdict, "reproduced") << number.id;
    ++changed;
  }
  EXPECT_GT(changed, 15);
}

// By a hundredth of the tolerance; two runs never agree to the bit.
TEST(Claims, DependOnTheToleranceAHundredTimesLessThanOnThePrintedDigits) {
  PaperInputs inputs;
  inputs.spec.numbers["tolerance"] = Scenario{}.tolerance / 100;
  PaperRuns finer(inputs);
  int compared = 0;
  for (const Number& number : judged()) {
    const Reading& reading = number.readings.front();
    const auto& [converged, by_rk4, a, b] = reading.in[published];
    const double range = b.spread.high - b.spread.low;
    if (number.kind != Kind::simulated || !converged || !(range > 0)) continue;
    ++compared;
    const double change = std::abs(read_off(reading.name, finer).value() - *converged);
    EXPECT_LT(change, range / 200) << number.id;
    if (number.id != "peak_force") continue;
    EXPECT_GT(change, 0);
    EXPECT_LT(change / *converged, 1e-11);
  }
  EXPECT_GT(compared, 50);
}

Stored stored(double low, double median, double high, double valued = 1) {
  return {{.draws = 1, .valued = valued, .median = median, .low = low, .high = high}, 0};
}

Number number(const char* printed, const char* rule, const Stored& a, const Stored& b) {
  Number made;
  made.printed = printed;
  made.rule = rule;
  made.readings = {{"this", {}}};
  made.readings[0].in[published] = {a.spread.median, {}, a, b};
  return made;
}

// The same criterion for a number of two digits and for a word, which allow the same.
TEST(Verdicts, FollowFromTheMedianOfTheFirstPopulationAndTheRangeOfTheSecond) {
  for (const auto& [printed, rule, half] :
       {std::tuple("0", "minor", 10.), {"0.0", "digits", 0.05}}) {
    const auto verdict = [&, p = printed, r = rule, h = half](double median, double nearest) {
      const auto range = [&](double near, double middle) {
        return near > 0 ? stored(near * h, middle * h, 9 * h)
                        : stored(-9 * h, middle * h, near * h);
      };
      return verdict_of(number(p, r, range(0.9 * median, median), range(nearest, 5)), published);
    };
    for (const double side : {-1., 1.}) {  // below what is allowed, and above it
      EXPECT_EQ(verdict(side * 0.9, side * 3).verdict, "reproduced") << rule;
      EXPECT_EQ(verdict(side * 3, side * 0.9).verdict, "within rounding") << rule;
      const Verdict refuted = verdict(side * 3, side * 1.1);
      EXPECT_EQ(refuted.verdict, "refuted") << rule;
      EXPECT_NEAR(refuted.off_a, 3, 1e-12);
      EXPECT_NEAR(refuted.off_b, 1.1, 1e-12);
    }
  }
}

TEST(Verdicts, TakeThePapersMethodAndNeedValues) {
  const Stored good = stored(-1, 0, 1), bad = stored(30, 40, 50);
  Number judged = number("", "minor", bad, bad);
  EXPECT_EQ(verdict_of(judged, published).verdict, "refuted");
  judged.readings[0].in[published].by_rk4 = 10;
  EXPECT_EQ(verdict_of(judged, published).verdict, "reproduced");
  EXPECT_EQ(verdict_of(number("", "minor", stored(-1, 0, 1, 0.4), good), published).verdict,
            "within rounding");
  EXPECT_EQ(
      verdict_of(number("", "minor", stored(-1, 0, 1, 0.04), stored(-1, 0, 1, 0.04)), published)
          .verdict,
      "refuted");
}

// One number holds in the first reading, the other one in the second, and never both.
TEST(Verdicts, TakeOneReadingForAllNumbersOfASentence) {
  const Stored good = stored(-1, 0, 1), bad = stored(30, 40, 50), near = stored(9, 40, 50);
  const auto of = [](const Stored& first, const Stored& second, const char* sentence) {
    Number made = number("", "minor", first, first);
    made.readings.push_back(number("", "minor", second, second).readings[0]);
    made.claim = made.sentence = sentence;
    return made;
  };
  const auto verdicts_of = [](std::vector<Number> numbers, const Judging& judging = {}) {
    choose_readings(numbers);
    std::vector<std::string> verdicts;
    for (const Number& one : numbers)
      verdicts.push_back(verdict_of(one, published, judging).verdict);
    return verdicts;
  };
  using Verdicts = std::vector<std::string>;
  const Number first = of(good, bad, "one"), second = of(bad, good, "one");
  EXPECT_EQ(verdicts_of({first, second}), Verdicts({"reproduced", "refuted"}));
  EXPECT_EQ(verdicts_of({first, of(bad, good, "another")}), Verdicts({"reproduced", "reproduced"}));
  EXPECT_EQ(verdicts_of({first, of(near, bad, "one")}),
            Verdicts({"reproduced", "within rounding"}));
  EXPECT_EQ(verdicts_of({first, of(bad, near, "one")}), Verdicts({"reproduced", "refuted"}));
  // A number with one reading has that one, whatever the others have.
  EXPECT_EQ(verdicts_of({second, of(bad, good, "one"), number("", "minor", good, good)}),
            Verdicts({"reproduced", "reproduced", "reproduced"}));
  EXPECT_EQ(verdicts_of({first}, {.by = Judging::By::second}), Verdicts({"refuted"}));
  EXPECT_EQ(verdicts_of({first}, {.by = Judging::By::every}), Verdicts({"refuted"}));

  std::vector<Number> single = {first};
  choose_readings(single);
  const std::vector<Turned> turned = turned_by_other_rules(single);
  ASSERT_EQ(turned.size(), 1U);  // in the other set there are no values at all
  EXPECT_EQ(turned[0].verdict, "reproduced");
  EXPECT_EQ(turned[0].others, Verdicts({"refuted: every reading must hold",
                                        "refuted: the second reading for the whole text"}));
}

// Each rule turns a number of its own: 404 for a printed 400, a change of 4.9 % of at most 5 %, a
// change whose lowest 5 % of draws are small, and a number that can be read as another one.
TEST(Verdicts, DependOnTheRulesThatTurnThem) {
  Number zeros = number("400", "digits", stored(404, 404, 404), stored(404, 404, 404));
  Number limit = number("", "agrees", stored(4.9, 4.9, 4.9), stored(4.9, 4.9, 4.9));
  Number lucky = number("", "minor", stored(30, 30, 30), stored(9, 20, 30));
  Number read = number("", "minor", stored(30, 30, 30), stored(30, 30, 30)),
         as_another = number("", "minor", stored(1, 1, 1), stored(1, 1, 1));
  zeros.claim = zeros.id = "zeros", limit.claim = limit.id = "limit";
  lucky.claim = lucky.id = "lucky", read.claim = read.id = "read";
  as_another.claim = "read", as_another.id = "another", as_another.instead = "read";
  as_another.says = "another number";
  const std::vector<Number> all = {zeros, limit, lucky, read, as_another};
  std::map<std::string, std::vector<std::string>> others;
  for (const Turned& turned : turned_by_other_rules(all))
    if (turned.set == published) others[turned.number.id] = turned.others;
  using Says = std::vector<std::string>;
  EXPECT_EQ(others.at("zeros"), Says({"refuted: zeros of whole numbers count"}));
  EXPECT_EQ(others.at("limit"),
            Says({"refuted: half the widths of words", "refuted: limits 5 % narrower"}));
  EXPECT_EQ(others.at("lucky"),
            Says({"refuted: half the widths of words", "refuted: the medians of changes"}));
  EXPECT_EQ(others.at("read"), Says({"reproduced: another number"}));
  EXPECT_EQ(others.size(), 4U);
  for (const auto& [claim, verdict] : settled_verdicts(all, published))
    EXPECT_EQ(verdict, "depends") << claim;
  EXPECT_EQ(settled_verdicts({as_another, read}, published).size(), 1U);
  EXPECT_EQ(settled_verdicts({read}, published).at("read"), "refuted");
}

// The readings of the numbers that belong together are matched by their order.
TEST(Claims, HaveTheReadingsOfASentenceInOneOrder) {
  for (const Number& number : judged())
    for (std::size_t n = 0; n < number.readings.size(); ++n)
      for (const auto& [word, place] : {std::pair("onset_", 0U),
                                        {"peak_", 1U},
                                        {"_last_but_one", 1U},
                                        {"_5_ms", 0U},
                                        {"_turn", 1U}})
        if (number.readings.size() > 1 && number.readings[n].name.find(word) != std::string::npos &&
            number.id != "onset_at_peak") {
          EXPECT_EQ(n, place) << number.id;
        }
}

TEST(Verdicts, OfClaimsAreTheWorstOfTheirNumbersAndChangeWithTheWidthOfWords) {
  Number good = number("", "minor", stored(0, 4, 6), stored(0, 4, 6));
  Number bad = number("", "minor", stored(11, 12, 13), stored(11, 12, 13));
  good.claim = bad.claim = "both";
  const auto worst = [&](double word_width_factor) {
    return verdicts_of_claims({good, bad}, published, {.word_width_factor = word_width_factor})
        .at("both");
  };
  EXPECT_EQ(worst(1), "refuted");
  EXPECT_EQ(worst(2), "reproduced");
  bad.readings[0].in[published].b = stored(9, 12, 13);
  EXPECT_EQ(worst(1), "within rounding");
  EXPECT_EQ(worst(0.5), "refuted");
}

TEST(Policy, TakesHalfAUnitOfTheLastDigit) {
  for (const auto& [printed, half] : {std::pair("0.283", 0.0005),
                                      {"237", 0.5},
                                      {"4000", 50.},
                                      {"150", 5.},
                                      {"8.91e-3", 0.5e-5},
                                      {"1e-4", 0.5e-4},
                                      {"10", 0.5}})
    EXPECT_NEAR(half_digit(printed) / half, 1, 1e-12) << printed;
  EXPECT_EQ(half_digit("4000", true), 0.5);
  EXPECT_EQ(half_digit("8.91e-3", true), half_digit("8.91e-3"));
}

// As many claims of each kind as verdicts are given for, and apart from them every trend.
TEST(Claims, AreListedByTheirKindWithTheirNumber) {
  const auto trends = read_csv(ROTOR_REFERENCE_DATA "/reasons.csv");
  std::istringstream list(claims_list(judged(), trends));
  std::map<std::string, long> stated, listed;
  std::string line, kind;
  while (std::getline(list, line))
    if (line.starts_with("  "))
      ++listed[kind];
    else if (!line.empty())
      stated[kind = line.substr(line.find(' '))] = std::stol(line);
  EXPECT_EQ(stated, listed);
  std::map<bool, long> verdicts;
  for (const auto& [claim, verdict] : settled_verdicts(judged(), 0))
    ++verdicts[is_arithmetic(judged(), claim)];
  std::multiset<long> counts,
      expected = {verdicts[false], verdicts[true], static_cast<long>(trends.size())};
  for (const auto& [of, count] : listed) counts.insert(count);
  EXPECT_EQ(counts, expected);
}

/// The numbers that policy.md has in the row of a rule.
std::map<std::string, std::vector<double>> numbers_of_rules() {
  std::ifstream file(ROTOR_REFERENCE_DATA "/policy.md");
  std::map<std::string, std::vector<double>> rules;
  for (std::string line; std::getline(file, line);)
    for (const Match& row : matches(line, "^\\| `(\\w+)` \\| (.*) \\|$")) {
      std::vector<double>& numbers = rules[row[1]];
      for (const Match& one : matches(row[2], "[0-9]+(\\.[0-9]+)?"))
        numbers.push_back(std::stod(one[0]));
    }
  return rules;
}

TEST(Policy, AllowsTheNumbersOfItsTableAndHasNoOtherRule) {
  const auto rules = numbers_of_rules();
  std::set<std::string> used;
  for (const Number& number : judged()) {
    used.insert(number.rule);
    EXPECT_TRUE(rules.contains(number.rule)) << number.rule;
  }
  EXPECT_EQ(used.size(), rules.size());
  for (const char* rule : {"minor", "slight", "negligible", "agrees", "unchanged"}) {
    EXPECT_EQ(allowed("", rule).middle, 0);
    EXPECT_EQ(allowed("", rule).half, rules.at(rule).at(0)) << rule;
  }
  EXPECT_EQ(allowed("", "few").least(), rules.at("few").at(0));
  EXPECT_EQ(allowed("", "few").greatest(), rules.at("few").at(1));
  EXPECT_EQ(allowed("", "major").least(), rules.at("major").at(0));
  EXPECT_TRUE(allowed("", "major").holds(1e6));  // a change, of which 100 % is no limit
  EXPECT_NEAR(allowed("770", "about").half, 7.7 * rules.at("about").at(0), 1e-9);
  EXPECT_NEAR(allowed("0.02", "about").half, 0.005, 1e-12);  // whose digit allows more
  EXPECT_NEAR(allowed("1e-4 to 3e-4", "range").least(), 0.5e-4, 1e-12);
  EXPECT_NEAR(allowed("0.9 to 1.25", "range").least(), 0.85, 1e-12);  // each by its own digits
  EXPECT_NEAR(allowed("0.9 to 1.25", "range").greatest(), 1.255, 1e-12);
  EXPECT_FALSE(allowed("1", "is").holds(0));
  EXPECT_THROW(allowed("1", "roughly"), std::invalid_argument);
  EXPECT_THROW(allowed("one", "digits"), std::invalid_argument);
}

TEST(PrintedInputs, AreTheNomenclaturesWithHalfAUnitOfTheirLastDigit) {
  const Scenario printed;
  int own_digits = 0;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/printed-inputs.csv")) {
    const double least = static_cast<double>(row.number("least")),
                 greatest = static_cast<double>(row.number("greatest"));
    const double value = std::stod(row["printed"]);
    PaperInputs inputs;
    inputs.set(row["input"], value);
    if (const InputQuantity* const input_quantity = find_input_quantity(row["input"]);
        input_quantity && input_quantity->quantity.in) {
      EXPECT_NEAR(input_quantity->quantity.of(printed) / value, 1, 1e-12) << row["input"];
    }
    EXPECT_LT(least, value);
    EXPECT_GT(greatest, value);
    if (!row["why"].empty()) continue;
    ++own_digits;
    EXPECT_NEAR(greatest - least, 2 * half_digit(row["printed"]), 1e-9 * value) << row["input"];
  }
  EXPECT_GE(own_digits, 15);
  const auto ranges = read_input_ranges(ROTOR_REFERENCE_DATA "/printed-inputs.csv");
  const auto operating = std::ranges::find(ranges, "motor_off_hz", &InputRange::input);
  const double as_written = 0.005;
  EXPECT_NEAR(operating->least, (150 * two_pi - 0.5) / two_pi, as_written);
  EXPECT_NEAR(operating->greatest, 943.5 / two_pi, as_written);
}

}  // namespace
}  // namespace rotor
