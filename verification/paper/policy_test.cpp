/// The rules of reference-data/policy.md, and what they make of the printed inputs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <regex>
#include <set>

#include "figures/data/csv.hpp"
#include "verification/paper/judged.hpp"

namespace rotor {
namespace {

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
