/// The claims of the paper's text, their verdicts, and the rules that lead to them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "figures/data/read_csv.hpp"
#include "verification/paper/readings.hpp"
#include "verification/paper/tally.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

using enum Verdict;

constexpr std::size_t published = 0, corrected = 1;

TEST(Claims, HaveTheVerdictsThatTheTableStates) {
  for (const Number& number : judged())
    for (const std::size_t set : {published, corrected}) {
      const Judgement judgement = judgement_on(number, set);
      EXPECT_EQ(judgement.verdict, number.expected[set])
          << number.id << ' ' << sets[set].name << ' ' << judgement.off_a << ' ' << judgement.off_b;
    }
}

TEST(Claims, ThatAreNotReproducedHaveAReason) {
  for (const Number& number : judged())
    EXPECT_EQ(number.reason.empty(), verdict_of(number, published) == reproduced) << number.id;
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
    if (verdict_of(number, published) == reproduced) continue;
    const Reading::InSet& in = number.readings.front().in[published];
    number.printed =
        fmt::format("{:.4g}", number.is_drawn() ? in.a.spread.median : in.converged.value());
    number.rule = "digits";
    number.decides = {};
    EXPECT_EQ(verdict_of(number, published), reproduced) << number.id;
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

/// The printed inputs with all times doubled so often, without rounding.
PaperInputs slowed_down(int doublings) {
  static const std::map<std::string, int> power_of_time = {
      {"", 0},   {"kg", 0},   {"kg m^2", 0}, {"m", 0},      {"s", 1},     {"Hz", -1},
      {"J", -2}, {"N m", -2}, {"N/m", -2},   {"N s/m", -1}, {"m/s^2", -2}};
  PaperInputs inputs;
  for (const char* table : {"/printed-inputs.csv", "/printed-results.csv"})
    for (const CsvRow& row : read_csv(std::string(ROTOR_REFERENCE_DATA) + table))
      inputs.set(row["input"],
                 std::ldexp(std::stod(row["printed"]), doublings * power_of_time.at(row["unit"])));
  return inputs;
}

// An exactly similar rotor has a quarter of the force, and no claim about a ratio changes.
TEST(Claims, AboutARatioHoldOfASimilarRotorAsWell) {
  for (const Set& set : sets) {
    PaperInputs printed = slowed_down(0), slower = slowed_down(1);
    printed.spec.equations = slower.spec.equations = set.equations;
    PaperRuns here(printed), there(slower);
    for (const double part : {1., 0.5}) {
      const PaperRun &run = here.from_steady(part), &similar = there.from_steady(part);
      EXPECT_NEAR(*similar.summary().peak_normal_force_N * 4 / *run.summary().peak_normal_force_N,
                  1, 1e-6);
      EXPECT_NEAR(*similar.relative_peak() / *run.relative_peak(), 1, 1e-6);
    }
    for (const Number& number : of_claim(judged(), "ratio"))
      for (const Reading& reading : number.readings) {
        const double value = read_off(reading.name, here).value();
        EXPECT_NEAR(read_off(reading.name, there).value(), value, 1e-6 * std::abs(value) + 1e-9)
            << reading.name;
      }
    // The change that is judged is that of what is the same in similar rotors.
    EXPECT_NEAR(read_off("force_by_ratio", here).value(),
                100 * std::abs(*here.from_steady(0.5).relative_peak() /
                                   *there.from_steady(1).relative_peak() -
                               1),
                1e-3);
  }
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
      return judgement_on(number(p, r, range(0.9 * median, median), range(nearest, 5)), published);
    };
    for (const double side : {-1., 1.}) {  // below what is allowed, and above it
      EXPECT_EQ(verdict(side * 0.9, side * 3).verdict, reproduced) << rule;
      EXPECT_EQ(verdict(side * 3, side * 0.9).verdict, within_rounding) << rule;
      const Judgement missed = verdict(side * 3, side * 1.1);
      EXPECT_EQ(missed.verdict, refuted) << rule;
      EXPECT_NEAR(missed.off_a, 3, 1e-12);
      EXPECT_NEAR(missed.off_b, 1.1, 1e-12);
    }
  }
}

