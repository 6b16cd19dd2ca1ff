/// The paper's reasons for the accident: that the stored shares of failure are what runs give.
#include "verification/paper/reasons.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "figures/data/csv.hpp"
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

}  // namespace
}  // namespace rotor
