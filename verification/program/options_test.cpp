/// Inputs reach the right place: every number of a scenario by command line and scene file, every
/// choice, and their precedence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "figures/input/scenario_spec.hpp"
#include "figures/results/json.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/read_csv.hpp"

namespace rotor {
namespace {

using Options = CommandLine;

std::string option(std::string name) {
  std::ranges::replace(name, '_', '-');
  return " --" + name + ' ';
}

/// As options, or as keys.
std::string stated(const std::map<std::string, double>& numbers, bool as_options) {
  std::string all;
  for (const auto& [name, value] : numbers)
    all += as_options ? option(name) + fmt::format("{}", value)
                      : fmt::format("{} = {}\n", name, value);
  return all;
}

// By an option; by a key of [parameters]; by one of [[run]] that overrides it; by an option that
// overrides both: always the same run, in which only that input differs.
TEST_F(Options, EachStateTheNumberThatTheyName) {
  const std::map<std::string, double> short_run = {
      {"start_speed_hz", 30}, {"until", 0.02}, {"mass_loss_time", 0.001}};
  const std::map<std::string, double> found = {
      {"clearance", 2e-3},        {"lost_mass", 0.01},
      {"mass_loss_speed_hz", 34}, {"contact_exponent", 1.1},  // not below 1
      {"start_x", 1e-3},          {"start_y", 2e-3},
      {"start_velocity_x", -0.1}, {"start_velocity_y", 0.2}};
  const Json standard = summary(stated(short_run, true))["inputs"];
  for (const InputQuantity& input_quantity : input_quantities()) {
    const std::string name(input_quantity.quantity.name);
    if (name.ends_with("_rpm")) continue;  // see the next test
    auto numbers = short_run;
    if (name == "mass_loss_speed_hz") {
      numbers.erase("mass_loss_time");
      numbers["until"] = 2;
    }
    if (name == "contact_exponent") numbers["reference_indentation"] = 1e-4;
    const double value =
        found.contains(name) ? found.at(name) : 0.98 * standard[name].get<double>();
    numbers[name] = value;
    const Json by_option = summary(stated(numbers, true));
    auto others = numbers;
    others[name] *= 1.02;
    write("a.toml", "[parameters]\n" + stated(numbers, false));
    write("b.toml", "[parameters]\n" + stated(others, false) + "[[run]]\nname = \"b\"\n" +
                        stated({{name, value}}, false));
    write("c.toml", "[parameters]\n" + stated(others, false));
    for (const std::string& scene :
         {std::string("a.toml"), std::string("b.toml"), "c.toml" + stated({{name, value}}, true)})
      EXPECT_EQ(summary(scene), by_option) << scene << ' ' << name;
    Json expected = standard;
    expected["until"] = numbers["until"];
    for (const InputQuantity& other : input_quantities())
      if (input_quantity.of_start && other.of_start)
        expected[std::string(other.quantity.name)] = 0.;
    if (name == "clearance")
      expected["stator_radius"] = 0.06 + value;
    else if (name == "lost_mass")  // Eq. (5)
      expected["unbalance_factor"] = (5 * 0.15e-3 + value * 0.06) / (5 - value) / 0.15e-3;
    else if (name == "mass_loss_speed_hz")
      expected["mass_loss_time"] = by_option["inputs"]["mass_loss_time"];
    else
      expected[name] = value;
    if (name == "contact_exponent") expected["reference_indentation"] = 1e-4;
    for (const auto& [key, number] : expected.items()) {
      const Json& shown = by_option["inputs"][key];
      EXPECT_TRUE(shown == number ||
                  std::abs(shown.get<double>() / number.get<double>() - 1) < 1e-14)
          << name << ": " << key << " is " << shown;
    }
    if (name == "mass_loss_speed_hz") {
      EXPECT_NEAR(by_option["speed_at_mass_loss_Hz"].get<double>(), value, 1e-9);
    }
  }
}

// As an option, in a scene, for an estimate and over an axis, 60 revolutions per minute are 1 Hz.
TEST_F(Options, StateSpeedsInRevolutionsPerMinuteAsWell) {
  const std::string in_Hz =
      " --start-speed-hz 34 --motor-off-hz 40 --mass-loss-speed-hz 35 --until 1";
  const std::map<std::string, double> numbers = {{"start_speed_rpm", 2040},
                                                 {"until", 1},
                                                 {"motor_off_rpm", 2400},
                                                 {"mass_loss_speed_rpm", 2100}};
  const std::string in_rpm = stated(numbers, true);
  const Json run = summary(in_Hz);
  EXPECT_EQ(summary(in_rpm), run);
  write("s.toml", "[parameters]\n" + stated(numbers, false));
  EXPECT_EQ(summary("s.toml"), run);
  EXPECT_EQ(rotor("estimate" + in_rpm).output, rotor("estimate" + in_Hz).output);
  write("axis.toml",
        "columns = [\"peak_force_to_rolling_N\"]\n[parameters]\nuntil = 0.02\n[[axis]]\n"
        "quantity = \"start_speed_rpm\"\nvalues = [9000]\n");
  ASSERT_EQ(rotor("sweep axis.toml").status, 0);
  EXPECT_EQ(rows_of("axis.csv").at(1),
            fmt::format("9000,{},,", summary("--start-speed-hz 150 --until 0.02 --stop-on outcome")
                                         .at("peak_force_to_rolling_N")
                                         .dump()));
  for (const char* other : {"--mass-loss-speed-hz 35", "--mass-loss-time 1"})
    expect_refusal(std::string("run --mass-loss-speed-rpm 2100 ") + other,
                   "one determines the other; state one of them");
}

// A refusal names a number as it was stated: by its own name and value, not by those that follow.
TEST_F(Options, AreRefusedInTheUnitInWhichTheyAreStated) {
  for (const auto& [options, number] :
       {std::pair("--mass-loss-speed-rpm 9600", "mass_loss_speed_rpm = 9600 rpm"),
        {"--start-speed-rpm 3000 --mass-loss-speed-hz 25", "start_speed_rpm = 3000 rpm"},
        {"--start-speed-rpm 603.6 --support-damping 0.1", "start_speed_rpm = 603.6 rpm"},
        {"--mass-loss-speed-rpm 90 --mass-loss-time 1", "mass_loss_speed_rpm = 90 rpm and"},
        {"--lost-mass 4.9", "lost_mass = 4.9 kg"},
        {"--clearance 1e-19", "clearance = 1e-19 m"}}) {
    expect_refusal(std::string("run ") + options, number);
    const std::string message = rotor(std::string("run ") + options).output;
    for (const char* other : {"_hz = 50", "_hz = 160", "_hz = 10.06",
                              "unbalance_factor =", "stator_radius =", "mass_loss_speed_hz and"})
      EXPECT_FALSE(has(message, other));
  }
  EXPECT_TRUE(
      has(rotor("run --motor-off-rpm 900000 --until 1").output, "motor_off_rpm = 900000 rpm"));
}

// Whichever of several inputs a check refuses: an option before the [[run]], and that before
// [parameters].
TEST_F(Options, AreBlamedIfTheyAreStatedLast) {
  const std::string start = "start_speed_hz = 60\nuntil = 1\n";
  for (const auto& [name, value, good] : {std::tuple("inertia", "1e-7", "9e-3"),
                                          {"rotor_radius", "0.07", "0.05"},
                                          {"stator_radius", "0.05", "0.07"},
                                          {"clearance", "1e-19", "1e-2"},
                                          {"eccentricity", "0.07", "1e-4"},
                                          {"lost_mass", "5", "0.01"},
                                          {"mass_loss_speed_rpm", "3000", "6000"},
                                          {"start_speed_rpm", "603.6", "6000"},
                                          {"contact_exponent", "1.5", "1"},
                                          {"start_x", "1", "0"},
                                          {"drive", "\"constant_speed\"", "\"motor\""}}) {
    const std::string bad = std::string(name) + " = " + value + '\n',
                      fine = std::string(name) + " = " + good + '\n';
    const std::string others = (name == std::string("start_speed_rpm") ? "until = 1\n" : start) +
                               "support_damping = 0.1\n" +
                               (name == std::string("drive") ? "mass_loss_speed_hz = 90\n" : "");
    const auto refuse = [&, name = name, value = value](const std::string& scene,
                                                        const std::string& place) {
      write("s.toml", scene);
      std::string plain = value;
      std::erase(plain, '"');
      expect_refusal("run s.toml" + (place[0] == '-' ? option(name) + plain : ""), place);
    };
    const std::string line = ": " + std::string(name) + ": ";
    refuse("[parameters]\n" + others + bad,
           fmt::format("s.toml:{}{}", 2 + std::ranges::count(others, '\n'), line));
    refuse("[parameters]\n" + others + fine + "[[run]]\nname = \"a\"\n" + bad,
           fmt::format("s.toml:{}{}", 5 + std::ranges::count(others, '\n'), line));
    refuse("[parameters]\n" + others + fine + "[[run]]\nname = \"a\"\n" + fine,
           option(name).substr(1, option(name).size() - 2) + ", with s.toml: ");
  }
  write("s.toml",
        "[parameters]\nrotor_radius = 0.05\n[[axis]]\nquantity = \"friction\"\nvalues = [0.1]\n"
        "[[axis]]\nquantity = \"stator_radius\"\nvalues = [0.04]\n");
  expect_refusal("sweep s.toml", "s.toml:6: where friction = 0.1, stator_radius = 0.04: ");
  write("s.toml",
        "[parameters]\nuntil = 30\ninertia = 1e-7\n[[axis]]\nquantity = \"friction\"\n"
        "values = [0.1]\n");
  expect_refusal("sweep s.toml", "s.toml:3: where friction = 0.1: inertia = 1e-07 kg m^2: ");
}

// However it is stated, a choice is shown, and changes the run.
TEST_F(Options, EachStateTheChoiceThatTheyName) {
  const std::string start = " --start-speed-hz 40 --mass-loss-time 0.001 --until 0.05 ",
                    keys = "start_speed_hz = 40\nmass_loss_time = 0.001\nuntil = 0.05\n";
  const auto without_costs = [](Json all) {
    for (const char* key : {"equations", "velocity_jump", "gravity_moment", "method"})
      all.erase(key);
    return all;
  };
  const Json standard = without_costs(summary(start));
  for (const auto& [name, value, is_standard] : {std::tuple("equations", "published", true),
                                                 {"equations", "corrected", false},
                                                 {"velocity_jump", "twice", true},
                                                 {"velocity_jump", "once", false},
                                                 {"gravity_moment", "whole", true},
                                                 {"gravity_moment", "balanced", false},
                                                 {"method", "event", true},
                                                 {"method", "rk4", false}}) {
    const std::string key = fmt::format("{} = \"{}\"\n", name, value);
    write("a.toml", "[parameters]\n" + keys + key);
    write("b.toml", "[parameters]\n" + keys + "[[run]]\nname = \"b\"\n" + key);
    const Json by_option = summary(start + option(name) + value);
    EXPECT_EQ(by_option[name], value);
    EXPECT_EQ(without_costs(by_option) == standard, is_standard) << name << ' ' << value;
    for (const char* scene : {"a.toml", "b.toml"})
      EXPECT_EQ(summary(scene), by_option) << scene << ' ' << key;
  }
  EXPECT_EQ(summary(start + "--velocity-jump once --gravity-moment balanced"),
            summary(start + "--equations corrected"));
  EXPECT_EQ(summary(start + "--equations corrected"), summary(start + "--equations consistent"));
  for (const bool no : {false, true}) {
    write("c.toml", fmt::format("[parameters]\nstart_speed_hz = 30\nuntil = 0.02\n"
                                "no_mass_loss = {}\n[[run]]\nname = \"c\"\nno_mass_loss = {}\n",
                                !no, no));
    EXPECT_EQ(summary("c.toml")["inputs"]["no_mass_loss"], no);
  }
  write("d.toml", "[parameters]\n" + keys + "digits = 5\n[[run]]\nname = \"d\"\ndigits = 4\n");
  EXPECT_EQ(summary("d.toml"), summary(start + "--digits 4"));
  EXPECT_EQ(summary("d.toml --digits 3"), summary(start + "--digits 3"));
}

// What is stated determines the run, and stands above its trace.
TEST_F(Options, AllStandAboveATrace) {
  const auto head = [&](const std::string& arguments) {
    EXPECT_EQ(rotor("run --until 0.01 --trace t.csv " + arguments).status, 0);
    const std::string text = content("t.csv");
    return text.substr(0, text.find("\n# time_s: "));
  };
  const std::string constant = head(
      "--drive constant_speed --torque 5 --start-speed-hz 100 --start-x 1e-4 "
      "--start-velocity-y -0.25");
  for (const char* stated : {"drive constant_speed", "torque = 0 N m", "start_x = 0.0001 m",
                             "start_y = 0 m", "start_velocity_y = -0.25 m/s"})
    EXPECT_TRUE(has(constant, stated)) << stated << '\n' << constant;
  const std::string balanced =
      head("--eccentricity 0 --lost-mass 0.01 --start-speed-hz 100 --mass-loss-time 0.005");
  EXPECT_TRUE(has(balanced, "lost_mass = 0.01 kg"));
  EXPECT_FALSE(has(balanced, "unbalance_factor"));
}

// A trace has the window of its scene, or the start stated by an option, to the row.
TEST_F(Options, OfTheTraceStateItsRunItsColumnsAndItsBeginning) {
  write("two.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 0.004, until_s = 0.012 }\n"
        "[parameters]\nstart_speed_hz = 30\nuntil = 0.02\nno_mass_loss = true\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\ngravity = 0\n");
  for (const auto& [arguments, head, first, last] :
       {std::tuple("--run a", "run,time_s,rho_m", "a,0.004,", "a,0.012,"),
        {"--run b --every 0.002", "run,time_s,rho_m", "b,0.004,", "b,0.012,"},
        {"--run b --until 0.008", "run,time_s,rho_m", "b,0.004,", "b,0.008,"},
        {"--run b --from 0.007", "run,time_s,rho_m", "b,0.007,", "b,0.02,"},
        {"--run a --columns time_s,q1_m", "run,time_s,q1_m", "a,0.004,", "a,0.012,"}}) {
    EXPECT_EQ(rotor(std::string("run two.toml --trace t.csv ") + arguments).status, 0);
    const auto rows = rows_of("t.csv");
    EXPECT_EQ(rows.at(0), head);
    EXPECT_TRUE(rows.at(1).starts_with(first)) << arguments << ": " << rows[1];
    EXPECT_TRUE(rows.back().starts_with(last)) << arguments << ": " << rows.back();
    EXPECT_TRUE(rows.size() == 1 + 5 || std::string(arguments).find("--every") == std::string::npos)
        << arguments;
  }
  EXPECT_EQ(rotor("run two.toml --run a --trace t.csv --until 0.003").status, 1);
}

// The rows of all runs of a scene, in their order.
TEST_F(Options, OfTheTraceHoldForEachRun) {
  write("two.toml",
        "columns = [\"time_s\", \"rho_m\"]\n[parameters]\nstart_speed_hz = 150\nuntil = 0.02\n"
        "[[run]]\nname = \"a\"\n[[run]]\nname = \"b\"\nfriction = 0.1\n");
  ASSERT_EQ(rotor("run two.toml --trace t.csv --events e.csv").status, 0);
  for (const std::string run : {"a", "b"}) {
    rotor(fmt::format("run two.toml --run {0} --trace t{0}.csv --events e{0}.csv", run));
    for (const std::string table : {"t", "e"}) {
      std::vector<std::string> rows = rows_of(table + ".csv");
      std::erase_if(rows, [&](const auto& row) { return row[0] != 'r' && row[0] != run[0]; });
      EXPECT_GT(rows.size(), 5U);
      EXPECT_EQ(rows, rows_of(table + run + ".csv"));
    }
  }
}

// A rotor with a mass, inertia or radius of its own has the corrected equations in all commands,
// unless others are stated.
TEST_F(Options, LeaveTheEquationsOfAnotherRotorCorrected) {
  write("fig30.toml",
        "columns = [\"time_s\", \"rho_m\"]\n[parameters]\nmass = 4\nstart_speed_hz = 150\n"
        "until = 1e-3\n");
  write("s.toml",
        "columns = [\"equations\"]\n[parameters]\nstart_speed_hz = 150\nuntil = 1e-3\n"
        "[[axis]]\nquantity = \"mass\"\nvalues = [4, 6]\n");
  EXPECT_EQ(summary("fig30.toml")["equations"], "corrected");
  EXPECT_EQ(summary("fig30.toml --equations published")["equations"], "published");
  EXPECT_EQ(summary("--friction 0.1 --until 1")["equations"], "published");
  ASSERT_EQ(rotor("figure 30 --scenes . --out .").status, 0);
  EXPECT_TRUE(has(content("fig30.csv"), "run: equations corrected, "));
  ASSERT_EQ(rotor("sweep s.toml").status, 0);
  EXPECT_TRUE(has(content("s.csv"), "# equations corrected,"));
  for (const CsvRow& row : read_csv(folder_ / "s.csv")) EXPECT_EQ(row["equations"], "corrected");
}

// Options of `figure` override [parameters], but not a [[run]].
TEST_F(Options, OfFiguresStandBetweenParametersAndRuns) {
  write("fig31.toml",
        "[parameters]\nstart_speed_hz = 100\nuntil = 0.01\nequations = \"corrected\"\n"
        "method = \"rk4\"\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\nequations = \"corrected\"\nmethod = \"rk4\"\n");
  const auto line = [&](const std::string& arguments, const std::string& run) {
    EXPECT_EQ(rotor("figure 31 --scenes . --out . " + arguments).status, 0);
    const std::string csv = content("fig31.csv");
    const std::size_t begin = csv.find("# " + run + ": ");
    return csv.substr(begin, csv.find(", mass", begin) - begin);
  };
  EXPECT_EQ(line("", "a"), "# a: equations corrected, method rk4");
  const std::string options = "--equations published --method event";
  EXPECT_EQ(line(options, "a"), "# a: equations published, method event");
  EXPECT_EQ(line(options, "b"), "# b: equations corrected, method rk4");
}

}  // namespace
}  // namespace rotor
