/// Inputs reach the right place: every number of a scenario by command line and scene file, every
/// choice, and their precedence.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <tuple>

#include "figures/data/read_csv.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/results/json.hpp"
#include "figures/sweep/sweep_row.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/summary_of.hpp"

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
      {"start_speed_Hz", 30}, {"until", 0.02}, {"mass_loss_time", 0.001}};
  const std::map<std::string, double> found = {
      {"clearance", 2e-3},       {"lost_mass", 0.01},        {"mass_loss_speed_Hz", 34},
      {"contact_exponent", 1.1},  // not below 1
      {"ring_offset_x", -2e-4},  {"ring_offset_y", 1e-4},    {"start_x", 1e-3},
      {"start_y", 2e-3},         {"start_velocity_x", -0.1}, {"start_velocity_y", 0.2}};
  const Json standard = summary(stated(short_run, true))["inputs"];
  for (const InputQuantity& input_quantity : input_quantities()) {
    const std::string name(input_quantity.quantity.name);
    if (name.ends_with("_rpm")) continue;  // see the next test
    auto numbers = short_run;
    if (name == "mass_loss_speed_Hz") {
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
    else if (name == "mass_loss_speed_Hz")
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
    if (name == "mass_loss_speed_Hz") {
      EXPECT_NEAR(by_option["speed_at_mass_loss_Hz"].get<double>(), value, 1e-9);
    }
  }
}

// As an option, in a scene, for an estimate and over an axis, 60 revolutions per minute are 1 Hz.
TEST_F(Options, StateSpeedsInRevolutionsPerMinuteAsWell) {
  const std::string in_Hz =
      " --start-speed-Hz 34 --motor-off-Hz 40 --mass-loss-speed-Hz 35 --until 1";
  const std::map<std::string, double> numbers = {{"start_speed_rpm", 2040},
                                                 {"until", 1},
                                                 {"motor_off_rpm", 2400},
                                                 {"mass_loss_speed_rpm", 2100}};
  const std::string in_rpm = stated(numbers, true);
  const Json run = summary(in_Hz);
  EXPECT_EQ(summary(in_rpm), run);
  write("s.toml", "[parameters]\n" + stated(numbers, false));
  EXPECT_EQ(summary("s.toml"), run);
  EXPECT_EQ(rotor("estimate --all" + in_rpm).output, rotor("estimate --all" + in_Hz).output);
  EXPECT_TRUE(has(rotor("estimate" + in_rpm).output, " 2100 rpm "));
  write("axis.toml",
        "columns = [\"peak_force_to_rolling_N\"]\n[parameters]\nuntil = 0.02\n[[axis]]\n"
        "quantity = \"start_speed_rpm\"\nvalues = [9000]\n");
  ASSERT_EQ(rotor("sweep axis.toml").status, 0);
  EXPECT_EQ(rows_of("axis.csv").at(1),
            fmt::format(
                "9000,{},",
                summary("--start-speed-Hz 150 --until 0.02").at("peak_force_to_rolling_N").dump()));
  for (const char* other : {"--mass-loss-speed-Hz 35", "--mass-loss-time 1"})
    expect_refusal(std::string("run --mass-loss-speed-rpm 2100 ") + other,
                   "one determines the other; state one of them");
}

// A refusal names a number as it was stated: by its own name and value, not by those that follow.
TEST_F(Options, AreRefusedInTheUnitInWhichTheyAreStated) {
  for (const auto& [options, number] :
       {std::pair("--mass-loss-speed-rpm 9600", "mass_loss_speed_rpm = 9600 rpm"),
        {"--start-speed-rpm 3000 --mass-loss-speed-Hz 25", "start_speed_rpm = 3000 rpm"},
        {"--start-speed-rpm 603.6 --support-damping 0.1", "start_speed_rpm = 603.6 rpm"},
        {"--mass-loss-speed-rpm 90 --mass-loss-time 1", "mass_loss_speed_rpm = 90 rpm and"},
        {"--lost-mass 4.9", "lost_mass = 4.9 kg"},
        {"--clearance 1e-19", "clearance = 1e-19 m"}}) {
    expect_refusal(std::string("run ") + options, number);
    const std::string message = rotor(std::string("run ") + options).output;
    for (const char* other : {"_Hz = 50", "_Hz = 160", "_Hz = 10.06",
                              "unbalance_factor =", "stator_radius =", "mass_loss_speed_Hz and"})
      EXPECT_FALSE(has(message, other));
  }
  EXPECT_TRUE(
      has(rotor("run --motor-off-rpm 900000 --until 1").output, "motor_off_rpm = 900000 rpm"));
}