TEST(Verdicts, TakeThePapersMethodAndNeedValues) {
  const Stored good = stored(-1, 0, 1), bad = stored(30, 40, 50);
  Number judged = number("", "minor", bad, bad);
  EXPECT_EQ(verdict_of(judged, published), refuted);
  judged.readings[0].in[published].by_rk4 = 10;
  EXPECT_EQ(verdict_of(judged, published), reproduced);
  EXPECT_EQ(verdict_of(number("", "minor", stored(-1, 0, 1, 0.4), good), published),
            within_rounding);
  EXPECT_EQ(
      verdict_of(number("", "minor", stored(-1, 0, 1, 0.04), stored(-1, 0, 1, 0.04)), published),
      refuted);
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
    std::vector<Verdict> verdicts;
    for (const Number& one : numbers) verdicts.push_back(verdict_of(one, published, judging));
    return verdicts;
  };
  using Verdicts = std::vector<Verdict>;
  const Number first = of(good, bad, "one"), second = of(bad, good, "one");
  EXPECT_EQ(verdicts_of({first, second}), Verdicts({reproduced, refuted}));
  EXPECT_EQ(verdicts_of({first, of(bad, good, "another")}), Verdicts({reproduced, reproduced}));
  EXPECT_EQ(verdicts_of({first, of(near, bad, "one")}), Verdicts({reproduced, within_rounding}));
  EXPECT_EQ(verdicts_of({first, of(bad, near, "one")}), Verdicts({reproduced, refuted}));
  // A number with one reading has that one, whatever the others have.
  EXPECT_EQ(verdicts_of({second, of(bad, good, "one"), number("", "minor", good, good)}),
            Verdicts({reproduced, reproduced, reproduced}));
  EXPECT_EQ(verdicts_of({first}, {.by = Judging::By::second}), Verdicts({refuted}));
  EXPECT_EQ(verdicts_of({first}, {.by = Judging::By::every}), Verdicts({refuted}));

  std::vector<Number> single = {first};
  choose_readings(single);
  EXPECT_EQ(verdict_of(single[0], published), reproduced);
  EXPECT_EQ(other_verdicts(single[0], published, single),
            std::vector<std::string>({"refuted: every reading must hold",
                                      "refuted: the second reading for the whole text"}));
  EXPECT_EQ(other_verdicts(single[0], corrected, single),
            std::vector<std::string>());  // there are no values
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
  as_another.claim = "read", as_another.id = "another", as_another.alternative_to = "read";
  as_another.says = "another number";
  const std::vector<Number> all = {zeros, limit, lucky, read, as_another};
  using Says = std::vector<std::string>;
  EXPECT_EQ(other_verdicts(zeros, published, all), Says({"refuted: zeros of whole numbers count"}));
  EXPECT_EQ(other_verdicts(limit, published, all),
            Says({"refuted: half the widths of words", "refuted: limits 5 % narrower"}));
  EXPECT_EQ(other_verdicts(lucky, published, all),
            Says({"refuted: half the widths of words", "refuted: the medians of changes"}));
  EXPECT_EQ(other_verdicts(read, published, all), Says({"reproduced: another number"}));
  const auto claims = judged_claims(all, published);
  EXPECT_EQ(claims.size(), 4U);
  for (const JudgedClaim& claim : claims)
    EXPECT_EQ(claim.turned_by.size(),
              other_verdicts(of_claim(all, claim.claim).front(), published, all).size())
        << claim.claim;
  EXPECT_TRUE(judged_claims({read}, published).front().turned_by.empty());
  EXPECT_EQ(in_words(tally(claims)),
            "2 reproduced (0 turned by no other rule), 1 within rounding (0), 1 refuted (0)");
  EXPECT_EQ(in_words(tally(judged_claims({read}, published))),
            "1 refuted (1 turned by no other rule)");
  EXPECT_EQ(in_words({}), "nothing is claimed");
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
  EXPECT_EQ(worst(1), refuted);
  EXPECT_EQ(worst(2), reproduced);
  bad.readings[0].in[published].b = stored(9, 12, 13);
  EXPECT_EQ(worst(1), within_rounding);
  EXPECT_EQ(worst(0.5), refuted);
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
    else if (!line.empty() && line.find(':') + 1 == line.size())
      stated[kind = line.substr(line.find(' '))] = std::stol(line);
  EXPECT_EQ(stated, listed);
  std::map<bool, long> verdicts;
  for (const JudgedClaim& of : judged_claims(judged(), published))
    ++verdicts[is_arithmetic(judged(), of.claim)];
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
  const auto operating = std::ranges::find(ranges, "motor_off_Hz", &InputRange::input);
  const double as_written = 0.005;
  EXPECT_NEAR(operating->least, (150 * two_pi - 0.5) / two_pi, as_written);
  EXPECT_NEAR(operating->greatest, 943.5 / two_pi, as_written);
}

}  // namespace
}  // namespace rotor
