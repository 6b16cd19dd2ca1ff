/// The laws of model/theory: random rotors agree with them as reference-data/laws.csv says, and the
/// program evaluates them correctly.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>

#include "figures/data/csv.hpp"
#include "figures/results/json.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

const std::string paper = ROTOR_SOURCES "/verification/paper/";

struct LawsOfTheAccident : CommandLine {
  Json json(const std::string& command) const {
    return Json::parse(rotor(command + " --json 2>/dev/null").output);
  }
};

// A part of the rotors again. Shares below a quantile scatter by at most half over the root of the
// number of rotors: with 60, each lies between its neighbours. Shares that agree: three standard
// errors.
TEST_F(LawsOfTheAccident, HoldOnRandomRotorsAsTheTableSays) {
  std::ifstream file(paper + "laws.toml");
  const std::string all((std::istreambuf_iterator<char>(file)), {});
  write("few.toml", std::regex_replace(all, std::regex("count = 10000"), "count = 600"));
  ASSERT_EQ(shell("$rotor sweep few.toml --out few.csv >/dev/null 2>&1 && " + paper +
                  "laws.sh few.csv > anew.csv")
                .status,
            0);
  const auto key = [](const CsvRow& row) {
    return row["equations"] + row["quantity"] + row["share_from"] + "-" + row["share_to"];
  };
  std::map<std::string, CsvRow> table;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/laws.csv")) table.emplace(key(row), row);
  int compared = 0;
  for (const CsvRow& row : read_csv(folder_ / "anew.csv")) {
    const CsvRow& stored = table.at(key(row));
    const auto share = static_cast<double>(stored.number("agree"));
    const auto runs = static_cast<double>(row.number("runs"));
    EXPECT_NEAR(static_cast<double>(row.number("agree")), share,
                3 * std::sqrt(share * (1 - share) / runs) + 1 / runs)
        << key(row);
    if (stored["median"].empty() || runs < 60) continue;
    ++compared;
    for (const auto& [below, quantile, above] :
         {std::tuple("q05", "q25", "median"), {"q25", "median", "q75"}, {"median", "q75", "q95"}}) {
      EXPECT_GE(row.number(quantile), stored.number(below)) << key(row);
      EXPECT_LE(row.number(quantile), stored.number(above)) << key(row);
    }
  }
  EXPECT_GT(compared, 10);
}

// Where the estimate is trusted; the table is about 10 %.
TEST_F(LawsOfTheAccident, EstimateThePapersRotor) {
  for (const char* options : {"--friction 0.3", "--mass-loss-time 19.1", "--mass-loss-time 14.15",
                              "--equations consistent"}) {
    const auto law = json(std::string("estimate ") + options),
               run = json(std::string("run ") + options);
    EXPECT_TRUE(law["law_trusted"]) << options;
    EXPECT_EQ(law["law_outcome"], run["outcome"]) << options;
    const auto near = [&](const char* of_law, const char* of_run, double allowed) {
      EXPECT_NEAR(law[of_law].get<double>() / run[of_run].get<double>(), 1, allowed)
          << options << ' ' << of_run;
    };
    near("law_speed_at_loss_Hz", "speed_at_mass_loss_Hz", 2e-3);  // run-up without drag
    near("law_rolling_speed_Hz", "rolling_onset_speed_Hz", 0.1);
    near("law_peak_force_N", "peak_force_to_rolling_N", 0.1);
  }
}

// With a clearance less than e_x1, (1) is negative, and whether the rotor rolls is not predicted.
TEST_F(LawsOfTheAccident, PromiseNothingWhereTheyDoNotHold) {
  const Json law = json("estimate --clearance 4e-4");
  EXPECT_EQ(law["law_outcome"], "undecided");
  EXPECT_FALSE(law["law_trusted"]);
  EXPECT_TRUE(law["law_contact_speed_Hz"].is_null());
}

}  // namespace
}  // namespace rotor
