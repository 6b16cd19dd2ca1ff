/// The paper's reasons for the accident: runs give the stored shares.
#include "verification/paper/reasons.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "figures/data/read_csv.hpp"
#include "verification/paper/ensembles.hpp"

namespace rotor {
namespace {

const std::filesystem::path reference_data = ROTOR_REFERENCE_DATA;

const std::vector<Reason>& reasons() {
  static const auto all = read_reasons(reference_data / "reasons.csv");
  return all;
}

/// Trials of all reasons on other rotors than those of the table.
std::map<std::string, Trial> anew(const Set& set) {
  constexpr long seed = 6, draws = 200;
  const auto trials = tried(reasons(), set.equations, seed, draws, 2);
  std::map<std::string, Trial> all;
  for (std::size_t r = 0; r < trials.size(); ++r) all[reasons()[r].id] = trials[r];
  return all;
}

// Shares within three standard errors. Reasons with the same pairs: the number of forces compared
// in rolling equals the number of rotors that roll at both values.
TEST(Reasons, HoldAsOftenAsTheTableSays) {
  for (const Set& set : sets) {
    const auto trials = anew(set);
    std::size_t rows = 0;
    for (const CsvRow& row : read_csv(reference_data / "reasons-tried.csv")) {
      if (row["equations"] != set.name) continue;
      ++rows;
      const auto& [pairs, apply, hold] = trials.at(row["reason"]);
      const auto expect_share = [&](long found, long of, double share) {
        const auto n = static_cast<double>(of);
        EXPECT_NEAR(static_cast<double>(found) / n, share,
                    3 * std::sqrt(share * (1 - share) / n) + 1 / n)
            << row["reason"] << ' ' << set.name;
      };
      ASSERT_GT(apply, 0) << row["reason"];
      expect_share(apply, pairs, static_cast<double>(row.number("runs") / row.number("pairs")));
      expect_share(hold, apply, static_cast<double>(row.number("agree")));
    }
    EXPECT_EQ(rows, reasons().size());
    for (const std::string along : {"speed", "clearance", "friction"})
      EXPECT_EQ(trials.at(along + "_force").apply, trials.at(along + "_rolling").hold) << along;
  }
}

// All speeds of the range are drawn equally often: the opposite range gives as many contacts.
TEST(Reasons, DrawSpeedsWithoutPreference) {
  std::vector<Reason> harmless;
  std::ranges::copy_if(reasons(), std::back_inserter(harmless), [](const Reason& reason) {
    return reason.judged == Criterion::harmless && reason.most_friction >= 0.5;
  });
  ASSERT_EQ(harmless.size(), 1U);
  harmless.push_back(harmless[0]);
  std::swap(harmless[1].from, harmless[1].until);
  constexpr long draws = 1000;
  const auto trials = tried(harmless, Equations::published, 6, draws, 2);
  const double share = static_cast<double>(trials[0].apply) / draws;
  EXPECT_NEAR(static_cast<double>(trials[1].apply), static_cast<double>(trials[0].apply),
              3 * std::sqrt(2 * draws * share * (1 - share)));
}

// The largest force of a run may come before rolling: here it falls with speed, and the largest one
// in rolling rises.
TEST(Reasons, CompareTheForceInRolling) {
  const std::string rotor =
      "friction 0.1325 clearance 0.00571 support_stiffness 26130 lost_mass 0.0362 "
      "contact_stiffness 859800000 contact_damping 6363 torque 0";
  ScenarioSpec spec;
  spec.equations = Equations::published;
  std::istringstream words(rotor);
  std::string name;
  for (double value = 0; words >> name >> value;) spec.numbers[name] = value;
  const auto at = [&](double speed_Hz) {
    spec.numbers["start_speed_Hz"] = speed_Hz;
    return end_of(spec);
  };
  const RubEnd slower = at(80), faster = at(85);
  EXPECT_GT(slower.largest_N, faster.largest_N);
  EXPECT_LT(slower.in_rolling_N, faster.in_rolling_N);
  EXPECT_NEAR(slower.in_rolling_N, 69.6e3, 100);
  EXPECT_EQ(trial_of(Criterion::force, slower, faster).hold, 1);
  EXPECT_EQ(trial_of(Criterion::force, faster, slower).hold, 0);
}

}  // namespace
}  // namespace rotor
