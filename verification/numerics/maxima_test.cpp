/// What is gathered along a run is that of the motion which its steps describe, at every tolerance
/// that is accepted and however long the steps are: located maxima, rows of traces, their order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "figures/record/recorder.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer_group.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/random_scenarios.hpp"
#include "verification/support/starts.hpp"

namespace rotor {
namespace {

/// Several observers as one.
ObserverGroup observers_of(std::initializer_list<Observer*> observers) {
  ObserverGroup all;
  for (Observer* observer : observers) all.add(*observer);
  return all;
}

/// The largest values of the very motion that a run shows, sampled densely.
class DenseMaxima : public Observer {
 public:
  DenseMaxima(const Scenario& scenario, double late_s)
      : ring_(scenario.parameters),
        supports_(scenario.parameters, scenario.equations),
        late_s_(late_s) {}
  void on_instant(const Instant& at) override { note(at); }
  bool wants_dense_output(const double&, const double&) const override { return true; }
  void on_step(const DenseOutput& step) override {
    const long samples = 40 * step.arcs;  // a parabola over a radian is missed by 1e-4 at most
    for (long n = 0; n <= samples; ++n)
      note(step.at(step.from_s + (step.until_s - step.from_s) * static_cast<double>(n) /
                                     static_cast<double>(samples)));
    longest_arcs = std::max(longest_arcs, step.arcs);
  }

  double displacement = 0, bearing_force = 0, normal_force = 0;
  double late_normal_force = 0;  ///< from a time on
  long longest_arcs = 0;

 private:
  void note(const Instant& at) {
    const Motion<double> m = at.motion();
    displacement = std::max(displacement, m.displacement.norm());
    bearing_force =
        std::max(bearing_force, supports_.bearing_force(m.displacement, m.velocity).norm());
    if (!at.touches()) return;
    const double force = -ring_.elastic_force(ring_.rim_point(m));
    normal_force = std::max(normal_force, force);
    if (at.time_s >= late_s_) late_normal_force = std::max(late_normal_force, force);
  }
  Ring<double> ring_;
  Supports<double> supports_;
  double late_s_;
};

// Located, they are no less than any sample, but for the little by which the equations' rates miss
// those of the curve within a step, and no more than the samples' spacing lets be missed. A ring
// without damping lets the rotor vibrate several times within one step: up to 8 % of the largest
// force were missed by looking at the steps' ends alone. A trace has the largest force in its
// window, though the run may have had a larger one before.
TEST(LooseTolerances, DoNotHideMaxima) {
  long longest_arcs = 0;
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-11})
    for (const double damping : {0., 1000., 1e4})
      for (const auto& [friction, support_damping] :
           {std::pair(0.08, 25.), {0.3, 25.}, {1., 3000.}})
        for (const double stator_radius : {0.063, 0.09})
          for (const double start_speed_Hz : {60., 150.}) {
            Scenario scenario{
                .start_speed_Hz = start_speed_Hz, .until = 0.06, .tolerance = tolerance};
            Parameters& p = scenario.parameters;
            p.contact_damping = damping;
            p.friction = friction;
            p.support_damping = support_damping;
            p.stator_radius = stator_radius;
            p.mass_loss_time = 0;
            DenseMaxima dense(scenario, 0.03);
            SummaryObserver observer(scenario);
            constexpr double coarse = 1;  // so that rows alone do not show the largest force
            double recorded = 0;
            Recorder recorder({.from_s = 0.03, .length_s = 0.03},
                              {find_column("time_s"), find_column("normal_force_N")}, scenario,
                              coarse,
                              [&](auto row) { recorded = std::max(recorded, std::abs(row[1])); });
            ObserverGroup observers = observers_of({&dense, &observer, &recorder});
            run(scenario, observers);
            SCOPED_TRACE(testing::Message() << tolerance << ' ' << damping << ' ' << friction << ' '
                                            << stator_radius << ' ' << start_speed_Hz);
            const double in_steps = std::min(2 * tolerance, 2e-3) + 1e-9;
            const auto expect_maximum = [&](double located, double sampled) {
              EXPECT_GE(located, sampled * (1 - in_steps));
              EXPECT_LE(located, sampled * (1 + in_steps + 1e-4));
            };
            const Summary& summary = observer.summary();
            expect_maximum(summary.max_displacement_m.value_or(0), dense.displacement);
            expect_maximum(summary.peak_normal_force_N.value_or(0), dense.normal_force);
            expect_maximum(summary.peak_bearing_force_N, dense.bearing_force);
            EXPECT_GE(recorded, dense.late_normal_force * (1 - in_steps));
            longest_arcs = std::max(longest_arcs, dense.longest_arcs);
          }
  EXPECT_GT(longest_arcs, 5);  // that steps are long is what makes it hard
}

