/// Runs with guaranteed digits: no digit may be false.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cctype>
#include <set>

#include "figures/data/csv.hpp"
#include "figures/input/names.hpp"
#include "figures/results/certified_result.hpp"
#include "figures/runs/scene.hpp"
#include "verification/support/certain_digits.hpp"
#include "verification/support/reference_tables.hpp"
#include "verification/support/short_run.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// A limit of steps: in quadruple precision some thousands take a second.
ShouldContinue for_steps(long most) {
  return [most, n = 0L](double /*time_s*/) mutable { return ++n < most; };
}

const std::string random_runs = ROTOR_REFERENCE_DATA "/random-runs.csv";

class Digits : public testing::TestWithParam<int> {};

TEST_P(Digits, OfRandomAndOfHardRunsAreAllTrue) {
  const int digits = GetParam();
  const std::vector<KnownRun> runs = known_runs(random_runs);
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
  EXPECT_GT(worst, 1e-4) << "the errors are uselessly large";
}

INSTANTIATE_TEST_SUITE_P(Numbers, Digits, testing::Values(3, 6, 9, 12));

// Compared with the true error, the estimate is rarely too small, and never uselessly large.
TEST(EstimatedError, IsAboveTheLargestTrueErrorOfRandomRuns) {
  int less = 0;
  for (const auto& [scenario, values] : known_runs(random_runs)) {
    const Summary summary = summary_of(scenario);
    const double estimate = estimated_relative_error(scenario, summary, always);
    less += estimate < true_error(summary, scenario.parameters, values);
    Summary other = summary;  // a run with another number of touch-downs is not comparable
    ++other.touch_downs;
    EXPECT_EQ(estimated_relative_error(scenario, other, always), 1);
  }
  EXPECT_LE(less, 2);  // of 36
}

// Every event of the paper's runs, against the landmarks in quadruple precision.
TEST(ManyDigits, AreThoseOfEveryEventOfThePapersRuns) {
  const std::string table = ROTOR_REFERENCE_DATA "/high-precision.csv";
  std::set<std::string> names;
  for (const CsvRow& row : read_csv(table)) names.insert(row["run"]);
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROTOR_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    for (const SceneRun& run : read_scene(entry.path()).runs) {
      const Scenario& scenario = run.scenario;
      const std::string name = entry.path().stem().string() + ": " + run.name;
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
  }
  EXPECT_EQ(compared, names.size());
}

// The largest displacement of a flight equals the clearance to ten digits: does it touch or not?
TEST(ManyDigits, DecideWhetherAGlancingContactOccurs) {
  Scenario wide{.start_speed_Hz = 100, .until = 0.03};
  wide.parameters.mass_loss_time = 0.001;
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
    EXPECT_EQ(found->values.touch_downs > 0, off < 0);
  }
}

// As many digits as are the same for all numbers within the error, or as were asked for; one more
// would differ between the ends of the error.
RC_GTEST_PROP(ManyDigits, ArePrintedAsFarAsTheyAreSure, ()) {
  const auto share = [] { return (1 + *rc::gen::inRange(0, 999999)) / 1e6; };
  const double value =
      (*rc::gen::inRange(0, 2) == 0 ? 1 : -1) * share() * std::pow(10, *rc::gen::inRange(-12, 12));
  const double error = std::abs(value) * share() * std::pow(10, *rc::gen::inRange(-12, 1));
  const int digits = *rc::gen::inRange(1, 13);
  const auto least = [&](int n) { return rounded_to(value - error, n); };
  const auto greatest = [&](int n) { return rounded_to(value + error, n); };
  const std::string printed = certified_text(value, error, digits);
  int sure = 0;  // from the first digit that is not zero on, trailing zeros among them
  if (printed != no_sure_digit)
    for (const char c : printed.substr(0, printed.find('e')))
      sure += std::isdigit(c) && (sure > 0 || c != '0');
  RC_ASSERT(sure <= digits);
  if (sure > 0) RC_ASSERT(least(sure) == printed && greatest(sure) == printed);
  if (sure < digits) RC_ASSERT(least(sure + 1) != greatest(sure + 1));
}

}  // namespace
}  // namespace rotor
