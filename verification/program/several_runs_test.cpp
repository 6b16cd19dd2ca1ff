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

// What one run lacks takes nothing from the others.
TEST_F(RunCommand, TellsTheRunsBesideOneThatFails) {
  write("two.toml",
        "columns = [\"time_s\", \"rho_m\"]\n"
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.02\n"
        "[[run]]\nname = \"diverges\"\nmethod = \"rk4\"\ncontact_stiffness = 1e13\n"
        "[[run]]\nname = \"a name that is longer than twenty letters\"\n");
  const auto [status, output] = rotor("run --scene two.toml --equations published 2> messages");
  EXPECT_EQ(status, 1);
  const auto row = output.find("\na name that is longer than twenty letters bouncing ");
  ASSERT_NE(row, std::string::npos) << output;
  EXPECT_EQ(output.find("outcome "), output.find("bouncing ", row) - (row + 1)) << output;
  EXPECT_EQ(output.find("\ndiverges"), std::string::npos) << output;
  EXPECT_NE(content("messages").find("rotor: diverges: the rk4 run diverged"), std::string::npos);
  expect_refusal("plot two.toml", "two.toml: diverges: the rk4 run diverged");
  EXPECT_EQ(rotor("run --scene two.toml --json 2> messages").status, 1);
  expect_refusal("run --scene two.toml --run diverges", "rotor: the rk4 run diverged");
  expect_refusal("run --scene two.toml --run \"\"", "--run: must name a run");
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

}  // namespace
}  // namespace rotor
