/// Runs to a number of significant digits: not one may be false.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "figures/data/csv.hpp"
#include "figures/scenes/certain_account.hpp"
#include "figures/scenes/names.hpp"
#include "verification/support/certain_digits.hpp"
#include "verification/support/figure_list.hpp"
#include "verification/support/reference_tables.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

const GoesOn always = [](double /*time_s*/) { return true; };

/// For so many steps, of which quadruple precision takes some thousands a second.
GoesOn for_steps(long most) {
  return [most, n = 0L](double /*time_s*/) mutable { return ++n < most; };
}

struct KnownRun {
  Scenario scenario;
  KnownValues values;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Thirty random runs for which the rule was not made, and six that earlier rules got wrong.
std::vector<KnownRun> known_runs() {
  std::ifstream file(ROTOR_REFERENCE_DATA "/random-runs.csv");
  std::vector<std::string> names;
  std::vector<KnownRun> runs;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    KnownRun& run = runs.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto quantity = std::ranges::find(quantities(), names[i], &Quantity::name);
      if (quantity != quantities().end())
        quantity->in(run.scenario) = std::stod(cells[i]);
      else if (names[i] == "equations")
        run.scenario.equations = parse_equations(cells[i]);
      else if (!cells[i].empty())
        run.values[names[i]] = std::stod(cells[i]);
    }
  }
  return runs;
}

class Digits : public testing::TestWithParam<int> {};

