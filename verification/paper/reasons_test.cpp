/// The paper's reasons for the accident: that the stored shares of failure are what runs give.
#include "verification/paper/reasons.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "figures/data/csv.hpp"
#include "figures/scenes/account.hpp"
#include "figures/scenes/statement.hpp"
#include "model/theory/whirl.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

const std::filesystem::path data = ROTOR_REFERENCE_DATA;

const std::vector<Reason>& reasons() {
  static const auto all = read_reasons(data / "reasons.csv");
  return all;
}

// A part of the draws anew: shares and trends within three standard errors.
TEST(Reasons, FailAsOftenAsTheTableSays) {
  constexpr long draws = 60;
  const std::map<std::string, Trials> anew = {
      {"published", tried(reasons(), Equations::published, draws, 2)},
      {"consistent", tried(reasons(), Equations::consistent, draws, 2)}};
  const auto rows = read_csv(data / "reasons-tried.csv");
  ASSERT_EQ(rows.size(), 2 * reasons().size());
  for (const CsvRow& row : rows) {
    const Trial& trial = anew.at(row["equations"]).at(row["reason"]);
    ASSERT_GT(trial.rotors, 0) << row["reason"];
    const auto share = static_cast<double>(row.number("share"));
    const auto n = static_cast<double>(trial.rotors);
    EXPECT_NEAR(trial.share(), share, 3 * std::sqrt(share * (1 - share) / n) + 1 / n)
        << row["reason"];
    EXPECT_EQ(trial.fails > 0 && trial.example.empty(), false);
    for (const auto& [name, found] : {std::pair("first", trial.first), {"last", trial.last}}) {
      const auto stored = static_cast<double>(row.number(name));
      // Of a share; of a mean of forces, which scatter by about as much as they are.
      const double scatter = stored <= 1 ? std::sqrt(stored * (1 - stored)) : 1.2 * stored;
      EXPECT_NEAR(found, stored, 3 * scatter / std::sqrt(draws) + 1. / draws)
          << row["reason"] << ' ' << name;
    }
  }
}

struct ReasonsExamples : CommandLine {
  nlohmann::json summary(const std::string& options) const {
    return nlohmann::json::parse(
        rotor("run --json --stop-on outcome " + options + " 2>/dev/null").output);
  }
};

TEST_F(ReasonsExamples, FailAsRunsOfTheirOwn) {
  std::map<std::string, Judged> judged;
  for (const Reason& reason : reasons())
    if (reason.quantity != "location") judged[reason.id] = reason.judged;
  int tried = 0;
  for (const CsvRow& row : read_csv(data / "reasons-tried.csv")) {
    const std::string& example = row["example"];
    if (example.empty() || !judged.contains(row["reason"])) continue;
    ++tried;
    const std::size_t between = example.find("; ");
    const auto before = summary(example.substr(0, between));
    if (judged[row["reason"]] == Judged::harmless) {
      EXPECT_EQ(before["outcome"], "rolling") << example;
      continue;
    }
    const std::size_t value = example.rfind(' ', between - 1) + 1;
    const auto after = summary(example.substr(0, value) + example.substr(between + 2));
    const auto force = [](const nlohmann::json& of) {
      return of["peak_normal_force_N"].is_null() ? 0 : of["peak_normal_force_N"].get<double>();
    };
    const double change = std::abs(force(after) / force(before) - 1);
    const bool other_outcome = before["outcome"] != after["outcome"];
    switch (judged[row["reason"]]) {
      case Judged::rolls:
        EXPECT_EQ(before["outcome"], "rolling") << example;
        EXPECT_NE(after["outcome"], "rolling") << example;
        break;
      case Judged::touches:
        EXPECT_GT(before["collisions"], 0) << example;
        EXPECT_EQ(after["collisions"], 0) << example;
        break;
      case Judged::force:
        EXPECT_EQ(before["outcome"], "rolling") << example;
        EXPECT_EQ(after["outcome"], "rolling") << example;
        EXPECT_LT(force(after), force(before)) << example;
        break;
      default:
        EXPECT_TRUE(other_outcome || change > (judged[row["reason"]] == Judged::minor ? 0.1 : 0.05))
            << example;
    }
  }
  EXPECT_GT(tried, 15);
}

struct SingleRuns : ReasonsExamples {
  std::string outcome(const std::string& options) const { return summary(options)["outcome"]; }
};

TEST_F(SingleRuns, RollWhateverTheClearanceButWithLessForce) {
  double last = 557;  // kN
  for (const char* clearance : {"2e-3", "3e-3", "4e-3", "5e-3"}) {
    const auto found = summary(fmt::format("--clearance {}", clearance));
    EXPECT_EQ(found["outcome"], "rolling") << clearance;
    const double force = found["peak_normal_force_N"].get<double>() / 1e3;
    EXPECT_LT(force, last);
    last = force;
  }
  EXPECT_NEAR(last, 323.8, 0.1);
  // Put right, the rotor does not get as far as 5 mm.
  EXPECT_EQ(outcome("--clearance 5e-3 --equations consistent"), "no_contact");
}

TEST_F(SingleRuns, CanFreeThemselvesWhereBothLessAndMoreFrictionRolls) {
  for (const char* start : {"--separation-speed-hz 101", "--start-speed-hz 101 --torque 0"}) {
    EXPECT_EQ(outcome(fmt::format("{} --friction 0.1", start)), "rolling");
    EXPECT_EQ(outcome(fmt::format("{} --friction 0.15", start)), "freed");
    EXPECT_EQ(outcome(fmt::format("{} --friction 0.2", start)), "rolling");
  }
}

TEST_F(SingleRuns, BetweenRollingOnesTouchOnceAndComeFreeWithoutSliding) {
  for (const auto& [speed_Hz, expected] : {std::pair(50, "no_contact"),
                                           {52, "rolling"},
                                           {54, "freed"},
                                           {62, "freed"},
                                           {64, "rolling"}}) {
    const auto found = summary(fmt::format("--separation-speed-hz {}", speed_Hz));
    EXPECT_EQ(found["outcome"], expected) << speed_Hz;
    if (found["outcome"] == "freed") {
      EXPECT_EQ(found["collisions"], 1) << speed_Hz;
    }
  }
}

// Stiff supports only seem safe: the motor does not get past their resonance.
TEST_F(SingleRuns, WithStiffSupportsTouchInTheRunUpOrStall) {
  EXPECT_EQ(summary("--support-stiffness 9e4")["collisions_before_loss"], 0);
  const auto touching = summary("--support-stiffness 1e5");
  EXPECT_GT(touching["collisions_before_loss"], 0);
  EXPECT_EQ(touching["outcome"], "rolling");
  EXPECT_EQ(outcome("--support-stiffness 1.2e5"), "stalled");
}

/// The share of losses between 120 and 180 Hz after which the rotor rolls.
double rolling_share(Equations equations, double friction, double contact_damping) {
  Statement statement;
  statement.equations = equations;
  statement.numbers = {
      {"torque", 0}, {"until", 0.5}, {"friction", friction}, {"contact_damping", contact_damping}};
  constexpr int speeds = 21;
  int rolling = 0;
  for (int n = 0; n < speeds; ++n) {
    statement.numbers["start_speed_hz"] = 120 + 3 * n;
    const Scenario scenario = scenario_of(statement);
    Observer nobody;
    const Account account = finish(Departure(scenario), scenario, StopOn::outcome, nobody);
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