TEST_F(Options, AreNotTakenForFilesWithTheirNames) {
  fs::create_symlink("/dev/full", folder_ / "stator_radius");
  expect_refusal("run --clearance 1e-3 --no-mass-loss --until 0.1 --trace stator_radius",
                 "rotor: stator_radius: cannot be written");
}

// Numbers typed in a wrong unit, or without thought: what cannot be computed with is refused by
// name, and at once, because progress would be shown after a second and a half.
TEST_F(Options, LeadToNoNumberThatIsNotFinite) {
  const std::vector<std::string> starts = {
      " --mass-loss-time 0.01 --until 0.02",
      " --equations corrected --start-speed-Hz 150 --until 0.01",
      " --drive constant_speed --start-speed-Hz 60 --clearance 1e-3 --until 0.01"};
  const std::regex not_finite("(^|[^a-z_])(inf|nan)([^a-z_]|$)");
  const auto status_of = [&](const std::string& command) {
    const auto [status, output] = shell("timeout -s KILL 10 $rotor " + command);
    const auto is_named = [text = output](std::string name) {
      const bool is_input = text.find(name) != text.npos;
      std::ranges::replace(name, '_', '-');
      return is_input || text.find("--" + name) != text.npos;
    };
    EXPECT_TRUE(status == 0 || (status == 1 && std::ranges::any_of(varied_inputs(), is_named)) ||
                output.find(" to go\n") != output.npos)
        << command << ": " << output;
    EXPECT_FALSE(std::regex_search(output, not_finite)) << command << ": " << output;
    return status;
  };
  for (const InputQuantity& input : input_quantities()) {
    const Quantity& q = input.quantity;
    const std::string name = "--" + option(std::string(q.name)).substr(3, q.name.size());
    const auto with = [&](std::string start, double number) {
      if (const auto at = start.find(name + ' '); at != start.npos)  // stated once
        start.erase(at, start.find(" --", at + 1) - at);
      return fmt::format("{} {}={}", start, name, number);
    };
    for (const double number : {1.7e308, 1e300, 1e150, 1e-150, 1e-300})
      EXPECT_EQ(status_of("run" + with(starts[0], number)) == 0, q.allows(number)) << name;
    for (const double end : {q.least, q.least == 0 ? least_positive : q.least, q.greatest}) {
      const std::string first = with(starts[0], end);
      for (const char* command : {"run", "run --json"}) status_of(command + first);
      status_of("estimate" + first + " 2>messages || { cat messages; false; }");  // no remarks
      for (const std::string& start : starts) status_of("run --all" + with(start, end));
    }
  }
}