TEST_P(Digits, OfRandomAndOfHardRunsAreAllTrue) {
  const int digits = GetParam();
  const std::vector<KnownRun> runs = known_runs();
  ASSERT_EQ(runs.size(), 36U);
  double worst = 0;
  long had = 0;
  for (std::size_t n = 0; n < runs.size(); ++n) {
    const auto found = run_to_digits(runs[n].scenario, digits, for_steps(3'000));
    if (!found) continue;
    EXPECT_EQ(falsehood(*found, digits, runs[n].values, worst), "") << n;
    had += has_digits(*found, digits);
  }
  // Some take more steps than a test can wait for.
  EXPECT_GE(had, digits == 12 ? 15 : digits == 9 ? 24 : 28);
  EXPECT_GT(worst, 1e-4) << "the errors say nothing";
}

INSTANTIATE_TEST_SUITE_P(Numbers, Digits, testing::Values(3, 6, 9, 12));

// The default tolerance leaves five or six digits of q2 there: contacts multiply rounding by 1e6.
TEST(ManyDigits, AreHadWhereContactsMultiplyRounding) {
  const double exact = 1.5661519430597e-3;  // in quadruple precision at a tolerance of 1e-19
  Scenario scenario{.parameters = {.friction = 0.05}};
  scenario.until = 29.23;
  EXPECT_LT(std::abs(summary_of(scenario).final_q2_m / exact - 1), 1e-5);
  EXPECT_GT(std::abs(summary_of(scenario).final_q2_m / exact - 1), 1e-8);
  const auto found = run_to_digits(scenario, 6, always);
  ASSERT_TRUE(found && has_digits(*found, 6));
  EXPECT_NE(found->precision, Precision::double_);
  EXPECT_GT(found->amplification.value_or(0), 1e5);
  // Said is the tolerance of the computation whose values are.
  EXPECT_EQ(to_json(*found, scenario, 6)["tolerance"], found->tolerance / Comparison::finest);
  for (const NamedEstimate& value : found->summary)
    if (value.name == "final_q2_m") {
      EXPECT_NEAR(value.estimate->value, exact, value.estimate->error + 1e-16);
    }
}

/// How many computations it takes, and whether the last are in double precision.
std::pair<int, bool> computations(const Scenario& scenario, int digits) {
  int number = 1;
  double last_s = 0;
  const auto found = run_to_digits(scenario, digits, [&](double time_s) {
    number += time_s < last_s;
    last_s = time_s;
    return true;
  });
  EXPECT_TRUE(found && has_digits(*found, digits)) << scenario.parameters.friction << ' ' << digits;
  return {number, found->precision == Precision::double_};
}

// What the first comparison tells is enough to choose the one that serves, or nearly.
TEST(ManyDigits, AreHadByFewComputations) {
  const auto computations = [](double friction, int digits) {
    Scenario scenario{.parameters = {.friction = friction}, .start_speed_Hz = 149.5, .until = 0.06};
    scenario.parameters.separation_time = 1e-3;
    return rotor::computations(scenario, digits);
  };
  constexpr bool in_double = true;
  EXPECT_EQ(computations(0.3, 3), std::pair(4, in_double));
  EXPECT_EQ(computations(0.3, 6), std::pair(4, in_double));
  EXPECT_EQ(computations(0.3, 9), std::pair(8, !in_double));
  EXPECT_EQ(computations(0.05, 6), std::pair(8, in_double));
  EXPECT_EQ(computations(0.08, 6), std::pair(8, !in_double));
  // Rounding tells that extended precision would not do: three in quadruple follow at once.
  EXPECT_EQ(computations(0.08, 8), std::pair(7, !in_double));
  // At first they do not even agree on the events.
  EXPECT_EQ(computations(0.08, 3), std::pair(12, in_double));
}

// How close a miss is tells how much finer it has to be told from a contact.
TEST(ManyDigits, OfAMissAreHadByFewComputations) {
  Scenario scenario{.start_speed_Hz = 149.5, .until = 0.03};
  scenario.parameters.separation_time = 1e-3;
  scenario.parameters.stator_radius = 0.1;
  SummaryObserver wide(scenario);
  run(scenario, wide);
  const double reached = wide.summary().max_displacement_m.value();
  const auto computations_of_miss = [&](double miss) {
    scenario.parameters.stator_radius = scenario.parameters.rotor_radius + (1 + miss) * reached;
    return computations(scenario, 3).first;
  };
  EXPECT_EQ(computations_of_miss(1e-6), 4);
  EXPECT_EQ(computations_of_miss(1e-8), 8);
  EXPECT_EQ(computations_of_miss(1e-11), 12);
}

// Every event of the paper's runs, against the landmarks in quadruple precision.
TEST(ManyDigits, AreThoseOfEveryEventOfThePapersRuns) {
  const std::string table = ROTOR_REFERENCE_DATA "/high-precision.csv";
  std::set<std::string> names;
  for (const CsvRow& row : read_csv(table)) names.insert(row["run"]);
  std::size_t compared = 0;
  for (const Figure& figure : paper_figures())
    for (const auto& [run, scenario] : figure.runs) {
      const std::string name = fmt::format("fig{:02}: {}", figure.number, run);
      if (!names.contains(name)) continue;  // the same as another figure's
      ++compared;
      const auto exact = reference_run(table, name);
      const auto found = run_to_digits(scenario, 6, always);
      ASSERT_TRUE(found && has_digits(*found, 6)) << name;
      ASSERT_EQ(found->events.size(), exact.size()) << name;
      for (std::size_t i = 0; i < exact.size(); ++i)
        for (std::size_t k = 0; k < 7; ++k) {
          const NamedEstimate& value = found->events[i].values[k];
          const auto truth = static_cast<double>(k == 0 ? exact[i].time_s : exact[i].state[k - 1]);
          const double of_a_double = 2.3e-16 * std::abs(truth), error = value.estimate->error;
          EXPECT_NEAR(value.estimate->value, truth, error + of_a_double)
              << name << ' ' << exact[i].kind << ' ' << value.name;
          EXPECT_LE(error, 0.5e-6 * value.size)
              << name << ' ' << exact[i].kind << ' ' << value.name;
        }
    }
  EXPECT_EQ(compared, names.size());
}

// The largest displacement of a flight is the clearance, to ten digits: it touches, or it does not.
TEST(ManyDigits, DecideWhetherAGlancingContactOccurs) {
  Scenario wide{.start_speed_Hz = 100, .until = 0.03};
  wide.parameters.separation_time = 0.001;
  wide.parameters.stator_radius = 0.1;
  const auto free = run_to_digits(wide, 14, always);
  ASSERT_TRUE(free);
  const auto furthest =
      std::ranges::find(free->summary, "max_displacement_m", &NamedEstimate::name)->estimate;
  ASSERT_LT(furthest->error, 1e-16);
  for (const double off : {1e-10, -1e-10}) {
    Scenario scenario = wide;
    scenario.parameters.stator_radius =
        scenario.parameters.rotor_radius + furthest->value * (1 + off);
    const auto found = run_to_digits(scenario, 3, always);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->is_course_sure());
    EXPECT_EQ(found->values.collisions > 0, off < 0);
  }
  // At a tolerance of 1e-6 nobody can tell, and it says so.
  wide.parameters.stator_radius = wide.parameters.rotor_radius + furthest->value * (1 + 1e-10);
  const auto hasty = compare<double>(wide, 1e-6, always);
  ASSERT_TRUE(hasty);
  EXPECT_FALSE(hasty->is_course_sure());
  for (const NamedEstimate& value : hasty->summary) {
    if (value.estimate && value.name != "final_time_s") {
      EXPECT_EQ(sure_digits(value), 0) << value.name;
    }
  }
}

TEST(ManyDigits, ArePrintedAsFarAsTheyAreSure) {
  EXPECT_EQ(certain_text(0.123456789, 1e-9, 6), "0.123457");
  EXPECT_EQ(certain_text(0.123456789, 1e-6, 6), "0.12346");
  EXPECT_EQ(certain_text(0.12345, 5e-7, 4), "0.123");  // 0.1234 or 0.1235
  EXPECT_EQ(certain_text(-41.0000, 1e-9, 4), "-41.00");
  EXPECT_EQ(certain_text(454828.1, 0.01, 4), "4.548e+05");
  EXPECT_EQ(certain_text(1e-9, 2e-9, 6), "?");
  EXPECT_EQ(certain_text(29.23, 0, 6), "29.23");  // as stated
  EXPECT_EQ(certain_text(123, 1e-9, 3), "123");
  EXPECT_EQ(certain_text(123, 1e-9, 4), "123.0");
  EXPECT_EQ(certain_text(-123, 1e-9, 3), "-123");
  EXPECT_EQ(certain_text(0.5, 1e-9, 1), "0.5");
  EXPECT_EQ(certain_text(2, 1e-9, 1), "2");
}

// A component's digits are those of its vector: one of 1e-9 m beside one of 1e-3 m has not to be
// known to as many places of its own.
TEST(ManyDigits, AreCountedOfTheSizeThatANumberIsOf) {
  const NamedEstimate small{.name = "final_q1_m", .estimate = {{1e-9, 1e-10}}, .size = 1e-3},
      large{.name = "final_q2_m", .estimate = {{1e-3, 1e-10}}, .size = 1e-3};
  EXPECT_EQ(sure_digits(small), sure_digits(large));
  EXPECT_EQ(sure_digits(small), 6);
  Comparison comparison;
  comparison.summary = {small, large};
  EXPECT_DOUBLE_EQ(to_json(comparison, {}, 6)["estimated_relative_error"], 1e-7);
}

}  // namespace
}  // namespace rotor
