/// Whole runs in other units: neither results nor early ends may depend on a hidden number with a
/// unit.
#include <gtest/gtest.h>

#include "figures/results/run_result.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/other_units.hpp"

namespace rotor {
namespace {

struct Case {
  const char* name;
  Outcome outcome;
  void (*change)(Scenario&);
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Units : public testing::TestWithParam<Case> {
 protected:
  static RunResult result(const Scenario& scenario, std::optional<StopOn> stop_on) {
    return complete_run(RunUpCheckpoint(scenario), scenario, stop_on, nobody);
  }
};

TEST_P(Units, ChangeNothingThatIsSaidOfARun) {
  Scenario scenario{.equations = Equations::published, .start_speed_Hz = 149.5, .until = 0.1};
  scenario.parameters.mass_loss_time = 1e-3;
  GetParam().change(scenario);
  for (const std::optional<StopOn> stop_on :
       {std::optional<StopOn>(), std::optional(StopOn::outcome), std::optional(StopOn::rolling)}) {
    const RunResult here = result(scenario, stop_on),
                    there = result(in_other_units(scenario), stop_on);
    if (!stop_on) {
      EXPECT_EQ(here.summary.outcome, GetParam().outcome);
    }
    EXPECT_EQ(there.summary.outcome, here.summary.outcome);
    EXPECT_EQ(there.summary.touch_downs, here.summary.touch_downs);
    EXPECT_EQ(there.early.stop_reached, here.early.stop_reached);
    EXPECT_EQ(there.end.last.time_s, here.end.last.time_s * second);
    EXPECT_EQ(there.end.last.state, in_other_units(here.end.last.state));
    EXPECT_EQ(there.end.counters.right_hand_sides, here.end.counters.right_hand_sides);
    EXPECT_EQ(there.summary.contact_time_s, here.summary.contact_time_s * second);
    EXPECT_EQ(there.summary.whirl_frequency_Hz.value_or(0),
              here.summary.whirl_frequency_Hz.value_or(0) / second);
    EXPECT_EQ(there.summary.peak_normal_force_N.value_or(0),
              here.summary.peak_normal_force_N.value_or(0) * newton);
    EXPECT_EQ(there.summary.peak_bearing_force_N, here.summary.peak_bearing_force_N * newton);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, Units,
    testing::Values(Case{"rolling", Outcome::rolling, [](Scenario&) {}},
                    Case{"bouncing", Outcome::bouncing, [](Scenario& s) { s.until = 0.01; }},
                    Case{"sliding", Outcome::sliding,
                         [](Scenario& s) {
                           s.parameters.friction = 0.08;
                           s.until = 0.25;
                         }},
                    Case{"freed", Outcome::freed,
                         [](Scenario& s) {
                           s.parameters.friction = 0.08;
                           s.parameters.contact_damping = 1.2e4;
                         }},
                    Case{"undecided", Outcome::undecided, [](Scenario& s) { s.until = 1.5e-3; }},
                    Case{"stalled", Outcome::stalled,
                         [](Scenario& s) {
                           s.start_speed_Hz = 0;
                           s.parameters.mass_loss_time = 1;
                           s.until = 12;
                           s.tolerance = 1e-6;
                         }},
                    // Slower than the critical speed, but it becomes faster: no stall.
                    Case{"rising", Outcome::no_contact,
                         [](Scenario& s) {
                           s.start_speed_Hz = 0;
                           s.parameters.loses_mass = false;
                           s.until = 1.5;
                         }}),
    [](const auto& c) { return c.param.name; });

}  // namespace
}  // namespace rotor
