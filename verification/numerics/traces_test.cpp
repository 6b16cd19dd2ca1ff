/// What recorders and summaries make of the runs of random rotors.
#include <gtest/gtest.h>

#include "figures/scenes/audience.hpp"
#include "figures/scenes/recorder.hpp"
#include "model/simulation/summary.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/random_scenarios.hpp"
#include "verification/support/starts.hpp"

namespace rotor {
namespace {

TEST(Traces, NeverRunBackwardsAndSummariesReachAtLeastWhereTheRunEnds) {
  RandomScenarios random(2);
  long maxima = 0;
  for (int n = 0; n < 700; ++n) {
    Scenario scenario = random.scenario();
    scenario.tolerance = std::pow(10, -3 - n % 4);
    const Instant first = separated_at_speed(scenario, random.speed());
    double last_s = 0;
    Recorder recorder({},
                      {find_column("time_s"), find_column("rho_m"), find_column("normal_force_N")},
                      scenario, sampling, [&](std::span<const double> row) {
                        ASSERT_GE(row[0], last_s) << "rotor " << n;
                        last_s = row[0];
                      });
    struct : EventRecorder {
      void on_instant(const Instant& at) override {
        ASSERT_GE(at.time_s, last().time_s);
        EventRecorder::on_instant(at);
      }
    } events;
    SummaryObserver summary(scenario);
    struct : Observer {
      double threshold(Extreme, const double&, const double&) const override { return 0; }
      void on_maximum(const Maximum& maximum) override {
        ++count;
        const double time_s = maximum.at.time_s;
        largest_gap_s = std::max(largest_gap_s, last_s - time_s);
        last_s = time_s;
      }
      long count = 0;
      double last_s = 0, largest_gap_s = 0;
    } all_maxima;
    Audience audience;
    for (Observer* observer :
         {static_cast<Observer*>(&recorder), static_cast<Observer*>(&events),
          static_cast<Observer*>(&summary), static_cast<Observer*>(&all_maxima)})
      audience.add(*observer);
    const Instant last = follow(scenario, first, 0.01, audience).last;
    EXPECT_GE(*summary.summary().max_displacement_m, last.motion().displacement.norm());
    EXPECT_LE(all_maxima.largest_gap_s, 0) << "rotor " << n;
    maxima += all_maxima.count;
  }
  EXPECT_GT(maxima, 1000);  // that were located
}

}  // namespace
}  // namespace rotor
