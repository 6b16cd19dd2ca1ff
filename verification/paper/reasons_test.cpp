/// The paper's reasons for the accident: runs give the stored shares of failure.
#include "verification/paper/reasons.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "figures/data/csv.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/results/json.hpp"
#include "verification/paper/ensembles.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

const std::filesystem::path reference_data = ROTOR_REFERENCE_DATA;

const std::vector<Reason>& reasons() {
  static const auto all = read_reasons(reference_data / "reasons.csv");
  return all;
}

/// Trials of all reasons on a part of the rotors, drawn again.
const Trials& anew(const Set& set) {
  constexpr long draws = 60;
  static const std::array all = {tried(reasons(), sets[0].equations, draws, 2),
                                 tried(reasons(), sets[1].equations, draws, 2)};
  return all[set.equations == sets[0].equations ? 0 : 1];
}

// Shares within three standard errors.
TEST(Reasons, FailAsOftenAsTheTableSays) {
  for (const Set& set : sets)
    for (const CsvRow& row : read_csv(reference_data / "reasons-tried.csv")) {
      if (row["equations"] != set.name) continue;
      const Trial& trial = anew(set).at(row["reason"]);
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

TEST(Reasons, HaveTheStandardErrorOfACount) {
  Trial trial;
  trial.apply = 100;
  trial.violate = 20;
  EXPECT_NEAR(trial.standard_error(), 0.04, 1e-15);
}

TEST(Reasons, HaveVerdictsByTheShareThatHolds) {
  const auto named = [](const char* id, const char* place, const char* order = "") {
    Reason reason;
    reason.id = id, reason.place = place, reason.named = order;
    reason.judged = *order ? Criterion::decides : Criterion::rolls;
    return reason;
  };
  const auto failing = [](long violate) { return Trial{1000, 1000, violate, {}, {}}; };
  const Reason stated = named("it", "Sec. 4");
  for (const auto& [violate, verdict] :
       std::vector<std::pair<long, std::string>>{{0, "holds"},
                                                 {45, "holds (narrow)"},
                                                 {55, "mostly holds (narrow)"},
                                                 {200, "mostly holds"},
                                                 {490, "mostly holds (narrow)"},
                                                 {510, "refuted (narrow)"},
                                                 {900, "refuted"}})
    EXPECT_EQ(verdict_on(stated, {stated}, {{"it", failing(violate)}}), verdict) << violate;
  const Reason ours = named("it", "not said");
  EXPECT_EQ(verdict_on(ours, {ours}, {{"it", failing(0)}}), "");
  const std::vector<Reason> all = {named("much", "", "first"), named("little", "", "first"),
                                   named("some", "", "second"), named("none", "", "second")};
  const Trials trials = {{"much", failing(300)},
                         {"little", failing(190)},
                         {"some", failing(200)},
                         {"none", failing(0)}};
  EXPECT_EQ(verdict_on(all[0], all, trials), "holds");
  EXPECT_EQ(verdict_on(all[1], all, trials), "refuted (narrow)");
  EXPECT_EQ(verdict_on(all[2], all, trials), "");
}

// Two reasons with the same pairs: the number of forces compared in rolling equals the number of
// rotors that roll at both values.
TEST(Reasons, CompareForcesWhereTheRotorRollsAtBothValues) {
  for (const Set& set : sets)
    for (const std::string along : {"speed", "clearance", "friction"}) {
      const Trial& rolls = anew(set).at(along + "_rolling");
      EXPECT_EQ(anew(set).at(along + "_force").apply, rolls.apply - rolls.violate) << along;
    }
}

struct ReasonsExamples : CommandLine {};

// The force in rolling need not be the largest one of the run, which may come before.
TEST(Reasons, AreViolatedWhereTheForceInRollingFalls) {
  for (const Set& set : sets)
    for (const Reason& reason : reasons())
      if (reason.judged == Criterion::force) {
        for (const double ratio : anew(set).at(reason.id).sizes) EXPECT_LT(ratio, 1) << reason.id;
      }
}

// By the program: each example is a violation, and its forces have the counted ratio. The force in
// rolling is not in a summary.
TEST_F(ReasonsExamples, FailAsRunsOfTheirOwn) {
  int tried = 0;
  for (const Set& set : sets)
    for (const Reason& reason : reasons()) {
      const auto& [pairs, apply, violate, sizes, example] = anew(set).at(reason.id);
      if (example.empty() || reason.judged == Criterion::force) continue;
      ++tried;
      const std::size_t between = example.find("; "), value = example.rfind(' ', between - 1) + 1;
      const std::string stop = "--stop-on outcome ";
      const auto less = summary(stop + example.substr(0, between)),
                 more = summary(stop + example.substr(0, value) + example.substr(between + 2));
      const bool less_rolls = less["outcome"] == "rolling",
                 more_rolls = more["outcome"] == "rolling";
      if (reason.judged == Criterion::decides) {
        EXPECT_NE(less_rolls, more_rolls) << example;
        continue;
      }
      EXPECT_TRUE(less_rolls || reason.judged == Criterion::touches) << example;
      EXPECT_TRUE(reason.judged != Criterion::rolls || !more_rolls) << example;
      const auto force = [](const Json& of) {
        return of["peak_force_to_rolling_N"].is_null()
                   ? 0
                   : of["peak_force_to_rolling_N"].get<double>();
      };
      const double ratio = force(more) / force(less);
      EXPECT_NEAR(sizes.front(), reason.judged == Criterion::harmless ? 1 / ratio : ratio,
                  1e-9 * sizes.front())
          << example;
    }
  EXPECT_GT(tried, 20);
}

// The largest force of a run may come before rolling: here it falls with speed, and the largest one
// in rolling rises.
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

}  // namespace
}  // namespace rotor
