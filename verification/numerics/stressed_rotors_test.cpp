/// Rotors from the stress test on which the integration once failed.
#include <gtest/gtest.h>

#include "figures/data/text.hpp"
#include "figures/input/names.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/read_csv.hpp"

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

}  // namespace
}  // namespace rotor
