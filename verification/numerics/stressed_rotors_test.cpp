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
  // A graze that ends when it begins, up to the rounding of its time.
  summary(
      "--clearance 1.6361831701066095e-06 --contact-damping 0 --contact-exponent "
      "1.236302975329823 --contact-stiffness 5217929499.386724 --eccentricity "
      "1.527200136908562e-05 --friction 3.087834687512278 --gravity 11.530988069884291 --inertia "
      "0.00035225853548281595 --lost-mass 0.0021749921393443223 --mass 0.12737302842005688 "
      "--mass-loss-time 0.025151336825928208 --motor-off-rpm 525.8433121147247 "
      "--reference-indentation 2.894737378006406e-07 --rotor-radius 0.040953012777736685 "
      "--start-speed-Hz 21.6424696618851 --support-damping 28.210282010619867 "
      "--support-stiffness 1948339.3646104007 --torque 0 --until 0.03 --tolerance 1e-11");
}

// The first maximum after the onset of rolling lies at a second onset, where the force falls after
// it has risen since the touch-down.
TEST_F(RightRuns, HaveTheFirstMaximumOfTheForceInRollingAtAnEventToo) {
  const Json run = summary(
      "--clearance 1.012361371563971 --contact-damping 264104.59670696314 --contact-stiffness "
      "727591143.1846606 --eccentricity 0.0009432231206045866 --friction 3.2703794788882106 "
      "--gravity 49.692765901023705 --inertia 0.0005356053224768683 --mass 2.884046466961603 "
      "--mass-loss-time 0 --motor-off-rpm 1543.0655267463771 --rotor-radius "
      "0.010106478785806929 --start-speed-rpm 4693.242523973368 --support-damping "
      "0.6535868487030794 --support-stiffness 0 --torque 0 --unbalance-factor "
      "8.072490713502894 --until 0.18 --equations published");
  EXPECT_NEAR(run["peak_force_to_rolling_N"].get<double>(), 21823714, 1);
  EXPECT_GT(run["peak_normal_force_N"].get<double>(), 21850000);
}

// The force falls throughout the first rolling. Where that contact ends, rounding has a maximum of
// 1e-12 N; the first real one is in the next contact.
TEST_F(RightRuns, HaveNoMaximumOfTheForceInRollingByRounding) {
  const Json run = summary(
      "--clearance 1.0530056482274164 --contact-damping 0 --contact-exponent 1.475626888466668 "
      "--contact-stiffness 4462016603.042738 --eccentricity 0.007744228564021443 --friction "
      "8.295211388308104 --gravity 2.4475029115560356 --inertia 0.186170251947499 --mass "
      "3.07996438699306 --mass-loss-time 0 --motor-off-rpm 129950.65960049351 "
      "--reference-indentation 0.0067209938743795685 --rotor-radius 0.1866973317053686 "
      "--start-speed-rpm 43871.98386040039 --support-damping 0.6262587710261044 "
      "--support-stiffness 356625.84952013596 --torque 0.02362705704347129 --unbalance-factor "
      "6.314323129692298 --until 0.0145 --equations published");
  EXPECT_NEAR(run["peak_force_to_rolling_N"].get<double>(), 41844931, 1);
}

}  // namespace
}  // namespace rotor
