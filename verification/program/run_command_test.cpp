/// The output of `rotor run`: every key of the summary.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "figures/input/names.hpp"
#include "figures/results/json.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

using RunCommand = CommandLine;

/// Whether a property of a schema allows a value.
bool allows(const Json& property, const Json& value) {
  const auto is_in = [](const Json& all, const Json& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  };
  if (property.contains("const")) return property["const"] == value;
  if (property.contains("enum")) return is_in(property["enum"], value);
  const Json types = property["type"].is_array() ? property["type"] : Json{property["type"]};
  if (property.contains("additionalProperties"))
    for (const Json& part : value)
      if (!allows(property["additionalProperties"], part)) return false;
  if (value.is_number_integer() && is_in(types, "integer")) return true;
  return is_in(types, value.is_number() ? "number" : value.type_name());
}

// And for a person, whatever a run that stops early leaves open.
TEST_F(RunCommand, PrintsWhatItsSchemaSays) {
  const Json schema = Json::parse(rotor("run --json-schema").output);
  for (const char* arguments :
       {"", "--until 0.5 --no-mass-loss", "--method rk4 --until 0.01", "--stop-on rolling",
        "--stop-on outcome", "--until 0.5 --stop-on outcome", "--until 31 --tolerance 1e-8",
        "--energy", "--start-speed-Hz 150 --mass-loss-time 1e-3 --until 0.03 --digits 6"}) {
    const Json printed = summary(arguments);
    EXPECT_EQ(rotor(std::string("run ") + arguments).status, 0) << arguments;
    for (const auto& key : schema["required"]) EXPECT_TRUE(printed.contains(key)) << key;
    for (const auto& [key, value] : printed.items()) {
      ASSERT_TRUE(schema["properties"].contains(key)) << key;
      EXPECT_TRUE(allows(schema["properties"][key], value)) << key << ": " << value;
    }
  }
}

// The table of several runs has the numbers and units of each run's own text, in whatever unit a
// speed is stated; there times after the mass loss are marked by words, here by a plus.
TEST_F(RunCommand, PrintsSeveralRunsInTheUnitsOfOne) {
  write("s.toml",
        "[parameters]\nequations = \"published\"\nmass_loss_time = 1e-3\nuntil = 0.03\n"
        "start_speed_rpm = 9000\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\nfriction = 0.1\n[[run]]\nname = \"c\"\n"
        "clearance = 0.2\nno_mass_loss = true\n");
  const std::string table = rotor("run s.toml 2>messages").output;
  EXPECT_TRUE(has(table, " rpm"));
  std::istringstream rows(table);
  for (std::string row; std::getline(rows, row);) {
    if (row.find(' ') != 1 || row[0] < 'a' || row[0] > 'c') continue;
    const std::string text = rotor("run s.toml 2>messages --run " + row.substr(0, 1)).output;
    const auto cells = matches(row, "([+]?)([0-9.]+ (kN|N|ms|s|rpm))");
    for (const Match& cell : cells)
      EXPECT_TRUE(has(text, ' ' + cell[2] + (cell[1] == "+" ? " after the" : "\n"))) << row << '\n'
                                                                                     << text;
    EXPECT_EQ(cells.size(), row[0] == 'a' ? 4U : row[0] == 'b' ? 3U : 1U) << row;
  }
}

// A mark is explained where it stands; a motor without torque drives nothing.
TEST_F(RunCommand, ExplainsWhatIsThere) {
  write("s.toml",
        "[parameters]\nstart_speed_Hz = 100\ntorque = 0\nuntil = 0.05\nno_mass_loss = true\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\nfriction = 0.1\n");
  EXPECT_EQ(rotor("run s.toml 2>messages").output.find("after the mass loss"), std::string::npos);
  const std::string unreached = rotor("run s.toml --run a --stop-on rest").output;
  EXPECT_TRUE(has(unreached, "only the damping of its whirl brakes the rotor"));
}

// The residual of the balance is reported, as loose tolerances show.
TEST_F(RunCommand, SaysWhereTheEnergyGoes) {
  const Json end = summary("--energy --tolerance 1e-4")["energy_J"]["until_end"];
  double residual = 0;
  for (const auto& [key, value] : end.items())
    if (key == "kinetic" || key.ends_with("spring") || key.ends_with("springs"))
      residual += value.get<double>();
    else if (key != "residual")
      residual -= value.get<double>();
  EXPECT_GT(std::abs(residual), 1e-9 * end["initial"].get<double>());
  EXPECT_NEAR(end["residual"], residual, 1e-12 * end["initial"].get<double>());
  EXPECT_TRUE(summary("--energy --stop-on rolling")["energy_J"]["until_end"].is_null());
  // The drive that holds the speed gives what the damping of a shifted start takes.
  const Json held = summary(
      "--energy --drive constant_speed --start-speed-Hz 100 --start-x 1e-3 "
      "--no-mass-loss --until 0.1")["energy_J"]["until_end"];
  EXPECT_GT(held["drive"], 1e-3);
  EXPECT_LT(std::abs(held["residual"].get<double>()), 1e-9 * held["drive"].get<double>());
  // What a rotor starts with is no work of a mass loss that it has not.
  const Json turning =
      summary("--energy --no-mass-loss --start-speed-Hz 100 --until 0.1")["energy_J"]["until_end"];
  const double speed = 200 * std::numbers::pi;
  EXPECT_NEAR(turning["initial"].get<double>() / (Parameters().inertia / 2 * speed * speed), 1,
              1e-3);  // and a little of the response to the unbalance
  EXPECT_EQ(turning["mass_loss"], 0);
}

