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

TEST_F(RunCommand, RemarksOnContactBeforeTheLossAndOnDeepIndentation) {
  const auto remarks = [&](const std::string& arguments) {
    return summary(arguments)["remarks"].dump();
  };
  EXPECT_NE(remarks("").find("indented by 0.19 of the clearance"), std::string::npos);
  EXPECT_EQ(remarks("--separation-time 9.4"), "[]");
  EXPECT_EQ(remarks("--no-separation --support-stiffness 1.2e5 --until 6").find("mass loss"),
            std::string::npos);
  // A tenth is the limit: 0.103 and 0.089.
  const std::string stiff = "--start-speed-hz 150 --separation-time 1e-3 --until 0.05 ";
  EXPECT_NE(remarks(stiff + "--contact-stiffness 1.7e9").find("indented by 0.1 of the clearance"),
            std::string::npos);
  EXPECT_EQ(remarks(stiff + "--contact-stiffness 2e9"), "[]");
  // Deepest before the mass loss, after which it is indented by 9 of it.
  EXPECT_NE(remarks("--clearance 1e-4 --contact-stiffness 1e6 --contact-damping 100 "
                    "--separation-time 2.5 --until 2.5001 --tolerance 1e-7")
                .find("indented by 19 of the clearance"),
            std::string::npos);
  const Json early = summary("--clearance 1e-3 --friction 0.8 --stop-on rolling");
  EXPECT_NE(early["remarks"].dump().find(
                fmt::format("the mass loss at 29.1 s was not reached; the run ends at {} s",
                            early["final_time_s"].get<double>())),
            std::string::npos)
      << early["remarks"];
  EXPECT_NE(early["remarks"].dump().find(fmt::format(
                "touched the ring {} times before the mass loss", early["collisions"].get<int>())),
            std::string::npos)
      << early["remarks"];
  EXPECT_NE(remarks("--support-stiffness 1.2e5 --separation-time 10").find("before the mass loss"),
            std::string::npos);
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

TEST_F(RunCommand, SaysWhereTheEnergyGoes) {
  std::ifstream file(ROTOR_SOURCES "/figures/program/summary.schema.json");
  const Json balance = Json::parse(file)["$defs"]["balance"];
  const Json energy = summary("--energy")["energy_J"];
  for (const char* span : {"until_rolling", "until_end"}) {
    EXPECT_EQ(energy[span].size(), balance["required"].size());
    for (const auto& key : balance["required"]) EXPECT_TRUE(energy[span][key].is_number()) << key;
  }
  const Json& rolling = energy["until_rolling"];
  const double share = rolling["friction"].get<double>() / rolling["initial"].get<double>();
  EXPECT_NEAR(share, -0.69, 0.005);
  EXPECT_FALSE(summary("").contains("energy_J"));
  // What does not add up is said, which loose tolerances show.
  const Json end = summary("--energy --tolerance 1e-4")["energy_J"]["until_end"];
  double residual = 0;
  for (const auto& [key, value] : end.items())
    if (key == "kinetic" || key.ends_with("spring") || key.ends_with("springs"))
      residual += value.get<double>();
    else if (key != "residual")
      residual -= value.get<double>();
  EXPECT_GT(std::abs(residual), 1e-9 * end["initial"].get<double>());
  EXPECT_NEAR(end["residual"], residual, 1e-12 * end["initial"].get<double>());
  expect_refusal("run --energy --method rk4", "--energy: only --method event knows the motion");
  EXPECT_TRUE(summary("--energy --separation-time 9.4")["energy_J"]["until_rolling"].is_null());
  // What a rotor starts with is no work of a mass loss that it has not.
  const Json turning =
      summary("--energy --no-separation --start-speed-hz 100 --until 0.1")["energy_J"]["until_end"];
  const double speed = 200 * std::numbers::pi;
  EXPECT_NEAR(turning["initial"].get<double>() / (Parameters().inertia / 2 * speed * speed), 1,
              1e-3);  // and a little of the response to the unbalance
  EXPECT_EQ(turning["mass_loss"], 0);
}

// What rolled before the mass loss alone has not rolled since.
TEST_F(RunCommand, BalancesNothingUntilARollingThatWasBefore) {
  const Json printed = summary(
      "--support-stiffness 1.2e5 --friction 2 --separation-time 6 --tolerance 1e-7 --energy");
  EXPECT_LT(printed["rolling_onset_s"], 5);
  EXPECT_TRUE(printed["energy_J"]["until_rolling"].is_null());
}

// The case whose q2 has five digits at the default tolerance, which prints sixteen.
TEST_F(RunCommand, PrintsTheDigitsThatAreAskedForAndSure) {
  const std::string chaotic = "--friction 0.05 --until 29.23 ";
  const std::string text = rotor("run --start-speed-hz 150 --until 0.01 --digits 6").output;
  EXPECT_NE(text.find("final_time_s             0.01\n"), std::string::npos);
  EXPECT_NE(text.find("\ndigits\n  asked                  6\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("events "), text.find("located_events ") + 8);  // those stand in JSON alone
  EXPECT_EQ(text.find("events ", text.find("located_events ") + 9), std::string::npos) << text;
  const Json json = summary(chaotic + "--digits 6");
  EXPECT_LT(json["final_q2_m"]["error"], 0.5e-8);
  const std::string six = fmt::format("{:.6g}", json["final_q2_m"]["value"].get<double>());
  std::ifstream readme(ROTOR_SOURCES "/README.md");
  const std::string says{std::istreambuf_iterator<char>(readme), {}};
  EXPECT_NE(says.find("build/rotor run " + chaotic + "--digits 6      # final_q2_m " + six + '\n'),
            std::string::npos);
  EXPECT_TRUE(json["digits"]["course_is_sure"]);
  EXPECT_GT(json["digits"]["amplification_from_first_contact"], 1e5);
  EXPECT_EQ(json["events"].size(), json["located_events"].get<std::size_t>() + 2);  // loss, end
  EXPECT_EQ(json["events"].back()["event"], "end");
  EXPECT_LT(json["estimated_relative_error"], 0.5e-6);
  // Another run tells the error of the usual one.
  const Json usual = summary(chaotic + "--estimate-error");
  const double off = usual["final_q2_m"].get<double>() / json["final_q2_m"]["value"].get<double>();
  EXPECT_GT(usual["estimated_relative_error"], std::abs(off - 1));
  EXPECT_LT(usual["estimated_relative_error"], 1e-3);
  expect_refusal("run --estimate-error --stop-on rolling", "--estimate-error: is of whole runs");
}

TEST_F(RunCommand, SaysWhichDigitsCannotBeHad) {
  // There is time for double and extended precision, but not for quadruple.
  const Outcome hasty =
      rotor("run --friction 0.05 --until 29.23 --digits 12 --budget 4 >summary 2>messages");
  EXPECT_NE(hasty.status, 0);
  const std::string messages = content("messages"), printed = content("summary");
  EXPECT_NE(messages.find("--budget 4 s is not enough: "), std::string::npos) << messages;
  EXPECT_NE(messages.find(" of 12 digits"), std::string::npos) << messages;
  const auto report = messages.find("rotor: computation ");
  ASSERT_NE(report, std::string::npos) << messages;
  EXPECT_NE(messages.find(" for 12 digits is at ", report), std::string::npos) << messages;
  EXPECT_NE(messages.find(" s of 29.23 s after ", report), std::string::npos) << messages;
  // The first ones, in double precision, take a tenth of a second.
  EXPECT_GT(std::stoi(messages.substr(report + 19)), 1) << messages;
  EXPECT_LT(std::stoi(messages.substr(report + 19)), 20) << messages;
  EXPECT_NE(messages.find("a disturbance is multiplied by "), std::string::npos) << messages;
  EXPECT_NE(printed.find("\ncollisions               14\n"), std::string::npos) << printed;
  EXPECT_EQ(printed.find("final_q2_m               0.00156615194306"), std::string::npos);
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

TEST_F(RunCommand, NamesItsInputs) {
  const Json printed = summary("--separation-speed-hz 75 --clearance 2e-3");
  EXPECT_NEAR(printed["speed_at_separation_Hz"].get<double>(), 75, 1e-9);
  EXPECT_DOUBLE_EQ(printed["inputs"]["stator_radius"].get<double>(), 0.062);
  EXPECT_NEAR(printed["speed_ratio_at_separation"].get<double>(), 75 / 10.065842420897408, 1e-9);
  EXPECT_NEAR(printed["critical_speed_Hz"].get<double>(), 10.065842420897408, 1e-12);
  EXPECT_NEAR(printed["lost_mass_kg"].get<double>(), 0.0248138957816, 1e-12);
}

// The speed is that of the exact run-up, whatever the method.
TEST_F(RunCommand, LosesTheMassAtTheSameTimeByEitherMethod) {
  const std::string lost = "--separation-speed-hz 20 --until 4.2 ";
  EXPECT_EQ(summary(lost + "--method rk4")["inputs"]["separation_time"],
            summary(lost)["inputs"]["separation_time"]);
}

}  // namespace
}  // namespace rotor
