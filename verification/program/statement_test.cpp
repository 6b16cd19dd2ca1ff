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

TEST(Statement, TakesTheLostMassForTheUnbalanceFactor) {
  const double lost = 0.04;
  const Scenario scenario = scenario_of(numbers({{"lost_mass", lost}}));
  EXPECT_NEAR(MassLoss<double>(scenario.parameters).lost_mass, lost, 1e-15);
  for (const double too_much : {5., 6.})
    EXPECT_NE(refusal(numbers({{"lost_mass", too_much}})).find("must be less than mass = 5 kg"),
              std::string::npos);
  EXPECT_NE(refusal(numbers({{"lost_mass", 0.01}, {"eccentricity", 0}})), "");
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

}  // namespace
}  // namespace rotor
