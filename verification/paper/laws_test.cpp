/// The laws of model/theory: random rotors agree with them as reference-data/laws.csv says, and the
/// program evaluates them correctly, with their assumptions and without a promise.
#include "figures/results/laws.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "figures/data/read_csv.hpp"
#include "figures/results/remarks.hpp"
#include "figures/runs/scene.hpp"
#include "verification/paper/law_accuracy.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/content.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

const std::string paper = ROTOR_SOURCES "/verification/paper/";

/// The rows of laws.csv for the rotors of a sweep.
std::vector<CsvRow> accuracy_on(const std::vector<CsvRow>& rotors) {
  LawAccuracy accuracy;
  for (const CsvRow& rotor : rotors) accuracy.add(rotor);
  std::istringstream table(accuracy.csv());
  return read_csv(table, "laws.csv");
}

struct LawsOfTheAccident : CommandLine {
  Json json(const std::string& command) const {
    return Json::parse(rotor(command + " --json 2>/dev/null").output);
  }
};

// Other rotors than those of the table. Shares below a quantile scatter by at most half over the
// root of the number of rotors: with 60, each lies between its neighbours. Shares that agree: three
// standard errors.
TEST_F(LawsOfTheAccident, HoldOnRandomRotorsAsTheTableSays) {
  const auto key = [](const CsvRow& row) {
    return row["equations"] + row["quantity"] + row["share_from"] + "-" + row["share_to"];
  };
  std::map<std::string, CsvRow> table;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/laws.csv")) table.emplace(key(row), row);
  write("few.toml", replaced(replaced(content_of(paper + "laws.toml"), "seed = 1\n", "seed = 6\n"),
                             "count = [0-9]+", "count = 900"));
  ASSERT_EQ(rotor("sweep few.toml --out few.csv").status, 0);
  int compared = 0;
  for (const CsvRow& row : accuracy_on(read_csv(folder_ / "few.csv"))) {
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

// What a run that touches, rolls, slides or has a remark with a comma adds, and which groups it is
// in.
TEST(LawAccuracy, ComparesRunsWithTheirLaws) {
  const std::string head =
      "equations_varied,friction,outcome,touch_downs_to_rolling,rolling_onset_speed_Hz,"
      "peak_force_to_rolling_N,law_contact,law_whirl_friction,law_forward_friction,"
      "law_stable_forward_friction,law_rolling_speed_Hz,law_peak_force_N,law_unbalance_share,"
      "remarks,refusal\n";
  std::istringstream sweep(head +
                           "published,0.3,rolling,7,44,450,true,0.1,0.2,,40,500,0.1,\"a, b\",\n"
                           "published,0.3,sliding,9,,,true,0.1,,,40,500,0.1,,\n"
                           "published,0.3,freed,9,,,true,0.1,,0.2,40,500,0.1,,\n"
                           "published,0.09,rolling,7,40,50,true,0.3,0.2,,40,500,0.02,,\n"
                           "published,0.3,no_contact,0,,,true,0.1,,,40,500,0.1,,\n"
                           "published,0.3,no_contact,0,,,false,,,,,,0.1,,\n"
                           "published,0.3,,,,,,,,,,,,,refused\n");
  const auto rows = accuracy_on(read_csv(sweep, "sweep"));
  const auto row = [&](const std::string& quantity, const std::string& from) {
    for (const CsvRow& one : rows)
      if (one["quantity"] == quantity && one["share_from"] == from)
        return one["runs"] + " " + one["median"] + " " + one["agree"];
    return std::string();
  };
  EXPECT_EQ(row("touches", ""), "6  0.833333");
  // Of the four with contact and enough friction for whirl, two are above a limit of forward rub.
  EXPECT_EQ(row("rolls_above_both_frictions", ""), "2  0.500000");
  EXPECT_EQ(row("rolls_below_the_whirl_friction", ""), "1  1.000000");
  EXPECT_EQ(row("rolls_below_a_third_of_the_whirl_friction", ""), "1  1.000000");
  EXPECT_EQ(row("rolling_speed", "0.1"), "1 1.100 1.000000");
  EXPECT_EQ(row("peak_force", "0.1"), "1 0.900 1.000000");
  EXPECT_EQ(row("rolling_speed", "0"), "1 1.000 1.000000");
  EXPECT_EQ(row("peak_force", "0"), "1 0.100 0.000000");
  EXPECT_EQ(rows.size(), 8U);
}

// The table is about 10 %.
TEST_F(LawsOfTheAccident, EstimateThePapersRotor) {
  for (const std::string options :
       {"--equations published", "--equations published --mass-loss-time 19.1",
        "--equations published --mass-loss-time 14.15", "", "--mass-loss-time 19.1"}) {
    const auto law = json("estimate " + options), run = json("run " + options);
    EXPECT_EQ(law["law_contact"], true) << options;
    const auto near = [&](const char* of_law, const char* of_run, double allowed) {
      EXPECT_NEAR(law[of_law].get<double>() / run[of_run].get<double>(), 1, allowed)
          << options << ' ' << of_run;
    };
    near("law_speed_at_loss_Hz", "speed_at_mass_loss_Hz", 2e-3);  // run-up without drag
    near("law_rolling_speed_Hz", "rolling_onset_speed_Hz", 0.1);
    near("law_peak_force_N", "peak_force_to_rolling_N", 0.1);
    EXPECT_TRUE(has(rotor("estimate " + options).output,
                    fmt::format("  largest normal force           {:.4g} kN ",
                                law["law_peak_force_N"].get<double>() / 1e3)));
  }
}

// Dampers brake the first rotor through its resonance, and a grazing impact lets the second one go,
// whatever the closed forms have for them.
TEST_F(LawsOfTheAccident, PromiseNoOutcome) {
  for (const std::string options :
       {"--equations corrected --torque 0 --inertia 4e-4 --support-damping 60 --start-speed-Hz 18 "
        "--unbalance-factor 2 --clearance 1e-3",
        "--equations corrected --torque 0 --contact-damping 26 --contact-stiffness 448898.329 "
        "--support-damping 5.538981 --friction 0.92590756 --start-speed-Hz 182.362809 --clearance "
        "0.005301126650"}) {
    const Json law = json("estimate " + options);
    for (const auto& [key, value] : law.items())
      EXPECT_FALSE(value.is_string() && key != "equations") << key << ' ' << value;
    EXPECT_EQ(matches(rotor("estimate --all " + options).output, "outcome|trusted").size(), 0U);
    const std::string said = rotor("estimate " + options + " 2>messages").output;
    EXPECT_TRUE(has(said, "if the speed stays that at the loss.\n"));
    for (const Match& row : matches(said, "\n  ([^\n]*)"))  // label, value, assumption
      EXPECT_FALSE(matches(row[1], " (if|neglected) ").empty()) << row[1];
  }
}

// Without contact there is no force of it; without friction there is contact, but no rolling.
TEST_F(LawsOfTheAccident, TellNoContactFromNoValue) {
  const auto expect = [&](const std::string& options, bool touches, bool has_rolling,
                          std::string_view sentence) {
    const Json law = json("estimate " + options);
    EXPECT_EQ(law["law_contact"], touches) << options;
    EXPECT_EQ(law["law_impact_force_N"].is_number(), touches) << options;
    EXPECT_EQ(law["law_rolling_speed_Hz"].is_number(), has_rolling) << options;
    const std::string said = rotor("estimate " + options + " 2>messages").output;
    EXPECT_TRUE(said.starts_with(sentence)) << said;
    EXPECT_EQ(matches(said, "no value").empty(), touches == has_rolling) << said;
  };
  expect("--friction 0.3", true, true, "Corrected equations: the rotor touches the ring, ");
  expect("--friction 0", true, false, "Corrected equations: the rotor touches the ring, ");
  expect("--mass-loss-speed-Hz 75", false, false,
         "Corrected equations: the rotor does not touch the ring, ");
}

// The inputs of each figure, and slips of the pen.
TEST_F(LawsOfTheAccident, QuestionInputsInOtherUnits) {
  for (const auto& [number, figure] : figure_files(ROTOR_SCENES))
    for (const SceneRun& run : read_scene(figure).runs)
      if (run.scenario.parameters.loses_mass) {
        const double speed_Hz = laws(run.scenario)["law_speed_at_loss_Hz"];
        for (const Remark& remark : remarks_on_rotor(run.scenario, speed_Hz))
          ADD_FAILURE() << figure << ": " << remark.message.text();
      }
  for (const auto& [options, remark] : std::vector<std::pair<std::string, std::string>>{
           {"--mass 2000 --inertia 1600", "torque = 0.3 N m does not lift the unbalance from rest"},
           {"--mass 2000 --inertia 1600 --gravity 0", "the motor reaches about 0.00058 %"},
           {"--mass 2000 --inertia 1600", "the mass is lost at 0.000"},
           {"--inertia 9", "inertia = 9 kg m^2 is 5e+02 times"},
           {"--mass 500 --unbalance-factor 1.01 --start-speed-Hz 150",
            "inertia = 0.009 kg m^2 is 0.005 times"},
           {"--start-speed-Hz 0.9 --torque 0 --until 0.1", "less than 0.1 of the critical speed"}})
    for (const char* command : {"estimate ", "run --stop-on outcome "})
      EXPECT_TRUE(has(rotor(command + options).output, remark)) << command << options;
}

}  // namespace
}  // namespace rotor
