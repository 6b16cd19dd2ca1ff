/// The paper's reasons for the accident: that the stored shares of failure are what runs give.
#include "verification/paper/reasons.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "figures/data/csv.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/sweep.hpp"
#include "model/theory/whirl.hpp"
#include "verification/paper/ensembles.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

const std::filesystem::path data = ROTOR_REFERENCE_DATA;

const std::vector<Reason>& reasons() {
  static const auto all = read_reasons(data / "reasons.csv");
  return all;
}

// A part of the draws anew: shares within three standard errors.
TEST(Reasons, FailAsOftenAsTheTableSays) {
  constexpr long draws = 100;
  for (const Set& set : sets) {
    const Trials anew = tried(reasons(), set.equations, draws, 2);
    for (const CsvRow& row : read_csv(data / "reasons-tried.csv")) {
      if (row["equations"] != set.name) continue;
      const Trial& trial = anew.at(row["reason"]);
      const auto number = [&](const char* column) {
        return static_cast<double>(row.number(column));
      };
      const auto expect_share = [&](long found, long of, double share) {
        const auto n = static_cast<double>(of);
        EXPECT_NEAR(static_cast<double>(found) / n, share,
                    3 * std::sqrt(share * (1 - share) / n) + 1 / n)
            << row["reason"] << ' ' << set.name;
      };
      ASSERT_GT(trial.apply, 0) << row["reason"];
      expect_share(trial.apply, trial.pairs, number("apply") / number("pairs"));
      expect_share(trial.violate, trial.apply, number("share"));
    }
  }
}

// On any grid a reason fails as often, within its error: counted were a rotor that fails at any
// step, the share would grow with the steps.
TEST(Reasons, FailAsOftenOnGridsOf5And10And25Hz) {
  std::vector<Reason> speed;
  for (const Reason& reason : reasons())
    if (reason.id == "speed_rolling" || reason.id == "speed_force") speed.push_back(reason);
  ASSERT_EQ(speed.size(), 2U);
  constexpr long draws = 400;
  const Trials anywhere = tried(speed, Equations::published, draws, 2);
  for (const double step_Hz : {5., 10., 25.}) {
    const long steps = std::lround((speed[0].until - speed[0].from) / step_Hz);
    for (const auto& [id, trial] : tried(speed, Equations::published, draws, 2, steps)) {
      const Trial& other = anywhere.at(id);
      EXPECT_NEAR(trial.share(), other.share(),
                  3 * std::hypot(trial.standard_error(), other.standard_error()))
          << id << ' ' << step_Hz;
    }
  }
}

struct ReasonsExamples : CommandLine {
  nlohmann::json summary(const std::string& options) const {
    return nlohmann::json::parse(
        rotor("run --json --stop-on outcome " + options + " 2>/dev/null").output);
  }
};

// Without the force in rolling, which is not in a summary.
TEST_F(ReasonsExamples, FailAsRunsOfTheirOwn) {
  std::map<std::string, Criterion> judged;
  for (const Reason& reason : reasons()) judged[reason.id] = reason.judged;
  int tried = 0;
  for (const CsvRow& row : read_csv(data / "reasons-tried.csv")) {
    const std::string& example = row["example"];
    const Criterion its = judged.at(row["reason"]);
    if (example.empty() || its == Criterion::force) continue;
    ++tried;
    const std::size_t between = example.find("; "), value = example.rfind(' ', between - 1) + 1;
    const auto less = summary(example.substr(0, between)),
               more = summary(example.substr(0, value) + example.substr(between + 2));
    const bool less_rolls = less["outcome"] == "rolling", more_rolls = more["outcome"] == "rolling";
    EXPECT_EQ(less_rolls, its == Criterion::decides ? !more_rolls : true) << example;
    EXPECT_TRUE(its != Criterion::rolls || !more_rolls) << example;
  }
  EXPECT_GT(tried, 20);
}

// The largest force of a run may come before rolling: along speed it falls here, and the largest
// one in rolling rises.
TEST(Reasons, CompareTheForceInRolling) {
  Reason reason = reasons()[1];
  ASSERT_EQ(reason.judged, Criterion::force);
  const std::string rotor =
      "friction 0.1325 clearance 0.00571 support_stiffness 26130 lost_mass 0.0362 "
      "contact_stiffness 859800000 contact_damping 6363 torque 0";
  ScenarioSpec spec;
  spec.equations = Equations::published;
  std::istringstream words(rotor);
  std::string name;
  for (double value = 0; words >> name >> value;) spec.numbers[name] = value;
  const auto at = [&](double speed_Hz) {
    spec.numbers["start_speed_hz"] = speed_Hz;
    return forces_of(spec);
  };
  const Forces slower = at(80), faster = at(85);
  EXPECT_GT(slower.largest, faster.largest);
  EXPECT_LT(slower.in_rolling, faster.in_rolling);
  EXPECT_NEAR(slower.in_rolling, 69.6e3, 100);
}

struct SingleRuns : ReasonsExamples {
  std::string outcome(const std::string& options) const { return summary(options)["outcome"]; }
};

// So contact at low speed is harmless for the paper's own rotor, but not as it slides on.
TEST_F(SingleRuns, BetweenRollingOnesTouchOnceAndComeFreeWithoutSliding) {
  for (const auto& [speed_Hz, expected] : {std::pair(50, "no_contact"),
                                           {52, "rolling"},
                                           {54, "freed"},
                                           {62, "freed"},
                                           {64, "rolling"}}) {
    const auto found = summary(fmt::format("--mass-loss-speed-hz {}", speed_Hz));
    EXPECT_EQ(found["outcome"], expected) << speed_Hz;
    if (found["outcome"] == "freed") {
      EXPECT_EQ(found["touch_downs"], 1) << speed_Hz;
    }
  }
}

/// The share of losses between 120 and 180 Hz after which the rotor rolls.
double rolling_share(Equations equations, double friction, double contact_damping) {
  ScenarioSpec spec;
  spec.equations = equations;
  spec.numbers = {
      {"torque", 0}, {"until", 0.5}, {"friction", friction}, {"contact_damping", contact_damping}};
  constexpr int speeds = 21;
  int rolling = 0;
  for (int n = 0; n < speeds; ++n) {
    spec.numbers["start_speed_hz"] = 120 + 3 * n;
    const Scenario scenario = scenario_of(spec);
    Observer null_observer;
    const RunResult account =
        finish(RunUpCheckpoint(scenario), scenario, StopOn::outcome, null_observer);
    rolling += account.summary.outcome == rotor::Outcome::rolling ? 1 : 0;
  }
  return static_cast<double>(rolling) / speeds;
}

// Below the limit of forward rub it is the rebound that decides which way the rotor is dragged.
TEST(BorderOfFriction, RisesToTheLimitOfForwardRubAsContactsLoseTheirRebound) {
  const double limit = Whirl(Parameters{}).synchronous_friction(2 * std::numbers::pi * 150);
  EXPECT_NEAR(limit, 0.163, 5e-4);
  for (const Equations set : {Equations::published, Equations::consistent}) {
    EXPECT_EQ(rolling_share(set, 0.08, 1e4), 0);  // at half of the limit
    EXPECT_EQ(rolling_share(set, 0.1, 1e4), 1);
    EXPECT_EQ(rolling_share(set, 0.15, 1e5), 0);
    EXPECT_GT(rolling_share(set, 0.18, 1e5), 0.8);
    EXPECT_EQ(rolling_share(set, 0.02, 3e3), 0);
    EXPECT_EQ(rolling_share(set, 0.06, 3e3), 1);
  }
}

}  // namespace
}  // namespace rotor