// In JSON all results keep their types, and each number of the run has its error beside it.
// From rest a constant torque M lifts C over O if M t exceeds m g e (1 - cos t) at each angle t.
TEST_F(RunCommand, SaysWhetherTheMotorLiftsTheUnbalance) {
  double needed = 0;
  for (int n = 1; n < 3142; ++n) needed = std::max(needed, (1 - std::cos(1e-3 * n)) / (1e-3 * n));
  const double whole = 5 * 9.81 * 0.15e-3;  // m g e_x, N m
  for (const double share : {0.3, 0.99 * needed, 1.01 * needed, 1.2})
    for (const double until_s : {1., 40.}) {
      const Json run = summary(fmt::format("--no-mass-loss --inertia 5e-3 --torque {} --until {}",
                                           share * whole, until_s));
      EXPECT_EQ(has(run["remarks"].dump(), "swings as a pendulum"), share < needed) << share;
      EXPECT_TRUE(until_s < 40 || (run["final_speed_Hz"] > 2) == (share > needed)) << share;
    }
  expect_refusal("run --mass-loss-speed-Hz 10 --until 5 --torque 1e-3",
                 "does not lift the unbalance");
}

// 20 % of the radius, and 1.4 %.
TEST_F(RunCommand, RemarksOnDeepIndentations) {
  for (const auto& [stiffness, is_deep] : {std::pair("5e6", true), {"8e8", false}}) {
    const std::string options = fmt::format(
        "start_speed_Hz = 150\nclearance = 1e-3\nuntil = 0.3\ncontact_damping = 100\n"
        "contact_stiffness = {}\n",
        stiffness);
    write("s.toml", "[parameters]\n" + options);
    write("t.toml",
          "[parameters]\n" + options + "[[axis]]\nquantity = \"friction\"\nvalues = [0.2, 0.3]\n");
    const Json run = summary("s.toml");
    EXPECT_EQ(run["peak_displacement_m"] > 1e-3 + 0.05 * 0.06, is_deep);
    EXPECT_EQ(has(rotor("run s.toml").output, "of the rotor's radius, more than 5 %"), is_deep);
    EXPECT_EQ(has(rotor("plot s.toml").output, "of the rotor's radius, more than 5 %"), is_deep);
    EXPECT_EQ(has(rotor("sweep t.toml --force").output, "2 of 2 points have remarks"), is_deep);
    EXPECT_EQ(has(content("t.csv"), "of the rotor's radius"), is_deep);
    EXPECT_EQ(has(rotor("plot t.csv").output, "2 of 2 points have remarks"), is_deep);
  }
}

TEST_F(RunCommand, PrintsErrorsBesideTheNumbersIfDigitsAreAskedFor) {
  const std::string rolls =
      "--equations published --start-speed-Hz 150 --mass-loss-time 1e-3 --until 0.03 ";
  const Json plain = summary(rolls), sure = summary(rolls + "--digits 6");
  const Json& errors = sure["errors"];
  EXPECT_TRUE(plain["whirl_frequency_Hz"].is_number());
  for (const auto& [key, value] : plain.items()) {
    EXPECT_EQ(sure[key].type(), value.type()) << key;
    EXPECT_EQ(errors.contains(key) && !errors[key].is_null(),
              value.is_number_float() && key != "tolerance")
        << key;
    if (!errors.contains(key) || value.is_null()) continue;
    EXPECT_NEAR(sure[key].get<double>(), value.get<double>(), 1e-6 * std::abs(value.get<double>()))
        << key;
    EXPECT_EQ(errors[key] == 0, key == "final_time_s" || value == 0) << key;
  }
  for (const Json& event : sure["events"])
    for (const auto& [key, value] : event.items())
      EXPECT_EQ(value.is_number(), event["errors"].contains(key)) << key;
  const std::string narrow = "--stator-radius 0.0603 --mass-loss-time 2 --until 2.02 ";
  const Json before = summary(narrow + "--digits 3");
  EXPECT_GT(before["touch_downs_before_loss"], 10);
  EXPECT_EQ(before["touch_downs_before_loss"], summary(narrow)["touch_downs_before_loss"]);
  EXPECT_TRUE(has(before["remarks"].dump(), "before the mass loss"));
  EXPECT_TRUE(has(rotor("run --digits 3 --until 0.1").output,
                  "rotor: the mass loss at 29.1 s was not reached by 0.1 s\n"));
  for (const char* key : {"outcome", "touch_downs", "touch_downs_before_loss", "mass_loss_reached",
                          "remarks", "equations", "velocity_jump", "gravity_moment", "method"})
    EXPECT_EQ(sure[key], plain[key]) << key;
  EXPECT_EQ(sure.size(), plain.size() + 3);
  EXPECT_EQ(sure["tolerance"], 1e-13);  // not 9.999999999999999e-14
}

}  // namespace
}  // namespace rotor