// Rows of a trace, joined by lines, stay as close to that motion as they do at tight tolerances.
TEST(LooseTolerances, DoNotCoarsenTraces) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const Scenario scenario{
        .parameters = {.mass_loss_time = 9.4}, .until = 9.46, .tolerance = tolerance};
    struct Rows {
      std::vector<double> t, rho;
    } trace;
    Recorder recorder({.from_s = 9.4}, {find_column("time_s"), find_column("rho_m")}, scenario,
                      sampling, [&](auto row) {
                        trace.t.push_back(row[0]);
                        trace.rho.push_back(row[1]);
                      });
    struct Samples : Observer {
      bool wants_dense_output(const double& from_s, const double&) const override {
        return from_s >= 9.4;
      }
      void on_step(const DenseOutput& step) override {
        for (int n = 1; n < 500; ++n) {
          const Instant at = step.at(step.from_s + (step.until_s - step.from_s) * n / 500);
          t.push_back(at.time_s);
          rho.push_back(std::hypot(at.state[0], at.state[1]));
        }
      }
      std::vector<double> t, rho;
    } samples;
    ObserverGroup observers = observers_of({&recorder, &samples});
    run(scenario, observers);
    double off = 0;
    for (std::size_t n = 0, i = 1; n < samples.t.size(); ++n) {
      while (trace.t[i] < samples.t[n]) ++i;
      const double part = (samples.t[n] - trace.t[i - 1]) / (trace.t[i] - trace.t[i - 1]);
      const double line = trace.rho[i - 1] + part * (trace.rho[i] - trace.rho[i - 1]);
      off = std::max(off, std::abs(line - samples.rho[n]));
    }
    const double range = *std::max_element(samples.rho.begin(), samples.rho.end());
    // Between points that are looked at, a line may be a little further off than at them.
    EXPECT_LT(off, 1.3 * sampling * range) << tolerance;
  }
}

TEST(Traces, NeverRunBackwardsAndSummariesReachAtLeastWhereTheRunEnds) {
  RandomScenarios random(2);
  long maxima = 0;
  for (int n = 0; n < 300; ++n) {
    Scenario scenario = random.scenario();
    scenario.tolerance = std::pow(10, -3 - n % 4);
    const Instant first = mass_lost_at_speed(scenario, random.speed());
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
    ObserverGroup observers = observers_of({&recorder, &events, &summary, &all_maxima});
    const Instant last = follow(scenario, first, 0.01, observers).last;
    EXPECT_GE(*summary.summary().max_displacement_m, last.motion().displacement.norm());
    EXPECT_LE(all_maxima.largest_gap_s, 0) << "rotor " << n;
    maxima += all_maxima.count;
  }
  EXPECT_GT(maxima, 500);  // that were located
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
  for (int n = 0; n < 150; ++n) {
    Scenario scenario = random.scenario();
    scenario.tolerance = 1e-10;
    const Instant first = mass_lost_at_speed(scenario, random.speed());
    for (const Extreme of : {Extreme::displacement, Extreme::bearing_force}) {
      PhaseMaxima watch(Supports<double>(scenario.parameters, scenario.equations), of);
      follow(scenario, first, 0.01, watch);
      for (const auto& [contact, miss] : watch.largest_miss)
        EXPECT_LT(miss, 1e-7) << n << ' ' << static_cast<int>(of) << ' '
                              << static_cast<int>(contact);
      for (const auto& [contact, count] : watch.maxima) maxima[contact] += count;
    }
  }
  for (const auto contact : {ContactState::free, ContactState::sliding, ContactState::rolling})
    EXPECT_GT(maxima[contact], 100);
}

}  // namespace
}  // namespace rotor
