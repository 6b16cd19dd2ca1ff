/// What recorders and summaries make of the runs of random rotors, and which maxima they are shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

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

/// Whether what is shown of each phase, its ends and its maxima, is as large as what dense output
/// has of it in between.
class PhaseMaxima : public Observer {
 public:
  PhaseMaxima(const Supports<double>& supports, Extreme of) : supports_(supports), of_(of) {}

  void on_instant(const Instant& at) override {
    shown_ = std::max(shown_, value(at));
    if (at.event == Event::none) return;
    end_phase();
    contact_ = at.contact;
    shown_ = value(at);
  }
  double threshold(Extreme of, const double&, const double&) const override {
    return of == of_ ? 0 : Observer::threshold(of, 0, 0);
  }
  void on_maximum(const Maximum& maximum) override {
    shown_ = std::max(shown_, value(maximum.at));
    ++maxima[maximum.at.contact];
  }
  bool wants_dense_output(const double&, const double&) const override { return true; }
  void on_step(const DenseOutput& motion) override {
    constexpr int looks = 40;
    for (int i = 0; i <= looks; ++i)
      seen_ = std::max(
          seen_, value(motion.at(motion.from_s + (motion.until_s - motion.from_s) * i / looks)));
  }

  std::map<ContactState, long> maxima;
  std::map<ContactState, double> largest_miss;  ///< relative

 private:
  void end_phase() {
    double& miss = largest_miss[contact_];
    if (shown_ > 0) miss = std::max(miss, seen_ / shown_ - 1);
    seen_ = 0;
  }
  double value(const Instant& at) const {
    const Motion<double> m = at.motion();
    return of_ == Extreme::displacement
               ? m.displacement.norm()
               : supports_.bearing_force(m.displacement, m.velocity).norm();
  }

  Supports<double> supports_;
  Extreme of_;
  ContactState contact_ = ContactState::free;
  double shown_ = 0, seen_ = 0;
};

TEST(Maxima, OfEachPhaseAreShown) {
  RandomScenarios random(5);
  std::map<ContactState, long> maxima;
  for (int n = 0; n < 300; ++n) {
    Scenario scenario = random.scenario();
    scenario.tolerance = 1e-10;
    const Instant first = separated_at_speed(scenario, random.speed());
    for (const Extreme of : {Extreme::displacement, Extreme::bearing_force}) {
      PhaseMaxima watch(Supports<double>(scenario.parameters, scenario.equations), of);
      follow(scenario, first, 0.01, watch);
      for (const auto& [contact, miss] : watch.largest_miss)
        EXPECT_LT(miss, 1e-7) << n << ' ' << static_cast<int>(of) << ' '
                              << static_cast<int>(contact);
      for (const auto& [contact, count] : watch.maxima) maxima[contact] += count;
    }
  }
  EXPECT_GT(maxima[ContactState::free], 300);
  EXPECT_GT(maxima[ContactState::sliding], 3000);
  EXPECT_GT(maxima[ContactState::rolling], 1000);
  EXPECT_GT(maxima[ContactState::indented], 1);
}

}  // namespace
}  // namespace rotor
