/// What observers gather along a run agrees with the motion of its steps, at every tolerance and
/// however long the steps are: the located maxima, and the order of what is shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figures/record/recorder.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/random_inputs.hpp"

namespace rotor {
namespace {

/// The largest values of the motion that a run shows, sampled densely.
class DenseMaxima : public Observer {
 public:
  explicit DenseMaxima(const Scenario& scenario, double late_s = 0)
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

/// No located maximum is less than a sample, apart from the small difference between the rates of
/// the equations and of the curve within a step, and none exceeds what can lie between two samples.
void expect_maxima(const Summary& located, const DenseMaxima& sampled, double in_steps) {
  const auto expect = [&](double of_summary, double of_samples) {
    EXPECT_GE(of_summary, of_samples * (1 - in_steps));
    EXPECT_LE(of_summary, of_samples * (1 + in_steps + 1e-4));
  };
  expect(located.max_displacement_m.value_or(0), sampled.displacement);
  expect(located.peak_normal_force_N.value_or(0), sampled.normal_force);
  expect(located.peak_bearing_force_N, sampled.bearing_force);
}

// On a ring without damping the rotor vibrates several times within one step: the ends of steps
// alone miss up to 8 % of the largest force. A trace has the largest force in its window, although
// the run may have had a larger one before.
TEST(Maxima, AreNotHiddenByLooseTolerances) {
  long longest_arcs = 0;
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-11})
    for (const double damping : {0., 1e4})
      for (const auto& [friction, support_damping] : {std::pair(0.08, 25.), {1., 3000.}})
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
            ObserverGroup observers{&dense, &observer, &recorder};
            run(scenario, observers);
            SCOPED_TRACE(testing::Message() << tolerance << ' ' << damping << ' ' << friction << ' '
                                            << stator_radius << ' ' << start_speed_Hz);
            const double in_steps = std::min(2 * tolerance, 2e-3) + 1e-9;
            expect_maxima(observer.summary(), dense, in_steps);
            EXPECT_GE(recorded, dense.late_normal_force * (1 - in_steps));
            longest_arcs = std::max(longest_arcs, dense.longest_arcs);
          }
  EXPECT_GT(longest_arcs, 5);  // long steps make it hard
}

// Of random rotors: rows, events and maxima come in the order of time, and no maximum is missed.
TEST(Maxima, OfRandomRotorsAreFoundAndNothingRunsBackwards) {
  RandomInputs random(2);
  long maxima = 0;
  for (int n = 0; n < 200; ++n) {
    SCOPED_TRACE(n);
    Scenario scenario = random.scenario();
    scenario.tolerance = std::pow(10, -4 - 2 * (n % 4));
    const Instant first = mass_lost_at_speed(scenario, two_pi * scenario.start_speed_Hz);
    double last_row_s = 0;
    Recorder recorder({},
                      {find_column("time_s"), find_column("rho_m"), find_column("normal_force_N")},
                      scenario, sampling, [&](std::span<const double> row) {
                        ASSERT_GE(row[0], last_row_s);
                        last_row_s = row[0];
                      });
    struct : Observer {
      void on_instant(const Instant& at) override {
        ASSERT_GE(at.time_s, last_s);
        last_s = at.time_s;
      }
      double threshold(Extreme, const double&, const double&) const override { return 0; }
      void on_maximum(const Maximum& maximum) override {
        ASSERT_GE(maximum.at.time_s, last_maximum_s);
        last_maximum_s = maximum.at.time_s;
        ++count;
      }
      double last_s = 0, last_maximum_s = 0;
      long count = 0;
    } in_order;
    SummaryObserver summary(scenario);
    DenseMaxima dense(scenario);
    ObserverGroup observers{&recorder, &in_order, &summary, &dense};
    const Instant last = follow(scenario, first, 0.01, observers).last;
    EXPECT_GE(*summary.summary().max_displacement_m, last.motion().displacement.norm());
    if (scenario.tolerance < 1e-9) expect_maxima(summary.summary(), dense, 1e-7);
    maxima += in_order.count;
  }
  EXPECT_GT(maxima, 500);
}

}  // namespace
}  // namespace rotor
