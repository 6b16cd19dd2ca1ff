/// What is stated ends where its name says: every number of a scenario by the command line and by
/// scene files, every choice, and what takes precedence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "figures/scenes/statement.hpp"
#include "verification/support/run_summary.hpp"

namespace rotor {
namespace {

using Json = nlohmann::json;
class Options : public RunSummary {
 protected:
  Json inputs(const std::string& arguments) const { return summary(arguments)["inputs"]; }
};

/// A run of a few steps, by whose numbers others are told.
const std::map<std::string, double>& short_run() {
  static const std::map<std::string, double> stated = {
      {"start_speed_hz", 30}, {"until", 0.02}, {"separation_time", 0.001}};
  return stated;
}

std::string option(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return " --" + name + ' ';
}

std::string as_options(const std::map<std::string, double>& numbers) {
  std::string all;
  for (const auto& [name, value] : numbers) all += option(name) + fmt::format("{}", value);
  return all;
}

std::string as_keys(const std::map<std::string, double>& numbers) {
  std::string all;
  for (const auto& [name, value] : numbers) all += name + fmt::format(" = {}\n", value);
  return all;
}

/// What stating a number in the short run makes of its inputs, worked out by hand.
void expect_stated(const Json& inputs, const Json& standard, const std::string& name,
                   double value) {
  Json expected = standard;
  if (name == "clearance") {
    expected["stator_radius"] = 0.06 + value;
  } else if (name == "lost_mass") {
    const double m = 5, e = 0.15e-3, r = 0.06;
    expected["unbalance_factor"] = (m * e + value * r) / (m - value) / e;  // Eq. (5)
  } else if (name == "separation_speed_hz") {
    expected.erase("separation_time");  // known only to the run
    const double motor_alone_s = 2 * 3.14159 * (value - 30) * 9e-3 / 0.3;
    EXPECT_NEAR(inputs["separation_time"].get<double>() / motor_alone_s, 1, 0.02);
  } else {
    expected[name] = value;
  }
  for (const auto& [key, number] : expected.items())
    if (number.is_number()) {
      EXPECT_DOUBLE_EQ(inputs[key].get<double>(), number.get<double>()) << name << ": " << key;
    } else {
      EXPECT_EQ(inputs[key], number) << name << ": " << key;
    }
  EXPECT_EQ(inputs.size(), standard.size());
}

// By an option; by a key of [parameters]; by one of [[run]] above that; by an option above all.
TEST_F(Options, EachStateTheNumberThatTheyName) {
  const Json standard = inputs(as_options(short_run()));
  for (const Statable& statable : statables()) {
    const std::string name(statable.quantity.name);
    double value = 1.25, other = 1.5;  // of those that are found by a search, or small
    if (name == "clearance") value = 2e-3, other = 1e-3;
    if (name == "lost_mass") value = 0.01, other = 0.02;
    if (name == "separation_speed_hz") value = 34, other = 32;
    if (statable.instead_of.empty()) {
      const double usual = standard[name];
      value = usual * 0.98;
      other = usual * 1.04;
    }
    std::map<std::string, double> numbers = short_run();
    if (name == "separation_speed_hz") {
      numbers.erase("separation_time");
      numbers["until"] = 2;
    }
    Json expected = standard;
    expected["until"] = numbers["until"];
    numbers[name] = value;
    expect_stated(inputs(as_options(numbers)), expected, name, value);
    write("a.toml", "[parameters]\n" + as_keys(numbers));
    expect_stated(inputs("--scene a.toml"), expected, name, value);
    numbers[name] = other;
    write("b.toml", "[parameters]\n" + as_keys(numbers) + "[[run]]\nname = \"b\"\n" +
                        as_keys({{name, value}}));
    expect_stated(inputs("--scene b.toml"), expected, name, value);
    expect_stated(inputs("--scene b.toml" + option(name) + fmt::format("{}", other)), expected,
                  name, other);
  }
}

// Choices have two names each; one of them is the default.
TEST_F(Options, EachStateTheChoiceThatTheyName) {
  const std::string start = as_options(short_run());
  struct Choice {
    const char *name, *value;
    std::map<std::string, std::string> shown;  ///< beside the defaults
  };
  const std::map<std::string, std::string> standard = {{"equations", "published"},
                                                       {"velocity_jump", "twice"},
                                                       {"gravity_moment", "whole"},
                                                       {"method", "event"}};
  const std::vector<Choice> choices = {
      {"equations", "published", {}},
      {"equations",
       "consistent",
       {{"equations", "consistent"}, {"velocity_jump", "once"}, {"gravity_moment", "balanced"}}},
      {"velocity_jump", "twice", {}},
      {"velocity_jump", "once", {{"equations", "mixed"}, {"velocity_jump", "once"}}},
      {"gravity_moment", "whole", {}},
      {"gravity_moment", "balanced", {{"equations", "mixed"}, {"gravity_moment", "balanced"}}},
      {"method", "event", {}},
      {"method", "rk4", {{"method", "rk4"}}}};
  for (const auto& [name, value, shown] : choices) {
    const std::string key = std::string(name) + " = \"" + value + "\"\n";
    write("a.toml", "[parameters]\n" + as_keys(short_run()) + key);
    write("b.toml", "[parameters]\n" + as_keys(short_run()) + "[[run]]\nname = \"b\"\n" + key);
    for (const std::string& arguments :
         {start + option(name) + value, std::string("--scene a.toml"),
          std::string("--scene b.toml")}) {
      const Json printed = summary(arguments);
      for (const auto& [key_shown, standard_value] : standard)
        EXPECT_EQ(printed[key_shown],
                  shown.contains(key_shown) ? shown.at(key_shown) : standard_value)
            << arguments << ": " << key_shown;
    }
  }
  const std::string none = " --start-speed-hz 30 --until 0.02";
  EXPECT_EQ(inputs(none)["no_separation"], false);
  EXPECT_EQ(inputs(none + " --no-separation")["no_separation"], true);
  for (const bool no : {false, true}) {
    write("c.toml", fmt::format("[parameters]\nstart_speed_hz = 30\nuntil = 0.02\n"
                                "[[run]]\nname = \"c\"\nno_separation = {}\n",
                                no));
    EXPECT_EQ(inputs("--scene c.toml")["no_separation"], no);
  }
}

TEST_F(Options, StateTheDigitsOfARun) {
  const std::string start = as_options(short_run()), keys = as_keys(short_run());
  const auto digits = [&](const std::string& arguments) {
    return summary(arguments)["digits"]["asked"];
  };
  write("a.toml", "[parameters]\n" + keys + "digits = 4\n");
  write("b.toml", "[parameters]\n" + keys + "digits = 5\n[[run]]\nname = \"b\"\ndigits = 4\n");
  EXPECT_EQ(digits(start + " --digits 4"), 4);
  EXPECT_EQ(digits("--scene a.toml"), 4);
  EXPECT_EQ(digits("--scene b.toml"), 4);
  EXPECT_EQ(digits("--scene b.toml --digits 3 --budget 100"), 3);
  EXPECT_FALSE(summary(start).contains("digits"));
}

// They are not only shown: the run is the one that they state.
TEST_F(Options, AreThoseOfTheRun) {
  const auto steps = [&](const std::string& arguments) {
    return summary("--start-speed-hz 30 " + arguments)["steps"].get<long>();
  };
  EXPECT_EQ(steps("--until 0.02 --no-separation --method rk4 --step-run-up 2e-3"), 10);
  EXPECT_EQ(
      steps("--until 0.02 --separation-time 0.01 --method rk4 --step-run-up 2e-3 --step-rub 5e-4"),
      5 + 20);
  const std::string run_up = "--no-separation --until 2 --tolerance ";
  EXPECT_GT(steps(run_up + "1e-11"), 1.5 * static_cast<double>(steps(run_up + "1e-8")));
  EXPECT_GT(steps(run_up + "1e-8"), 1.2 * static_cast<double>(steps(run_up + "1e-6")));
  EXPECT_TRUE(summary("--no-separation --until 0.01 --method rk4")["tolerance"].is_null());
  EXPECT_EQ(summary("--no-separation --until 0.01 --tolerance 3e-9")["tolerance"], 3e-9);
}

// m e/m/e may be less than 1 by rounding.
TEST_F(Options, MayStateThatTheLostMassIsNone) {
  for (const char* rotor : {"--mass 5.6 --eccentricity 4e-4", "--mass 4.9 --eccentricity 1.1e-4"}) {
    const Json whole =
        inputs(std::string(rotor) + " --lost-mass 0 --start-speed-hz 150 --separation-time 1e-3");
    EXPECT_EQ(whole["unbalance_factor"], 1) << rotor;
  }
}

// What a scene's window has is traced, by rows at equal distances as well.
TEST_F(Options, OfRowsKeepToTheScenesWindow) {
  write("s.toml",
        "window = { from_s = 0.004, until_s = 0.012 }\n"
        "[parameters]\nstart_speed_hz = 30\nuntil = 0.02\nno_separation = true\n");
  for (const char* rows : {"--rows 5", "--every 0.002"}) {
    EXPECT_EQ(rotor(std::string("run --scene s.toml --trace t.csv ") + rows).status, 0);
    EXPECT_EQ(rows_of("t.csv").size(), 1U + 5) << rows;
    EXPECT_TRUE(rows_of("t.csv").back().starts_with("run,0.012,")) << rows_of("t.csv").back();
  }
}

TEST_F(Options, MayEndARunElsewhereThanItsScenesWindow) {
  write("s.toml",
        "window = { from_s = 0.004, until_s = 0.012 }\n"
        "[parameters]\nstart_speed_hz = 30\nuntil = 0.02\nno_separation = true\n");
  for (const char* rows : {"", "--rows 5"}) {
    const std::string traced = std::string("run --scene s.toml --trace t.csv ") + rows;
    for (const auto& [until, last] : {std::pair("0.008", "0.008"), {"0.1", "0.012"}}) {
      EXPECT_EQ(rotor(traced + " --until " + until).status, 0);
      EXPECT_TRUE(rows_of("t.csv")[1].starts_with("run,0.004,")) << rows;
      EXPECT_TRUE(rows_of("t.csv").back().starts_with(fmt::format("run,{},", last))) << rows;
    }
    for (const std::string until : {"0.003", "0.004"}) {
      if (until == "0.004" && *rows == '\0') continue;  // the one instant of which it has a row
      EXPECT_EQ(rotor(traced + " --until " + until + " 2> messages").status, 1);
      EXPECT_EQ(content("messages"),
                "rotor: --trace t.csv: nothing of the run lies in the window\n");
    }
  }
  EXPECT_EQ(summary("--scene s.toml --until 0.003")["final_time_s"], 0.003);
  write("w.toml", "window = { from_s = 0.04, until_s = 0.05 }\n[parameters]\nuntil = 0.03\n");
  expect_refusal("run --scene w.toml --friction 0.2", "window: must lie inside the run");
  write("s.toml", "window = { from_s = 29.1, until_s = 29.3 }\n");
  EXPECT_EQ(summary("--scene s.toml --start-speed-hz 100")["final_time_s"], 0.25);
}

TEST_F(Options, MayBeTakenBackByARun) {
  write("s.toml",
        "[parameters]\nstart_speed_hz = 150\nuntil = 0.01\nno_separation = true\n"
        "[[run]]\nname = \"loses\"\nno_separation = false\n");
  EXPECT_EQ(summary("--scene s.toml")["mass_loss_reached"], true);
}

// A window is that of each run, not of the shortest one.
TEST_F(Options, OfAChosenRunAreNotThoseOfAnother) {
  write("s.toml",
        "[parameters]\nstart_speed_hz = 30\nno_separation = true\n"
        "[[run]]\nname = \"short\"\nuntil = 0.01\n[[run]]\nname = \"long\"\nuntil = 0.02\n");
  for (const char* rows : {"", "--rows 5"})
    for (const auto& [run, last] : {std::pair("short", "0.01"), {"long", "0.02"}}) {
      EXPECT_EQ(
          rotor(fmt::format("run --scene s.toml --trace t.csv --run {} {}", run, rows)).status, 0);
      EXPECT_TRUE(rows_of("t.csv").back().starts_with(fmt::format("{},{},", run, last))) << rows;
    }
}

// Options stand above what the scene states of the mass loss.
TEST_F(Options, StateWhetherThereIsAMassLoss) {
  write("s.toml", "[parameters]\nstart_speed_hz = 30\nuntil = 0.02\nseparation_time = 0.01\n");
  EXPECT_EQ(inputs("--scene s.toml --no-separation")["no_separation"], true);
  write("s.toml", "[parameters]\nstart_speed_hz = 30\nuntil = 0.02\nno_separation = true\n");
  const Json late = inputs("--scene s.toml --separation-time 0.015");
  EXPECT_EQ(late["no_separation"], false);
  EXPECT_EQ(late["separation_time"], 0.015);
}

TEST_F(Options, OfTheTraceStateItsRunItsColumnsAndItsBeginning) {
  write("two.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 0.004, until_s = 0.012 }\n"
        "[parameters]\nstart_speed_hz = 30\nuntil = 0.02\nno_separation = true\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\ngravity = 0\n");
  const auto first = [&](const std::string& arguments) {
    EXPECT_EQ(rotor("run --scene two.toml --trace t.csv " + arguments).status, 0) << arguments;
    return rows_of("t.csv")[0] + '|' + rows_of("t.csv")[1];
  };
  EXPECT_TRUE(first("--run a").starts_with("run,time_s,rho_m|a,0.004,"));
  EXPECT_TRUE(first("--run b").starts_with("run,time_s,rho_m|b,0.004,"));
  EXPECT_TRUE(rows_of("t.csv").back().starts_with("b,0.012,"));
  EXPECT_TRUE(first("--run b --from 0.007").starts_with("run,time_s,rho_m|b,0.007,"));
  EXPECT_TRUE(rows_of("t.csv").back().starts_with("b,0.02,"));
  EXPECT_TRUE(first("--run a --columns q1_m,time_s").starts_with("run,q1_m,time_s|a,"));
  EXPECT_EQ(inputs("--scene two.toml --run a")["gravity"], 9.81);
  EXPECT_EQ(inputs("--scene two.toml --run b")["gravity"], 0);
}

// `figure` puts its options above [parameters] and below what a [[run]] states itself.
TEST_F(Options, OfFiguresStandBetweenParametersAndRuns) {
  write("fig31.toml",
        "[parameters]\nstart_speed_hz = 100\nuntil = 0.01\nequations = \"consistent\"\n"
        "method = \"rk4\"\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\nequations = \"consistent\"\nmethod = \"rk4\"\n");
  const auto line = [&](const std::string& arguments, const std::string& run) {
    EXPECT_EQ(rotor("figure 31 --scenes . --out . " + arguments).status, 0);
    const std::string csv = content("fig31.csv");
    const std::size_t begin = csv.find("# " + run + ": ");
    return csv.substr(begin, csv.find(", mass", begin) - begin);
  };
  EXPECT_EQ(line("", "a"), "# a: equations consistent, method rk4");
  const std::string options = "--equations published --method event";
  EXPECT_EQ(line(options, "a"), "# a: equations published, method event");
  EXPECT_EQ(line(options, "b"), "# b: equations consistent, method rk4");
}

}  // namespace
}  // namespace rotor
