/// What is stated of a scenario, and the scenario that this makes.
#include "figures/scenes/statement.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "figures/data/text.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/simulation/simulation.hpp"
#include "model/simulation/start.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

Statement numbers(std::initializer_list<std::pair<const std::string, double>> stated) {
  Statement statement;
  statement.numbers.insert(stated.begin(), stated.end());
  return statement;
}

std::string refusal(const Statement& statement) {
  try {
    scenario_of(statement);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(Statement, OfNothingIsThePapers) { EXPECT_EQ(scenario_of({}), Scenario{}); }

TEST(Statement, SetsNothingButTheNumberThatItNames) {
  for (const Quantity& quantity : quantities()) {
    const double standard = quantity.of(Scenario{});
    const double value = standard == 0                     ? 1
                         : quantity.name == "rotor_radius" ? 0.9 * standard
                                                           : 1.1 * standard;
    Scenario expected;
    quantity.in(expected) = value;
    if (quantity.name == "separation_time") expected.until = value + 0.25;
    if (quantity.name == "start_speed_hz") {
      expected.parameters.separation_time = 0;
      expected.until = 0.25;
    }
    EXPECT_EQ(scenario_of(numbers({{std::string(quantity.name), value}})), expected)
        << quantity.name;
  }
}

TEST(Statement, EndsAQuarterOfASecondAfterTheMassLossUnlessItSaysWhen) {
  EXPECT_EQ(scenario_of(numbers({{"separation_time", 400}})).until, 400.25);
  EXPECT_EQ(scenario_of(numbers({{"separation_time", 4}, {"until", 7}})).until, 7);
  Statement without = numbers({});
  without.loses_mass = false;
  EXPECT_EQ(refusal(without), "until: must be stated for a run without mass loss");
  without.numbers["until"] = 3;
  EXPECT_EQ(scenario_of(without).until, 3);
  without.numbers["separation_time"] = 2;
  EXPECT_EQ(refusal(without), "separation_time: there is no mass loss in this run");
}

TEST(Statement, ReadsNumbersThatAreNothingElse) {
  EXPECT_EQ(number_in("0.3"), 0.3);
  EXPECT_EQ(number_in("+3e-1"), 0.3);
  EXPECT_EQ(number_in("3E-1"), 0.3);
  EXPECT_EQ(number_in("-.5"), -0.5);
  EXPECT_EQ(number_in("1e-310"), 1e-310);
  EXPECT_EQ(number_in("0"), 0);  // whatever there was before
  for (const char* text :
       {"", " 1", "1 ", "1,5", "0x10", "nan", "inf", "1e", "--1", "1e-999", "1f"})
    EXPECT_EQ(number_in(text), std::nullopt) << text;
}

TEST(Statement, TakesTheClearanceForTheStatorsRadius) {
  const Scenario scenario = scenario_of(numbers({{"clearance", 2e-3}, {"rotor_radius", 0.05}}));
  EXPECT_DOUBLE_EQ(scenario.parameters.stator_radius, 0.052);
}

TEST(Statement, TakesTheLostMassForTheUnbalanceFactor) {
  const double lost = 0.04;
  const Scenario scenario = scenario_of(numbers({{"lost_mass", lost}}));
  EXPECT_NEAR(MassLoss<double>(scenario.parameters).lost_mass, lost, 1e-15);
  for (const double too_much : {5., 6.})
    EXPECT_NE(refusal(numbers({{"lost_mass", too_much}})).find("must be less than mass = 5 kg"),
              std::string::npos);
  EXPECT_NE(refusal(numbers({{"lost_mass", 0.01}, {"eccentricity", 0}})), "");
}

TEST(Statement, RefusesTwoThatDetermineEachOther) {
  for (const auto& [one, other] : {std::pair("clearance", "stator_radius"),
                                   {"lost_mass", "unbalance_factor"},
                                   {"separation_speed_hz", "separation_time"}})
    EXPECT_EQ(refusal(numbers({{one, 1e-3}, {other, 0.07}})),
              std::string(one) + " and " + other + ": one determines the other; state one of them");
}

TEST(Statement, GivesWayToOneAboveItThatDeterminesTheSame) {
  const Statement below = numbers({{"stator_radius", 0.07}, {"friction", 0.1}});
  const Scenario scenario = scenario_of(below.overridden_by(numbers({{"clearance", 1e-3}})));
  EXPECT_DOUBLE_EQ(scenario.parameters.stator_radius, 0.061);
  EXPECT_EQ(scenario.parameters.friction, 0.1);
}

TEST(Statement, TakesNamesWholeOrNotAtAll) {
  for (const std::string_view statable : named_statables())
    for (const char* name :
         {"", "p", "publishe", "published ", "onc", "hole", "even", "rk", "rk44"}) {
      Statement statement;
      EXPECT_THROW(state(statement, statable, name), InputError) << statable << ' ' << name;
    }
}

TEST(Statement, OfAMassLossAboveAnotherTakesWhenAndWhetherItIs) {
  Statement none = numbers({{"until", 3}});
  none.loses_mass = false;
  for (const char* name : {"separation_time", "separation_speed_hz"}) {
    const Statement at = numbers({{name, 1.5}, {"torque", 3}});
    EXPECT_FALSE(scenario_of(at.overridden_by(none)).loses_mass()) << name;
    EXPECT_TRUE(scenario_of(none.overridden_by(at)).loses_mass()) << name;
    Statement both = at;
    both.loses_mass = false;
    EXPECT_EQ(refusal(both), std::string(name) + ": there is no mass loss in this run");
    EXPECT_EQ(refusal(at.overridden_by(both)), refusal(both));
  }
  EXPECT_EQ(scenario_of(numbers({{"separation_time", 1.5}}).overridden_by(numbers({{"until", 3}})))
                .parameters.separation_time,
            1.5);
}

TEST(Statement, OfTheEquationsAboveAnotherTakesBothCorrections) {
  Statement below, above;
  below.velocity_jump = VelocityJump::once;
  EXPECT_EQ(scenario_of(below).equations, (Equations{VelocityJump::once, GravityMoment::whole}));
  above.equations = Equations::published;
  EXPECT_EQ(scenario_of(below.overridden_by(above)).equations, Equations::published);
  EXPECT_EQ(scenario_of(above.overridden_by(below)).equations.velocity_jump, VelocityJump::once);
  above.equations = Equations::consistent;
  above.gravity_moment = GravityMoment::whole;
  EXPECT_EQ(name_of(scenario_of(above).equations), "mixed");
}

TEST(SeparationSpeed, IsThatAtTheMassLoss) {
  for (const double speed_Hz :
       {20., 75., 149.9995, 150.}) {  // where the motor is switched off, too
    const Scenario scenario = scenario_of(numbers({{"separation_speed_hz", speed_Hz}}));
    Observer null_observer;
    Simulation simulation(scenario);
    simulation.pass_mass_loss(null_observer);
    EXPECT_NEAR(simulation.instant().state[5] / (2 * std::numbers::pi) / speed_Hz, 1, 1e-12);
  }
  // That at which the motor is switched off is reached, whatever it is.
  for (int n = 0; n < 20; ++n) {
    const double speed_Hz = 20 + n * std::numbers::pi;
    EXPECT_EQ(refusal(numbers({{"separation_speed_hz", speed_Hz}, {"motor_off_hz", speed_Hz}})),
              "");
  }
  EXPECT_NE(refusal(numbers({{"separation_speed_hz", 151}}))
                .find("until 28.3087 s the rotor has 150 Hz at most"),
            std::string::npos);
  EXPECT_NE(refusal(numbers({{"separation_speed_hz", 75}, {"until", 3}})).find("is not reached"),
            std::string::npos);
  EXPECT_NE(refusal(numbers({{"separation_speed_hz", 75}, {"torque", 0}})).find("0 Hz at most"),
            std::string::npos);
  // What is faster behind a contact, this one at 1.77 s, does not count.
  const std::string touches =
      refusal(numbers({{"separation_speed_hz", 75}, {"eccentricity", 1e-3}}));
  // Another passes the resonance against the ring, without friction.
  EXPECT_NE(refusal(numbers({{"separation_speed_hz", 75}, {"eccentricity", 4e-4}, {"friction", 0}}))
                .find("when it touches the ring"),
            std::string::npos);
  EXPECT_NE(touches.find("until 1.77346 s, when it touches the ring, the rotor has 9.21934 Hz"),
            std::string::npos)
      << touches;
}

// It is asked in the run-up, and in the looks by which the time is located.
// There already at the beginning, whatever the motor does then.
TEST(SeparationSpeed, MayBeThatAtTheStart) {
  Statement stated;
  stated.numbers = {{"start_speed_hz", 60}, {"separation_speed_hz", 60}, {"torque", 0}};
  EXPECT_EQ(scenario_of(stated).parameters.separation_time, 0);
}

TEST(SeparationSpeed, IsSoughtAsLongAsTheMonitorLetsIt) {
  struct Monitor : Observer {
    bool goes_on(const Progress& now) override {
      has_looked_back = has_looked_back || now.time_s < latest_s;
      latest_s = std::max(latest_s, now.time_s);
      return ++asked != patience;
    }
    long patience = -1, asked = 0;
    double latest_s = 0;
    bool has_looked_back = false;
  };
  const auto found = [](Monitor& monitor) {
    return RunUps().time_at_speed({}, 75, std::nullopt, monitor).time_s;
  };
  Monitor patient;
  EXPECT_TRUE(found(patient));
  EXPECT_TRUE(patient.has_looked_back);
  for (const long patience : {1L, patient.asked / 2, patient.asked - 1}) {
    Monitor monitor;
    monitor.patience = patience;
    EXPECT_FALSE(found(monitor));
    EXPECT_EQ(monitor.asked, patience);
  }
}

// The response at a constant speed, which nothing but the damping's drag changes.
TEST(StartSpeed, BeginsInSteadyResponse) {
  Scenario scenario;
  scenario.parameters.torque = scenario.parameters.gravity = 0;
  scenario.parameters.separates = false;
  for (const double speed_Hz : {5., 30., 120.}) {
    scenario.start_speed_Hz = speed_Hz;
    scenario.until = 2;
    const Instant start = start_of(scenario);
    Observer null_observer;
    const RunEnd end = run(scenario, null_observer);
    // The drag slows the rotor by less than a thousandth in that time.
    EXPECT_NEAR(end.last.state[5] / start.state[5], 1, 1e-3) << speed_Hz;
    const double size = std::hypot(start.state[0], start.state[1]);
    EXPECT_NEAR(end.last.state[0], start.state[0], 1e-2 * size) << speed_Hz;
    EXPECT_NEAR(end.last.state[1], start.state[1], 1e-2 * size) << speed_Hz;
  }
  EXPECT_NE(refusal(numbers({{"start_speed_hz", 10.06}, {"support_damping", 0.1}})).find("touch"),
            std::string::npos);
}

TEST(StartSpeed, FindsTheMotorOffWhereItWouldBeSwitchedOff) {
  EXPECT_FALSE(start_of(scenario_of(numbers({{"start_speed_hz", 150}}))).motor_on);
  EXPECT_TRUE(start_of(scenario_of(numbers({{"start_speed_hz", 149}}))).motor_on);
}

// What the program says that it used, from nothing stated to everything. A figure keeps what its
// runs state themselves; a run is asked for by its options.
TEST_F(CommandLine, PutsEquationsAboveParametersAndInFiguresBelowARunsOwn) {
  write("fig21.toml",
        "[parameters]\nequations = \"published\"\nstart_speed_hz = 100\n[[run]]\nname = \"a\"\n"
        "[[run]]\nname = \"b\"\nvelocity_jump = \"once\"\n");
  const auto used = [&](const std::string& command) {
    const Outcome outcome = rotor(command);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return outcome.output;
  };
  for (const auto& [option, a, b, run_of_b] :
       {std::tuple("", "published", "mixed (velocity jump once, gravity moment whole)", "mixed"),
        {"--equations consistent", "consistent", "consistent", "consistent"},
        {"--gravity-moment balanced", "mixed (velocity jump twice, gravity moment balanced)",
         "consistent", "consistent"},
        {"--velocity-jump twice", "published", "mixed (velocity jump once, gravity moment whole)",
         "published"}}) {
    used(std::string("figure --scenes . --out . ") + option);
    EXPECT_NE(content("fig21.csv").find(std::string("# a: equations ") + a), std::string::npos);
    EXPECT_NE(content("fig21.csv").find(std::string("# b: equations ") + b), std::string::npos);
    const std::string summary = used(std::string("run --scene fig21.toml --run b ") + option);
    EXPECT_NE(summary.find(fmt::format("equations                \"{}\"", run_of_b)),
              std::string::npos)
        << summary;
  }
  write(
      "s.toml",
      "[parameters]\nstart_speed_hz = 100\nuntil = 0.01\n[[run]]\nname = \"a\"\nmethod = \"rk4\"");
  EXPECT_NE(used("run --scene s.toml --method event").find("method                   \"event\""),
            std::string::npos);
}

TEST_F(CommandLine, SaysWhichEquationsItUsedForARotorThatIsNotThePapers) {
  const std::string start = "run --start-speed-hz 100 --until 0.001 ";
  const std::string told = "equations published were used, as none were stated";
  EXPECT_NE(rotor(start + "--mass 6").output.find(told), std::string::npos);
  for (const char* option :
       {"--equations published", "--velocity-jump once", "--gravity-moment whole"})
    EXPECT_EQ(rotor(start + "--mass 6 " + option).output.find(told), std::string::npos) << option;
  EXPECT_EQ(rotor("run --until 0.001").output.find(told), std::string::npos);
  const std::string runs = "[parameters]\nuntil = 0.001\n[[run]]\nname = \"";
  for (const auto& [second, is_told] : {std::pair("mass = 6", true), {"friction = 0.3", false}}) {
    write("two.toml", runs + "a\"\n[[run]]\nname = \"b\"\n" + second);
    EXPECT_EQ(rotor("run --scene two.toml").output.find(told) != std::string::npos, is_told);
  }
}

}  // namespace
}  // namespace rotor
