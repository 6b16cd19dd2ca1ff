/// Rotors from the stress test on which the integration once failed.
#include <gtest/gtest.h>

#include "figures/data/read_csv.hpp"
#include "figures/data/text.hpp"
#include "figures/input/names.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/follow.hpp"

namespace rotor {
namespace {

TEST(StressedRotors, AreFollowedToTheEndAndKeepTheBalanceOfTheirEnergy) {
  const std::string table = ROTOR_SOURCES "/verification/numerics/stressed_rotors.csv";
  for (const CsvRow& row : read_csv(table)) {
    SCOPED_TRACE(row["what"]);
    const auto number = [&](const char* column) { return std::stod(row[column]); };
    Scenario scenario{.equations = parse_name<Equations>(row["equations"]), .tolerance = 1e-9};
    for (const Quantity& quantity : quantities()) {
      if (quantity.name == "mass_loss_time") break;  // which is past, as all that follows
      const std::string name(quantity.name);         // others are the paper's
      if (contains(row.headings(), name)) quantity.in(scenario) = std::stod(row[name]);
    }
    const BalancedRun run(scenario, mass_lost_at_speed(scenario, number("speed")), 0.01);
    EXPECT_EQ(run.last().time_s, 0.01);
    EXPECT_LT(run.energy_residual(), number("energy"));  // what the tolerance leaves, by contacts
    if (!row["most_right_hand_sides"].empty()) {
      EXPECT_LT(run.counters().right_hand_sides, number("most_right_hand_sides"));
    }
    EXPECT_GE(run.count(Event::touch_down), number("least_touch_downs"));
  }
}

using RightRuns = CommandLine;

TEST_F(RightRuns, AreNotRefused) {
  // A stiff ring's force makes energy of errors of length.
  summary(
      "--clearance 0.00084 --contact-damping 0 --friction 0.67 --start-velocity-x 0.025 "
      "--start-velocity-y 0.025 --support-damping 0 --support-stiffness 4.3e+03 --tolerance "
      "2.8e-11 --torque 0.17 --gravity-moment balanced --until 0.05");
  // A graze indents the ring by less than rounding in a step that is as short as its start asks.
  summary(
      "--clearance 0.001318606 --contact-damping 0 --contact-exponent 2.5 --contact-stiffness "
      "2e+11 --eccentricity 1.52674602661979e-05 --gravity 1.41 --inertia 0.00966 --lost-mass "
      "0.0351380648 --mass 3.844426 --motor-off-Hz 22 --reference-indentation 2.4e-06 "
      "--rotor-radius 0.07494440624994043 --start-speed-rpm 2893.787 --support-damping 978.2138 "
      "--support-stiffness 5106.73077017 --tolerance 1.1e-12 --until 0.03");
  // The lost mass is so large that C is 18 mm from O, and rounding of its place hides at what rate
  // the gap of 0.7 um closes.
  summary(
      "--clearance 7.485e-07 --contact-damping 0 --contact-stiffness 2354000000 --eccentricity "
      "5.648e-07 --friction 0.1353 --gravity 0.2949 --inertia 0.00126 --lost-mass 0.2541 --mass "
      "1.814 --mass-loss-time 0.2816 --rotor-radius 0.1107 --start-speed-Hz 2.014 --start-x "
      "9.773e-08 --support-damping 23.29 --support-stiffness 1239 --until 1.085 --equations "
      "corrected --drive constant_speed --tolerance 1e-12");
  // A graze by 5e-14 m, of a path that is known to 5e-12 m: a touch-down is found after it.
  summary(
      "--clearance 0.026236367219739744 --contact-damping 343.5589930588908 --contact-stiffness "
      "160467183.77497175 --eccentricity 0.00020395356608477394 --friction 0 --gravity "
      "8.579954552840524 --inertia 0.20175624913693924 --lost-mass 0.7714725890084205 --mass "
      "53.54506134754422 --mass-loss-speed-Hz 244.50651752302363 --motor-off-rpm "
      "14671.858090486556 --rotor-radius 0.10329965341992958 --start-speed-Hz "
      "244.50651752302363 --support-damping 738.0011088251712 --support-stiffness "
      "365930.9084471136 --torque 0 --velocity-jump once --until 0.03 --tolerance 1e-6");
}

}  // namespace
}  // namespace rotor
