/// What `rotor run` says of a run: every key of its summary.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
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

// Every key that is printed stands in the schema, with its type, and the other way round.
TEST_F(RunCommand, PrintsWhatItsSchemaSays) {
  const Json schema = schema_of_summaries();
  const std::set<std::string> required(schema["required"].begin(), schema["required"].end());
  const auto type_of = [](const Json& value) -> std::string {
    if (value.is_number_integer()) return "integer";
    return value.is_number() ? "number" : value.type_name();
  };
  std::set<std::string> seen_null, seen_value = {"run"};  // which only several runs have
  for (const char* arguments :
       {"", "--until 0.5 --no-separation", "--method rk4 --until 0.01", "--stop-on rolling",
        "--until 31 --tolerance 1e-8", "--estimate-error",
        "--support-stiffness 1.2e5 --separation-time 10"}) {
    const Json printed = summary(arguments);
    std::set<std::string> keys;
    for (const auto& [key, value] : printed.items()) {
      keys.insert(key);
      ASSERT_TRUE(schema["properties"].contains(key)) << key;
      const Json& property = schema["properties"][key];
      const Json types = property["type"].is_array() ? property["type"] : Json{property["type"]};
      const std::string type = type_of(value);
      const bool integral =
          type == "integer" && std::find(types.begin(), types.end(), "number") != types.end();
      EXPECT_TRUE(integral || std::find(types.begin(), types.end(), type) != types.end())
          << key << " is " << type;
      if (property.contains("enum")) {
        EXPECT_NE(std::find(property["enum"].begin(), property["enum"].end(), value),
                  property["enum"].end())
            << key << " = " << value;
      }
      (value.is_null() ? seen_null : seen_value).insert(key);
    }
    EXPECT_EQ(keys, required) << arguments;
    EXPECT_EQ(printed["inputs"].size(), quantities().size() + 1);
  }
  for (const auto& [key, property] : schema["properties"].items()) {
    if (key == "cut_short_at_s" || key == "energy_J" || key == "digits" || key == "events")
      continue;
    const bool nullable = property["type"].dump().find("null") != std::string::npos;
    EXPECT_TRUE(seen_value.contains(key)) << key;
    EXPECT_EQ(seen_null.contains(key), nullable) << key;
  }
}

// What does not add up is said, which loose tolerances show.
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
  // What a rotor starts with is no work of a mass loss that it has not.
  const Json turning =
      summary("--energy --no-separation --start-speed-hz 100 --until 0.1")["energy_J"]["until_end"];
  const double speed = 200 * std::numbers::pi;
  EXPECT_NEAR(turning["initial"].get<double>() / (Parameters().inertia / 2 * speed * speed), 1,
              1e-3);  // and a little of the response to the unbalance
  EXPECT_EQ(turning["mass_loss"], 0);
}

// In JSON each number of the run has its error; everything else is as without.
TEST_F(RunCommand, PrintsWithDigitsWhatItsSchemaSays) {
  const Json schema = schema_of_summaries();
  const std::string rolls = "--start-speed-hz 150 --separation-time 1e-3 --until 0.03 ";
  const Json plain = summary(rolls), sure = summary(rolls + "--digits 6");
  EXPECT_TRUE(plain["whirl_frequency_Hz"].is_number());
  for (const auto& [key, value] : plain.items()) {
    const Json& property = schema["properties"][key];
    const bool has_error = property.contains("$ref") && !value.is_null();
    EXPECT_EQ(sure[key].is_object() && key != "inputs", has_error) << key;
    if (!has_error) continue;
    EXPECT_NEAR(sure[key]["value"].get<double>(), value.get<double>(),
                1e-6 * std::abs(value.get<double>()))
        << key;
    EXPECT_EQ(sure[key]["error"] == 0, key == "final_time_s" || value == 0) << key;
  }
  const std::string narrow = "--stator-radius 0.0603 --separation-time 2 --until 2.02 ";
  const Json before = summary(narrow + "--digits 3");
  EXPECT_GT(before["collisions_before_loss"], 10);
  EXPECT_EQ(before["collisions_before_loss"], summary(narrow)["collisions_before_loss"]);
  EXPECT_NE(before["remarks"].dump().find("before the mass loss"), std::string::npos);
  EXPECT_NE(
      rotor("run --digits 3 --until 0.1")
          .output.find("rotor: the mass loss at 29.1 s was not reached; the run ends at 0.1 s\n"),
      std::string::npos);
  // What it says of signs and times is so.
  const auto& says = schema["properties"];
  EXPECT_LT(plain["whirl_frequency_Hz"], 0);
  EXPECT_NE(says["whirl_frequency_Hz"]["description"].dump().find("negative against the rotation"),
            std::string::npos);
  EXPECT_LT(plain["max_displacement_before_loss_m"], plain["max_displacement_m"]);
  EXPECT_NE(says["max_displacement_m"]["description"].dump().find("after the mass loss"),
            std::string::npos);
  for (const char* key : {"outcome", "collisions", "collisions_before_loss", "mass_loss_reached",
                          "remarks", "equations", "velocity_jump", "gravity_moment", "method"})
    EXPECT_EQ(sure[key], plain[key]) << key;
  for (const auto& key : schema["properties"]["digits"]["required"])
    EXPECT_TRUE(sure["digits"].contains(key)) << key;
  EXPECT_EQ(sure.size(), plain.size() + 2);
}

// The speed is that of the exact run-up, whatever the method.
TEST_F(RunCommand, LosesTheMassAtTheSameTimeByEitherMethod) {
  const std::string lost = "--separation-speed-hz 20 --until 4.2 ";
  EXPECT_EQ(summary(lost + "--method rk4")["inputs"]["separation_time"],
            summary(lost)["inputs"]["separation_time"]);
}

}  // namespace
}  // namespace rotor
