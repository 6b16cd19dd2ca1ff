/// The inputs of a run, its start, its mass loss and its end.
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "figures/data/read_csv.hpp"
#include "figures/data/text.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/program/progress.hpp"
#include "figures/results/run_result.hpp"
#include "figures/runs/run_ups.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/contradiction.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/random_inputs.hpp"

namespace rotor {
namespace {

using Runs = CommandLine;
using Stops = CommandLine;

ScenarioSpec numbers(std::initializer_list<std::pair<const std::string, double>> stated) {
  ScenarioSpec spec;
  spec.numbers.insert(stated.begin(), stated.end());
  return spec;
}

TEST(RandomInputs, HaveBothSignsWhereBothAreAllowed) {
  RandomInputs random(1);
  std::map<std::string, std::set<bool>> signs;
  for (int n = 0; n < 1000; ++n)
    for (const auto& [name, value] : random.rotor().stated.numbers)
      signs[name].insert(std::signbit(value));
  for (const InputQuantity& input : input_quantities())
    if (input.quantity.allows(-1)) {
      EXPECT_EQ(signs[std::string(input.quantity.name)].size(), 2U) << input.quantity.name;
    }
}

TEST(ScenarioSpec, ReadsNumbersThatAreNothingElse) {
  EXPECT_EQ(number_in("0.3"), 0.3);
  EXPECT_EQ(number_in("+3e-1"), 0.3);
  EXPECT_EQ(number_in("3E-1"), 0.3);
  EXPECT_EQ(number_in("-.5"), -0.5);
  EXPECT_EQ(number_in("1e-310"), 1e-310);
  EXPECT_EQ(number_in("0"), 0);  // whatever there was before
  for (const char* text :
       {"", " 1", "1 ", "1,5", "0x10", "nan", "inf", "1e", "--1", "1e-999", "1e999", "1f"})
    EXPECT_EQ(number_in(text), std::nullopt) << text;
}

TEST(ScenarioSpec, TakesTheLostMassForTheUnbalanceFactor) {
  const Scenario scenario = scenario_of(numbers({{"lost_mass", 0.04}}));
  EXPECT_NEAR(MassLoss<double>(scenario.parameters).lost_mass, 0.04, 1e-15);
  EXPECT_THROW(scenario_of(numbers({{"lost_mass", -0.01}})), ScenarioError);  // as a draw may be
  // m e/m/e may be less than 1 by rounding.
  EXPECT_EQ(scenario_of(numbers({{"lost_mass", 0}, {"mass", 5.6}, {"eccentricity", 4e-4}}))
                .parameters.unbalance_factor,
            1);
}

// As they were stated; their values are no inputs.
TEST(ScenarioSpec, OfAContradictionIsRefusedWithTheInputsToBlame) {
  ScenarioSpec held = numbers({{"start_speed_rpm", 0}});
  held.drive = Drive::constant_speed;
  try {
    scenario_of(held);
    FAIL() << "a drive at rest";
  } catch (const ScenarioError& error) {
    EXPECT_EQ(error.message().inputs(), (std::vector<std::string>{"drive", "start_speed_rpm"}));
  }
}

TEST(ScenarioSpec, OfAMassLossAboveAnotherTakesWhenAndWhetherItIs) {
  ScenarioSpec none = numbers({{"until", 3}});
  none.loses_mass = false;
  for (const char* name : {"mass_loss_time", "mass_loss_speed_Hz"}) {
    const ScenarioSpec at = numbers({{name, 1.5}, {"torque", 3}});
    EXPECT_FALSE(scenario_of(at.overridden_by(none)).loses_mass()) << name;
    EXPECT_TRUE(scenario_of(none.overridden_by(at)).loses_mass()) << name;
  }
  ScenarioSpec confirmed;
  confirmed.loses_mass = true;  // and says nothing of when
  EXPECT_EQ(scenario_of(numbers({{"mass_loss_time", 1.5}}).overridden_by(confirmed))
                .parameters.mass_loss_time,
            1.5);
}

// Also the speed at which the motor is switched off, whatever it is.
TEST(SeparationSpeed, IsThatAtTheMassLoss) {
  for (const double off_Hz : {150., 20 + std::numbers::pi})
    for (const double speed_Hz : {20., 75., 149.9995, off_Hz}) {
      Scenario scenario = scenario_of(numbers(
          {{"mass_loss_speed_Hz", speed_Hz}, {"motor_off_Hz", std::max(off_Hz, speed_Hz)}}));
      scenario.until = scenario.parameters.mass_loss_time;
      SummaryObserver observer(scenario);
      run(scenario, observer);
      EXPECT_NEAR(*observer.summary().speed_at_mass_loss_Hz / speed_Hz, 1, 1e-12);
    }
  const auto at_start =
      numbers({{"start_speed_Hz", 60}, {"mass_loss_speed_Hz", 60}, {"torque", 0}});
  EXPECT_EQ(scenario_of(at_start).parameters.mass_loss_time, 0);
  // A higher speed after a contact, here at 1.77 s, does not count.
  EXPECT_THROW(scenario_of(numbers({{"mass_loss_speed_Hz", 75}, {"eccentricity", 1e-3}})),
               std::exception);
}

// Wherever it moves from there: off a damped ring the rim may come free at once.
TEST(SeparationSpeed, IsNotReachedAfterAStartOverTheRing) {
  for (const double velocity : {-3., -0.01, 0., 3.})
    for (const double damping : {0., 1e4}) {
      SCOPED_TRACE(fmt::format("{} m/s, {} N s/m", velocity, damping));
      Scenario scenario{.start_speed_Hz = 30, .start = Start{3.000001e-3, 0, velocity, 0}};
      scenario.parameters.contact_damping = damping;
      RunUps run_ups;
      for (const double speed_Hz : {30., 30.5, 40.}) {  // the later ones where the others ended
        const SpeedReached found = run_ups.time_at_speed(scenario, speed_Hz, {}, nobody);
        EXPECT_FALSE(found.time_s) << speed_Hz;
        EXPECT_TRUE(found.touches) << speed_Hz;
        EXPECT_EQ(found.looked_until_s, 0) << speed_Hz;
      }
    }
}

// The runs of a scene are the same as single runs, even if one fails.
TEST_F(Runs, OfASceneAreThoseOfTheirOwn) {
  write("two.toml",
        "[parameters]\nequations = \"published\"\nstart_speed_Hz = 150\nuntil = 0.03\n"
        "mass_loss_time = 1e-3\n[[run]]\n"
        "name = \"a\"\n[[run]]\nname = \"diverges\"\nmethod = \"rk4\"\n"
        "contact_stiffness = 1e13\n[[run]]\nname = \"b\"\nfriction = 0.2\n");
  const Outcome all = rotor("run two.toml --json 2>messages");
  EXPECT_EQ(all.status, 1);
  EXPECT_TRUE(has(content("messages"), "rotor: diverges: the rk4 run diverged"));
  const Json runs = Json::parse(all.output)["runs"];
  ASSERT_EQ(runs.size(), 2U);
  for (Json run : runs) {
    const std::string name = run["run"];
    run.erase("run");
    EXPECT_EQ(run, summary("two.toml --run " + name));
  }
  EXPECT_NE(runs[0]["touch_downs"], runs[1]["touch_downs"]);
  EXPECT_TRUE(has(rotor("run two.toml --all").output, "\nfinal_q1_m"));
  // An option changes the name that is printed, not the one that is selected.
  ASSERT_EQ(rotor("run two.toml --run b --friction 0.1 --trace t.csv").status, 0);
  EXPECT_EQ(read_csv(folder_ / "t.csv").front()["run"], "b, but friction = 0.1");
}

TEST_F(Stops, AreAtTheFirstMaximumOfTheForceOnceItRolls) {
  const std::string printed = "--equations published ";
  const Json whole = summary(printed), stopped = summary(printed + "--stop-on rolling");
  EXPECT_EQ(stopped["stop_reached"], true);
  EXPECT_LT(stopped["final_time_s"], 29.13);
  EXPECT_LT(stopped["right_hand_sides"], whole["right_hand_sides"]);
  EXPECT_EQ(summary(printed + "--stop-on outcome")["final_time_s"], stopped["final_time_s"]);
  const Scenario by_steps{.parameters = {.mass_loss_time = 0},
                          .method = Method::rk4,
                          .start_speed_Hz = 150,
                          .until = 0.1};
  const Summary last =
      complete_run(RunUpCheckpoint(by_steps), by_steps, StopOn::rolling, nobody).summary;
  EXPECT_NEAR(last.final_time_s - last.peak_time_s.value(), by_steps.step_rub, 1e-9);
}

/// Nothing that a stopped run reports differs from the whole run, other than where it ends.
RunResult result(const Scenario& scenario, std::optional<StopOn> stop_on) {
  return complete_run(RunUpCheckpoint(scenario), scenario, stop_on, nobody);
}

// At half its critical speed gravity's moment, whole or balanced, shakes a rotor until it touches;
// a motor is too weak to bring another one through it; a third drives the rolling rotor to larger
// forces, also by fixed steps.
TEST(StopsAtTheOutcome, LeaveOutWhatTheRestOfTheRunDecides) {
  const auto rolls_faster =
      numbers({{"torque", 100}, {"motor_off_Hz", 1000}, {"start_speed_Hz", 120}, {"until", 0.5}});
  for (auto [stated, equations, method, outcome] :
       {std::tuple(numbers({{"support_damping", 1},
                            {"clearance", 5.2e-4},
                            {"inertia", 1e-3},
                            {"eccentricity", 1.9e-4},
                            {"support_stiffness", 1.11e4},
                            {"unbalance_factor", 2},
                            {"torque", 0},
                            {"start_speed_Hz", 4},
                            {"until", 20}}),
                   Equations::published, Method::event, Outcome::freed),
        {numbers({{"support_damping", 0.05},
                  {"clearance", 1.6e-3},
                  {"inertia", 1.4e-3},
                  {"eccentricity", 8e-4},
                  {"unbalance_factor", 1.5},
                  {"torque", 0},
                  {"start_speed_Hz", 5.3},
                  {"until", 3}}),
         Equations::corrected, Method::event, Outcome::bouncing},
        {numbers({{"torque", 1e-3}, {"start_speed_Hz", 5}, {"until", 30}}), Equations::corrected,
         Method::event, Outcome::stalled},
        {rolls_faster, Equations::corrected, Method::event, Outcome::rolling},
        {rolls_faster, Equations::published, Method::rk4, Outcome::rolling}}) {
    stated.equations = equations;
    stated.method = method;
    const Scenario scenario = scenario_of(stated);
    const RunResult whole = result(scenario, {}), stopped = result(scenario, StopOn::outcome);
    EXPECT_EQ(whole.summary.outcome, outcome);
    EXPECT_EQ(contradiction(stopped, whole), "");
  }
}

// Clear of the ring a rotor is decided as soon as its vibration has decayed enough, with no event
// there: one that just misses the ring, and one that leaves it.
TEST(StopsAtTheOutcome, MayBeInFlight) {
  for (const auto& [clearance, outcome] :
       {std::pair(3.4e-3, Outcome::no_contact), {3e-3, Outcome::freed}}) {
    Scenario scenario{.equations = Equations::corrected, .start_speed_Hz = 100, .until = 1};
    Parameters& p = scenario.parameters;
    p.mass_loss_time = p.torque = 0;
    p.friction = 0.15;
    p.stator_radius = p.rotor_radius + clearance;
    const RunResult whole = result(scenario, {}), stopped = result(scenario, StopOn::outcome);
    EXPECT_EQ(stopped.summary.outcome, outcome);
    EXPECT_EQ(contradiction(stopped, whole), "");
    EXPECT_LT(4 * stopped.end.counters.right_hand_sides, whole.end.counters.right_hand_sides);
  }
}

// Rolling decides the outcome, but not before the mass loss.
TEST_F(Stops, AreNotBeforeTheMassLossWhereTheOutcomeIsAskedFor) {
  const std::string run =
      "--support-stiffness 1.2e5 --friction 2 --mass-loss-time 6 --tolerance 1e-7 --stop-on ";
  const Json stopped = summary(run + "outcome");
  EXPECT_LT(stopped["rolling_onset_s"], 5);
  EXPECT_EQ(stopped["outcome"], "rolling");
  EXPECT_TRUE(stopped["mass_loss_reached"]);
  EXPECT_TRUE(stopped["stop_reached"]);
  EXPECT_TRUE(summary(run + "rolling")["mass_loss_reached"].is_null());
}

// Slower than 0.1 Hz for a second. A rotor that its motor has yet to start is not at rest, nor is a
// pendulum that swings back, for more than a second each time.
TEST_F(Stops, AreAtRest) {
  const std::string still = " --gravity 0 --torque 0 --no-mass-loss --until 8";
  for (const auto& [run, rests] :
       {std::pair(" --gravity 0 --torque 8e-4 --mass-loss-time 5 --until 8", true),
        {" --gravity 0 --torque 8e-4 --mass-loss-time 5 --until 8 --method rk4", true},
        {" --gravity 0 --torque 0.001 --no-mass-loss --until 8", false},
        {" --torque 0 --no-mass-loss --eccentricity 1.15e-3 --start-speed-Hz 0.64 --until 8",
         false}})
    EXPECT_EQ(summary(std::string("--stop-on rest") + run)["stop_reached"], rests) << run;
  for (const auto& [speed_Hz, rests] : {std::pair("0", true), {"0.09", true}, {"0.11", false}})
    EXPECT_EQ(summary(std::string("--stop-on rest --eccentricity 0 --start-speed-Hz ") + speed_Hz +
                      still)["stop_reached"],
              rests)
        << speed_Hz;
}

// If the rotor keeps rolling after the loss, the run waits for a maximum of the force, which a
// smooth decay does not have.
TEST_F(Stops, AreBehindALossInRollingThatChangesNothing) {
  const Json stopped = summary(
      "--equations corrected --clearance 1e-3 --friction 0.8 --unbalance-factor 1 "
      "--mass-loss-time 2.4 --until 2.8 --stop-on outcome");
  EXPECT_EQ(stopped["outcome"], "rolling");
  EXPECT_GT(stopped["final_time_s"], 2.5);
}

// Below resonance it is not decided yet: the motor drives the rotor through it, and into contact.
TEST_F(Stops, AreNotBeforeAResonanceThatIsStillToCome) {
  for (const std::string run :
       {"--mass-loss-time 1 --until 5 ", "--mass-loss-time 1.5 --until 5 --equations corrected ",
        // It coasts down through its resonance.
        "--mass 2.24760174 --inertia 0.0138229672 --eccentricity "
        "0.0158509437 --support-stiffness 977.876082 --support-damping "
        "11.2006793 --torque 0 --contact-stiffness 31535.4352 "
        "--contact-damping 71.6030764 --friction 0.0849230434 "
        "--rotor-radius 0.170408734 --stator-radius 0.194472672 "
        "--start-speed-Hz 15.0538245 --mass-loss-time 0.00219956671 "
        "--unbalance-factor 1.03157215 --until 12 ",
        // In steady motion 60 nm from the ring, until its motor changes the speed.
        "--clearance 0.00013560025164 --contact-damping 108 --contact-stiffness 667919819 "
        "--eccentricity 0.00013223398165557 --friction 1.28 --gravity 0 --inertia 0.049917782782 "
        "--mass 16.43673084432687 --motor-off-rpm 1724.5873413573881 --rotor-radius 0.16308656567 "
        "--start-speed-rpm 1724.4148998674013 --support-damping 10.90143554690996 "
        "--support-stiffness 13306.901291593784 --torque 0.0510535711584 --until 0.4239246 "
        "--no-mass-loss --equations corrected "}) {
    const Json whole = summary(run), stopped = summary(run + "--stop-on outcome");
    EXPECT_GT(whole["touch_downs"], 0) << run;
    EXPECT_EQ(stopped["outcome"], whole["outcome"]) << run;
    EXPECT_EQ(stopped["first_contact_s"], whole["first_contact_s"]) << run;
  }
}

// Those of the rub are shorter than those of the run-up.
TEST(RunProgress, CountsTheStepsThatAreLeft) {
  constexpr double until_s = 29.4, loss_s = 29.1, in_rub_s = 1e-6;
  RunProgress progress(until_s);
  for (int n = 0; n < 1000; ++n) progress.should_continue({loss_s * n / 1000, 0, 0});
  for (int n = 0; n < 2000; ++n) progress.should_continue({loss_s + n * in_rub_s, 0, 0});
  EXPECT_NEAR(progress.steps_left(), (until_s - loss_s) / in_rub_s, 3000);
}

}  // namespace
}  // namespace rotor
