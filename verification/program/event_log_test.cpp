/// What `--events` writes of each event, against formulas of its instant.
#include "figures/results/event_log.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "figures/input/names.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer_group.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

TEST(EventLog, HasEachEventWithTheForceOnTheRotorAndItsSlip) {
  const Scenario scenario = short_run(0.03);
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  EventLog log(scenario, [&](std::string_view event, auto row) {
    names.emplace_back(event);
    rows.emplace_back(row.begin(), row.end());
  });
  EventRecorder events;
  ObserverGroup both;
  both.add(log);
  both.add(events);
  run(scenario, both);
  ASSERT_EQ(rows.size(), events.events().size());
  int pressed = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const Instant& at = events.events()[n];
    EXPECT_EQ(names[n], name_of(at.event));
    for (std::size_t i = 0; i < EventLog::columns().size(); ++i) {
      const std::string_view column = EventLog::columns()[i]->name;
      const double expected = column_by_formula(column, at, scenario);
      EXPECT_NEAR(rows[n][i], expected, 1e-9 * std::abs(expected)) << column << ' ' << names[n];
      pressed += column == "normal_force_N" && expected < -1 ? 1 : 0;
    }
  }
  EXPECT_GT(pressed, 3);
}

}  // namespace
}  // namespace rotor
