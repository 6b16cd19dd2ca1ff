/// `rotor run` of a scene with several runs.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "figures/scenes/names.hpp"
#include "verification/support/run_summary.hpp"

namespace rotor {
namespace {

using Json = nlohmann::json;

using RunCommand = RunSummary;

Json schema_of_summaries() {
  std::ifstream file(ROTOR_SOURCES "/figures/program/summary.schema.json");
  return Json::parse(file);
}

// A scene's runs, each the same as on its own.
TEST_F(RunCommand, RunsAllRunsOfAScene) {
  write("two.toml",
        "[parameters]\nstart_speed_hz = 150\nuntil = 0.03\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\nfriction = 0.2\n");
  const Json runs = summary("--scene two.toml")["runs"];
  ASSERT_EQ(runs.size(), 2U);
  for (const Json& run : runs) {
    Json alone = summary("--scene two.toml --run " + run["run"].get<std::string>());
    alone["run"] = run["run"];
    EXPECT_EQ(run, alone);
  }
  EXPECT_NE(runs[0]["collisions"], runs[1]["collisions"]);
  EXPECT_TRUE(rotor("run --scene two.toml --json").output.starts_with("{\n  \"runs\": [\n    {\n"));
  const std::string table = rotor("run --scene two.toml").output;
  EXPECT_NE(table.find("\na  "), std::string::npos);
  EXPECT_NE(table.find("\nb  "), std::string::npos);
  expect_refusal("run --scene two.toml --trace t.csv", "choose it with --run");
}

// Of several runs a row each, with the numbers of the JSON.
TEST_F(RunCommand, TabulatesTheRunsOfAScene) {
  write("two.toml",
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.03\n"
        "[[run]]\nname = \"rolls\"\n[[run]]\nname = \"misses\"\nlost_mass = 1e-3\n");
  const Json runs = summary("--scene two.toml")["runs"];
  std::istringstream table(rotor("run --scene two.toml 2>messages").output);
  std::string row, name, value;
  std::vector<std::string> names;
  std::getline(table, row);
  for (std::istringstream cells(row); cells >> name;) names.push_back(name);
  EXPECT_EQ(names,
            std::vector<std::string>({"run", "outcome", "collisions", "first_contact_s",
                                      "rolling_onset_s", "peak_normal_force_N", "final_speed_Hz"}));
  for (const Json& run : runs) {
    ASSERT_TRUE(std::getline(table, row));
    std::istringstream cells(row);
    for (const std::string& key : names) {
      ASSERT_TRUE(cells >> value) << key << row;
      const Json& stated = run[key];
      EXPECT_EQ(value, stated.is_null()     ? "-"
                       : stated.is_string() ? stated.get<std::string>()
                                            : stated.dump())
          << key << row;
    }
    EXPECT_FALSE(cells >> value) << row;
  }
  const Json schema = schema_of_summaries();
  for (const auto& [key, unused] : runs[0].items())
    EXPECT_TRUE(schema["properties"].contains(key)) << key;
  // With as many digits as are asked for.
  write("two.toml",
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.03\ndigits = 3\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\nfriction = 0.4\n");
  std::istringstream sure(rotor("run --scene two.toml 2>messages").output);
  for (int n = 0; n < 3; ++n) std::getline(sure, row);
  EXPECT_EQ(std::ranges::count_if(row.substr(row.find_last_of(' ', row.find_last_not_of(' '))),
                                  [](char c) { return std::isdigit(c) != 0; }),
            3)
      << row;
  EXPECT_EQ(runs.size(), 2U);
  EXPECT_NE(runs[0]["outcome"], runs[1]["outcome"]);
  EXPECT_FALSE(std::getline(table, row));
}

// What a table has no room for is told beside it, or refused.
TEST_F(RunCommand, TellsWhatATableHasNoRoomFor) {
  write("two.toml",
        "[parameters]\nstart_speed_hz = 60\nclearance = 2e-4\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\nfriction = 0.1\n");
  EXPECT_EQ(rotor("run --scene two.toml --equations published 2>messages").status, 0);
  for (const char* run :
       {"rotor: a: the ring is indented by ", "rotor: b: the ring is indented by "})
    EXPECT_NE(content("messages").find(run), std::string::npos) << content("messages");
  EXPECT_EQ(rotor("run --scene two.toml --equations published --json 2>messages").status, 0);
  EXPECT_EQ(content("messages"), "");
  for (const char* option : {"--trace t.csv", "--events e.csv"})
    expect_refusal(std::string("run --scene two.toml ") + option,
                   "two.toml: --trace and --events are of one run; choose it with --run");
  for (const char* option : {"--energy", "--estimate-error"}) {
    expect_refusal(std::string("run --scene two.toml ") + option,
                   "two.toml: of several runs --energy and --estimate-error are told by --json "
                   "alone");
    EXPECT_EQ(rotor(std::string("run --scene two.toml --json --run a ") + option).status, 0);
  }
  EXPECT_TRUE(summary("--scene two.toml --energy")["runs"][1].contains("energy_J"));
}

// Runs behind the one that was cut short have not begun, and are not told.
TEST_F(RunCommand, EndsWithTheRunThatIsCutShort) {
  write("slow.toml",
        "[parameters]\nno_separation = true\nuntil = 1e6\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\n");
  const std::string output =
      shell(
          "timeout --foreground --preserve-status --signal=INT --kill-after=10 1 $rotor run "
          "--scene slow.toml --keep-partial")
          .output;
  EXPECT_NE(output.find("rotor: a: cut short at "), std::string::npos) << output;
  EXPECT_NE(output.find("; those behind it have not begun\n"), std::string::npos) << output;
  EXPECT_NE(output.find("\na   "), std::string::npos) << output;  // a table, though of one row
  EXPECT_EQ(output.find("\nb "), std::string::npos) << output;
}

// Each row has the digits of its own run.
TEST_F(RunCommand, TabulatesDigitsOfTheRunsThatStateThem) {
  write("two.toml",
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.02\n"
        "[[run]]\nname = \"usual\"\n[[run]]\nname = \"sure\"\ndigits = 6\n");
  const std::string table = rotor("run --scene two.toml --equations published").output;
  EXPECT_NE(
      table.find("\nsure                 bouncing             3                    0.00560495 "),
      std::string::npos)
      << table;
}

// What one run lacks takes nothing from the others.
TEST_F(RunCommand, TellsTheRunsBesideOneThatFails) {
  write("two.toml",
        "columns = [\"time_s\", \"rho_m\"]\n"
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.02\n"
        "[[run]]\nname = \"diverges\"\nmethod = \"rk4\"\ncontact_stiffness = 1e13\n"
        "[[run]]\nname = \"a name that is longer than twenty letters,\\nand a line\"\n");
  const auto [status, output] = rotor("run --scene two.toml --equations published 2> messages");
  EXPECT_EQ(status, 1);
  const auto row =
      output.find("\na name that is longer than twenty letters,\\x0aand a line bouncing ");
  ASSERT_NE(row, std::string::npos) << output;
  EXPECT_EQ(output.find("outcome "), output.find("bouncing ", row) - (row + 1)) << output;
  EXPECT_EQ(output.find("\ndiverges"), std::string::npos) << output;
  EXPECT_NE(content("messages").find("rotor: diverges: the rk4 run diverged"), std::string::npos);
  expect_refusal("plot two.toml", "two.toml: diverges: the rk4 run diverged");
  EXPECT_EQ(rotor("run --scene two.toml --json 2> messages").status, 1);
  expect_refusal("run --scene two.toml --run diverges", "rotor: the rk4 run diverged");
  expect_refusal("run --scene two.toml --run \"\"", "--run: must name a run");
}

// There is no table of no runs.
TEST_F(RunCommand, TabulatesNothingWhereAllRunsFail) {
  write("two.toml",
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.02\n"
        "method = \"rk4\"\ncontact_stiffness = 1e13\nequations = \"published\"\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\n");
  const auto [status, output] = rotor("run --scene two.toml 2> messages");
  EXPECT_EQ(status, 1);
  EXPECT_EQ(output, "");
  for (const char* run : {"rotor: a: the rk4 run diverged", "rotor: b: the rk4 run diverged"})
    EXPECT_NE(content("messages").find(run), std::string::npos) << content("messages");
}

// How long to look for digits is asked of the runs that state them.
TEST_F(RunCommand, HasABudgetForTheRunsThatStateDigits) {
  write("two.toml",
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.01\n"
        "[[run]]\nname = \"sure\"\ndigits = 3\n[[run]]\nname = \"usual\"\n");
  EXPECT_EQ(rotor("run --scene two.toml --equations published --budget 100").status, 0);
  expect_refusal("run --scene two.toml --run usual --budget 100", "state how many");
}

// A window that another run does not reach is none of its concern.
TEST_F(RunCommand, TakesTheWindowForThatOfTheRunsThatAreAskedFor) {
  write("two.toml",
        "window = { from_s = 0.004, until_s = 0.012 }\n[parameters]\nstart_speed_hz = 30\n"
        "[[run]]\nname = \"short\"\nuntil = 0.008\n[[run]]\nname = \"long\"\nuntil = 0.02\n");
  EXPECT_EQ(rotor("run --scene two.toml --run long --trace t.csv").status, 0);
  expect_refusal("run --scene two.toml --run short --trace t.csv", "<= 0.008 s");
  expect_refusal("run --scene two.toml", "window: must lie inside the run");
}

// Before the mass loss there is nothing to account for.
TEST_F(RunCommand, HasNoBalanceOfARunThatStopsBeforeItsLoss) {
  const Json energy = summary(
      "--friction 0.8 --clearance 3e-4 --until 29.2 --stop-on rolling --energy")["energy_J"];
  EXPECT_TRUE(energy["until_rolling"].is_null());
  EXPECT_TRUE(energy["until_end"].is_null());
}

// Numbers with zeros before them are no octal ones.
TEST_F(RunCommand, ReadsWholeNumbersAsTheyStand) {
  EXPECT_EQ(rotor("run --start-speed-hz 60 --trace t.csv --rows 010").status, 0);
  EXPECT_EQ(rows_of("t.csv").size(), 1U + 10);
}

// Deep in the ring at the resonance, long before any loss.
TEST_F(RunCommand, TellsOfADeepIndentationBeforeTheLoss) {
  const Json told = summary(
      "--no-separation --clearance 3e-4 --contact-stiffness 1e5 --friction 0.05 --until 3 "
      "--equations consistent");
  EXPECT_NE(told["remarks"].dump().find("the ring is indented by "), std::string::npos);
}

}  // namespace
}  // namespace rotor
