/// Where `rotor run` stops.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "verification/support/run_summary.hpp"

namespace rotor {
namespace {

using Json = nlohmann::json;

using Stops = RunSummary;

TEST_F(Stops, AreAtTheFirstMaximumOfTheForceOnceItRolls) {
  const Json whole = summary(""), stopped = summary("--stop-on rolling");
  EXPECT_EQ(stopped["stop_reached"], true);
  EXPECT_LT(stopped["final_time_s"], 29.13);
  for (const char* key : {"outcome", "rolling_onset_s", "peak_normal_force_N", "collisions"})
    EXPECT_EQ(stopped[key], whole[key]) << key;
  EXPECT_LT(stopped["right_hand_sides"], whole["right_hand_sides"]);
  EXPECT_EQ(summary("--stop-on outcome")["final_time_s"], stopped["final_time_s"]);
}

// Here the force falls where rolling begins: its first maximum comes with the next contact.
TEST_F(Stops, AreNotWhereTheForceFallsAtTheOnset) {
  for (const std::string speed_Hz : {"120", "130"}) {
    const auto waits = [&](const std::string& method) {
      const Json stopped = summary(
          "--equations consistent --friction 0.1 --contact-damping 50 --until 0.3 "
          "--stop-on rolling --start-speed-hz " +
          speed_Hz + " --method " + method);
      return stopped["final_time_s"].get<double>() - stopped["rolling_onset_s"].get<double>();
    };
    EXPECT_GT(waits("event"), 3e-4) << speed_Hz;
    EXPECT_NEAR(waits("rk4"), waits("event"), 3e-5) << speed_Hz;  // steps of 5e-6 s
  }
}

// Rolling decides the outcome, but not before the mass loss.
TEST_F(Stops, AreNotBeforeTheMassLossWhereTheOutcomeIsAskedFor) {
  const std::string run =
      "--support-stiffness 1.2e5 --friction 2 --separation-time 6 --tolerance 1e-7 --stop-on ";
  const Json stopped = summary(run + "outcome");
  EXPECT_LT(stopped["rolling_onset_s"], 5);
  EXPECT_EQ(stopped["outcome"], "rolling");
  EXPECT_TRUE(stopped["mass_loss_reached"]);
  EXPECT_TRUE(stopped["stop_reached"]);
  EXPECT_FALSE(summary(run + "rolling")["mass_loss_reached"]);
}

TEST_F(Stops, AreAsSoonAsItIsClearThatThereIsNoContact) {
  const Json stopped = summary("--separation-time 12 --stop-on outcome --equations consistent");
  EXPECT_EQ(stopped["outcome"], "no_contact");
  EXPECT_EQ(stopped["stop_reached"], true);
  EXPECT_LT(stopped["final_time_s"], 12.1);
  // What damping may take of the speed until a late end decides nothing, either, with gravity or
  // without.
  for (const std::string gravity : {"9.81", "0"}) {
    const Json late = summary(
        "--start-speed-hz 150 --separation-time 0 --clearance 5e-3 --until 200 --stop-on outcome "
        "--equations consistent --gravity " +
        gravity);
    EXPECT_EQ(late["outcome"], "no_contact") << gravity;
    EXPECT_LT(late["final_time_s"], 0.1) << gravity;
  }
}

// Without an event there is nothing to judge: a run without a mass loss shows all that was asked
// for.
TEST_F(Stops, AreWhereSomethingHappens) {
  for (const std::string method : {"event", "rk4"}) {
    const Json stopped = summary(
        "--no-separation --start-speed-hz 30 --torque 0 --until 0.1 --stop-on outcome --method " +
        method);
    EXPECT_EQ(stopped["final_time_s"], 0.1) << method;
    EXPECT_EQ(stopped["stop_reached"], false) << method;
  }
}

TEST_F(Stops, StandAboveWhatIsWritten) {
  const std::string run = "run --until 1e-2 --start-speed-hz 150 --trace t.csv --events e.csv";
  ASSERT_EQ(rotor(run).status, 0);
  EXPECT_TRUE(content("t.csv").starts_with("# Trace of a run\n"));
  EXPECT_TRUE(content("e.csv").starts_with("# Events of a run\n"));
  ASSERT_EQ(rotor(run + " --stop-on rolling").status, 0);
  EXPECT_TRUE(content("t.csv").starts_with("# Trace of a run that stops on rolling\n"));
  EXPECT_TRUE(content("e.csv").starts_with("# Events of a run that stops on rolling\n"));
}

TEST_F(Stops, AreAtRest) {
  // So weak a motor that the speed stays below 0.1 Hz: a rotor at its start has not come to rest.
  for (const std::string method : {"event", "rk4"}) {
    const Json slow = summary(
        "--stop-on rest --torque 8e-4 --gravity 0 --separation-time 5 --until 60 --method " +
        method);
    EXPECT_TRUE(slow["mass_loss_reached"]);
    EXPECT_NEAR(slow["final_time_s"], 6, 0.5) << method;  // a second later, and the rest of a step
  }
  const std::string still = "--stop-on rest --until 60 --torque 0 --gravity 0 --no-separation ";
  const Json stopped = summary(still);
  EXPECT_EQ(stopped["stop_reached"], true);
  EXPECT_GE(stopped["final_time_s"], 1);
  EXPECT_LT(stopped["final_time_s"], 60);
  const auto turns_at = [&](const std::string& speed_Hz) {
    return summary(still + "--eccentricity 0 --start-speed-hz " + speed_Hz)["stop_reached"];
  };
  EXPECT_EQ(turns_at("0.09"), true);
  EXPECT_EQ(turns_at("0.11"), false);
  // Nor has one that its motor starts slowly.
  const Json starts =
      summary("--stop-on rest --torque 0.001 --gravity 0 --no-separation --until 8");
  EXPECT_EQ(starts["stop_reached"], false);
  EXPECT_GT(starts["final_speed_Hz"], 0.1);
  // Nor has a pendulum that swings back, for more than a second each time.
  const Json swings = summary(
      "--stop-on rest --no-separation --torque 0 --eccentricity 1.15e-3 --start-speed-hz 0.64 "
      "--until 10");
  EXPECT_FALSE(swings["stop_reached"]);
}

// Rolling on after the loss, it awaits a maximum of the force, which a smooth decay has not.
TEST_F(Stops, AreBehindALossInRollingThatChangesNothing) {
  const Json stopped = summary(
      "--equations consistent --clearance 1e-3 --friction 0.8 --unbalance-factor 1 "
      "--separation-time 2.4 --until 2.8 --stop-on outcome");
  EXPECT_EQ(stopped["outcome"], "rolling");
  EXPECT_GT(stopped["final_time_s"], 2.5);
}

// Before resonance it is not clear yet: the motor drives the rotor on, and into contact.
TEST_F(Stops, AreNotBeforeAResonanceThatIsStillToCome) {
  for (const std::string run :
       {"--separation-time 1 --until 5 ", "--separation-time 1.5 --until 5 --equations consistent ",
        // It coasts down through its resonance.
        "--mass 2.24760174 --inertia 0.0138229672 --eccentricity "
        "0.0158509437 --support-stiffness 977.876082 --support-damping "
        "11.2006793 --torque 0 --contact-stiffness 31535.4352 "
        "--contact-damping 71.6030764 --friction 0.0849230434 "
        "--rotor-radius 0.170408734 --stator-radius 0.194472672 "
        "--start-speed-hz 15.0538245 --separation-time 0.00219956671 "
        "--unbalance-factor 1.03157215 --until 12 "}) {
    const Json whole = summary(run), stopped = summary(run + "--stop-on outcome");
    EXPECT_GT(whole["collisions"], 0) << run;
    EXPECT_EQ(stopped["outcome"], whole["outcome"]) << run;
    EXPECT_EQ(stopped["first_contact_s"], whole["first_contact_s"]) << run;
  }
}

TEST_F(Stops, AreAtNoRestBeforeTheMassLoss) {
  const Json stopped =
      summary("--stop-on rest --torque 0 --gravity 0 --separation-time 5 --until 60");
  EXPECT_TRUE(stopped["mass_loss_reached"]);
  EXPECT_GE(stopped["final_time_s"], 6);  // a second later, and the rest of a step
}

}  // namespace
}  // namespace rotor