// Whichever of several inputs a check refuses: an option before the [[run]], and that before
// [parameters].
TEST_F(Options, AreBlamedIfTheyAreStatedLast) {
  const std::string start = "start_speed_Hz = 60\nuntil = 1\n";
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
                               (name == std::string("drive") ? "mass_loss_speed_Hz = 90\n" : "");
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
  const std::string start = " --start-speed-Hz 40 --mass-loss-time 0.001 --until 0.05 ",
                    keys = "start_speed_Hz = 40\nmass_loss_time = 0.001\nuntil = 0.05\n";
  const auto without_costs = [](Json all) {
    for (const char* key : {"equations", "velocity_jump", "gravity_moment", "method"})
      all.erase(key);
    return all;
  };
  const Json standard = without_costs(summary(start));
  for (const auto& [name, value, is_standard] : {std::tuple("equations", "corrected", true),
                                                 {"equations", "published", false},
                                                 {"velocity_jump", "once", true},
                                                 {"velocity_jump", "twice", false},
                                                 {"gravity_moment", "balanced", true},
                                                 {"gravity_moment", "whole", false},
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
  EXPECT_EQ(summary(start + "--velocity-jump twice --gravity-moment whole"),
            summary(start + "--equations published"));
  for (const bool no : {false, true}) {
    write("c.toml", fmt::format("[parameters]\nstart_speed_Hz = 30\nuntil = 0.02\n"
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
      "--drive constant_speed --torque 5 --start-speed-Hz 100 --start-x 1e-4 "
      "--start-velocity-y -0.25");
  for (const char* stated : {"drive constant_speed", "torque = 5 N m", "start_x = 0.0001 m",
                             "start_y = 0 m", "start_velocity_y = -0.25 m/s"})
    EXPECT_TRUE(has(constant, stated)) << stated << '\n' << constant;
  const std::string balanced =
      head("--eccentricity 0 --lost-mass 0.01 --start-speed-Hz 100 --mass-loss-time 0.005");
  EXPECT_TRUE(has(balanced, "lost_mass = 0.01 kg"));
  EXPECT_FALSE(has(balanced, "unbalance_factor"));
}

// A trace has the window of its scene, or the start stated by an option, to the row.
TEST_F(Options, OfTheTraceStateItsRunItsColumnsAndItsBeginning) {
  write("two.toml",
        "columns = [\"time_s\", \"rho_m\"]\nwindow = { from_s = 0.004, until_s = 0.012 }\n"
        "[parameters]\nstart_speed_Hz = 30\nuntil = 0.02\nno_mass_loss = true\n"
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
        "columns = [\"time_s\", \"rho_m\"]\n[parameters]\nstart_speed_Hz = 150\nuntil = 0.02\n"
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

// A default is the same if it is stated: by an option, in a scene, in data of a figure, in a
// sweep and in the library. All of these have the corrected equations.
TEST_F(Options, MayStateEachDefaultWithoutAnyChange) {
  std::vector<std::pair<std::string, std::string>> defaults;
  for (const InputQuantity& input : input_quantities())
    if (input.quantity.in)
      defaults.emplace_back(input.quantity.name, fmt::format("{}", input.quantity.of(Scenario{})));
  for (const NamedInput& input : named_inputs()) defaults.emplace_back(input.name, "");
  const Json run = summary(""), law = Json::parse(rotor("estimate --json 2>messages").output);
  EXPECT_EQ(run["equations"], "corrected");
  EXPECT_EQ(run["peak_normal_force_N"], *summary_of(Scenario{}).peak_normal_force_N);
  const auto results = [&](const std::string& parameters) {
    write("fig30.toml", "columns = [\"time_s\", \"rho_m\"]\n[parameters]\n" + parameters);
    EXPECT_EQ(rotor("figure 30 --scenes . --out .").status, 0);
    return content("fig30.csv") + content("fig30.var");
  };
  const std::string data = results("until = 29.35\n");
  for (auto& [name, value] : defaults) {
    const bool is_choice = value.empty();
    if (is_choice) value = run[name];
    const std::string stated = option(name) + value;
    EXPECT_EQ(summary(stated), run) << stated;
    EXPECT_EQ(Json::parse(rotor("estimate --json " + stated + " 2>messages").output), law)
        << stated;
    const std::string in_toml = is_choice ? '"' + value + '"' : value,
                      key = fmt::format("{} = {}\n", name, in_toml);
    EXPECT_EQ(results(key), data) << key;
    write("s.toml", fmt::format("columns = \"all\"\n[[axis]]\nquantity = \"{}\"\nvalues = [{}]\n",
                                name, in_toml));
    ASSERT_EQ(rotor("sweep s.toml --force").status, 0);
    const CsvRow row = read_csv(folder_ / "s.csv").front();
    for (const std::string& column : result_columns())
      EXPECT_EQ(row[column], cell_of(run.at(column))) << key << column;
  }
}

// What a rotor has of the paper's is said if any other quantity is stated, and not of its scenes.
TEST_F(Options, AreSaidToLeaveTheRestToThePaper) {
  const std::string says = "rotor: not stated, so the paper's: ",
                    corrected = "Corrected equations: ";
  const auto messages = [&](const std::string& arguments) {
    const std::string result = rotor("run " + arguments + " 2>messages").output;
    EXPECT_TRUE(result.starts_with(corrected) || has(arguments, "fig13")) << result;
    return content("messages");
  };
  EXPECT_EQ(messages(""),
            "rotor: as printed in the paper: --equations published; that gives other "
            "numbers\n");
  EXPECT_EQ(messages("--until 29.2"), "");
  EXPECT_TRUE(messages("--friction 0.1").starts_with(says + "mass = 5 kg, "));
  EXPECT_TRUE(messages("--mass 5").starts_with(says + "inertia = 0.009 kg m^2, "));
  EXPECT_EQ(messages("'" ROTOR_SOURCES "/figures/paper/fig13.toml'"), "");
}

// Options of `figure` override [parameters], but not a [[run]].
TEST_F(Options, OfFiguresStandBetweenParametersAndRuns) {
  write("fig31.toml",
        "[parameters]\nstart_speed_Hz = 100\nuntil = 0.01\nequations = \"corrected\"\n"
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
