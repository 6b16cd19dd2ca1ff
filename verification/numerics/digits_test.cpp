/// Estimated digits: none may be false.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <random>
#include <set>

#include "figures/data/read_csv.hpp"
#include "figures/input/names.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/runs/scene.hpp"
#include "verification/support/digits_judge.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/reference_tables.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

// `make stress` has more of them. Two computations agree by chance in one value now and then, but
// hardly ever in all of a run's.
TEST(Digits, OfRandomRunsAreAllTrue) {
  constexpr int runs = 12;
  RandomRuns random = judged_runs(777001);
  std::array<int, judged_digits.size()> given{};
  for (int n = 0; n < runs; ++n) {
    const auto verdicts = judge(random.scenario());
    for (std::size_t k = 0; k < verdicts.size(); ++k) {
      EXPECT_EQ(verdicts[k].falsehood, "") << n << ", " << judged_digits[k] << " digits";
      given[k] += verdicts[k].given != '-';
    }
  }
  for (std::size_t k = 0; k < given.size(); ++k) EXPECT_GE(given[k], runs - 2) << judged_digits[k];
}

// Every event of the paper's runs, against the landmarks in quadruple precision.
TEST(Digits, AreThoseOfEveryEventOfThePapersRuns) {
  const std::string table = ROTOR_REFERENCE_DATA "/high-precision.csv";
  std::set<std::string> names;
  for (const CsvRow& row : read_csv(table)) names.insert(row["run"]);
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(ROTOR_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    for (const SceneRun& run : read_scene(entry.path()).runs) {
      const std::string name = entry.path().stem().string() + ": " + run.name;
      if (!names.contains(name)) continue;  // the same as another figure's
      ++compared;
      const auto exact = reference_run(table, name);
      const auto found = compare(Precision::double_, run.scenario, 1e-11, always);
      ASSERT_TRUE(found && found->is_course_sure) << name;
      ASSERT_EQ(found->events.size(), exact.size()) << name;
      for (std::size_t i = 0; i < exact.size(); ++i)
        for (std::size_t k = 0; k < 7; ++k) {
          const NamedEstimate& value = found->events[i].values[k];
          const auto truth = static_cast<double>(k == 0 ? exact[i].time_s : exact[i].state[k - 1]);
          EXPECT_NEAR(*value.value, truth, value.error + 2.3e-16 * std::abs(truth))
              << name << ' ' << exact[i].kind << ' ' << value.name;
        }
    }
  }
  EXPECT_EQ(compared, names.size());
}

// The largest displacement of a flight is the clearance to nine or twelve digits: does it touch?
TEST(Digits, DecideWhetherAGlancingContactOccursUnlessItIsNearerThanTheirError) {
  Scenario wide{.equations = Equations::published, .start_speed_Hz = 100, .until = 0.03};
  wide.parameters.mass_loss_time = 0.001;
  wide.parameters.stator_radius = 0.1;
  const auto free = compare(Precision::quadruple, wide, 1e-20, always);
  ASSERT_TRUE(free);
  const auto furthest =
      std::ranges::find(free->summary, "peak_displacement_m", &NamedEstimate::name);
  ASSERT_LT(furthest->error, 1e-16);
  const auto found = [&](double off, Precision precision, double tolerance) {
    Scenario scenario = wide;
    scenario.parameters.stator_radius =
        scenario.parameters.rotor_radius + *furthest->value * (1 + off);
    return compare(precision, scenario, tolerance, always).value();
  };
  for (const double off : {1e-9, -1e-9, 1e-12, -1e-12}) {
    const Comparison finely = found(off, Precision::quadruple, 1e-16);
    EXPECT_TRUE(finely.is_course_sure) << off;
    EXPECT_EQ(finely.values.touch_downs > 0, off < 0);
    const Comparison coarsely = found(off, Precision::double_, 1e-7);
    EXPECT_FALSE(coarsely.is_course_sure) << off;
    EXPECT_EQ(to_json(coarsely, wide, 3)["touch_downs"], nullptr) << off;
    EXPECT_EQ(finely.events[0].values[1].error, finely.events[0].values[2].error);  // q1, q2
    for (const NamedEstimate& value : coarsely.summary)
      EXPECT_TRUE(value.error == 0 || std::isinf(value.error)) << value.name;
  }
}

// Both computations have the event, or both have not, but the time between it and the end is
// smaller than its error.
TEST(Digits, AreNotGivenIfTheRunEndsTooShortlyBeforeOrAfterAnEvent) {
  Scenario scenario = short_run(0.03);
  const EventRecorder recorder = recorded(scenario);
  for (const Event event :
       {Event::touch_down, Event::release, Event::ring_clear, Event::rolling_onset}) {
    ASSERT_GT(recorder.count(event), 0) << name_of(event);
    for (const double sign : {-1, 1}) {
      double left_s = 1e-7;
      std::optional<Comparison> found;
      do {
        left_s /= 2;
        scenario.until = recorder.first(event).time_s + sign * left_s;
        found = compare(Precision::double_, scenario, 1e-8, always);
        ASSERT_TRUE(found);
      } while (found->is_course_sure);
      EXPECT_TRUE(found->same_course) << name_of(event) << ' ' << left_s;
    }
  }
}

// As many digits as are the same for all numbers within the error, or as were asked for; one more
// would differ between the ends of the error.
TEST(Digits, ArePrintedAsFarAsTheErrorLeavesThem) {
  std::mt19937_64 random(1);
  const auto from = [&](int least, int most) {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
  };
  const auto share = [&] { return from(1, 999'999) / 1e6; };
  for (int run = 0; run < 1000; ++run) {
    const double value = (run % 2 == 0 ? 1 : -1) * share() * std::pow(10, from(-12, 11));
    const double error = std::abs(value) * share() * std::pow(10, from(-12, 0));
    const int digits = from(1, 12);
    const auto least = [&](int n) { return rounded_to(value - error, n); };
    const auto greatest = [&](int n) { return rounded_to(value + error, n); };
    const std::string printed = text_within(value, error, digits);
    int sure = 0;  // from the first digit that is not zero on, trailing zeros among them
    if (printed != no_digit)
      for (const char c : printed.substr(0, printed.find('e')))
        sure += std::isdigit(c) && (sure > 0 || c != '0');
    EXPECT_LE(sure, digits) << value << ' ' << error;
    EXPECT_TRUE(sure == 0 || (least(sure) == printed && greatest(sure) == printed)) << printed;
    EXPECT_TRUE(sure == digits || least(sure + 1) != greatest(sure + 1)) << printed;
  }
}

}  // namespace
}  // namespace rotor
