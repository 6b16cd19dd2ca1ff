/// What observers gather along a run agrees with the motion of its steps, at every tolerance and
/// however long the steps are: the located maxima, and the order of what is shown.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "figures/record/recorder.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/dense_maxima.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/random_runs.hpp"

namespace rotor {
namespace {

/// No located maximum is less than a sample, and none exceeds what can lie between two samples.
void expect_maxima(const Summary& located, const DenseMaxima& sampled) {
  const auto expect = [&](double of_summary, double of_samples) {
    EXPECT_GE(of_summary, of_samples * (1 - 1e-12));
    EXPECT_LE(of_summary, of_samples * (1 + 1e-4));
  };
  expect(located.peak_displacement_m.value_or(0), sampled.displacement);
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
            DenseMaxima dense(scenario, 40, 0.03);
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
            expect_maxima(observer.summary(), dense);
            EXPECT_GE(recorded, dense.late_normal_force * (1 - 1e-12));
            longest_arcs = std::max(longest_arcs, dense.longest_arcs);
          }
  EXPECT_GT(longest_arcs, 5);  // long steps make it hard
}

// However fast the direction of O turns: with arcs of one radian of rotation and vibration, of
// which each was taken to have one maximum, 18 of 20,000 drifting rotors were wrong.
TEST(Maxima, AreNotExceededBySamplesOfDriftingAndOtherRotors) {
  RandomInputs inputs(2);
  RandomRuns others(3);
  for (int n = 0; n < 500; ++n) {
    Scenario scenario = (n % 4 == 0 ? others.rotor() : drifting_rotor(inputs)).scenario;
    scenario.method = Method::event;
    for (const double tolerance : {1e-6, 1e-8, 1e-11}) {
      scenario.tolerance = tolerance;
      EXPECT_EQ(exceeded_maximum(scenario), "") << n;
    }
  }
}

// A longer run has at least the largest values of a shorter one. Between two arcs of a radian this
// rotor passes its centre at 22 um, and is nearest to it a moment later.
TEST(Maxima, DoNotBecomeSmallerInALongerRun) {
  Scenario scenario{.equations = Equations::corrected, .start_speed_Hz = 171.2};
  scenario.start = Start{.x = 4.209e-6, .velocity_x = -0.06102, .velocity_y = -0.03672};
  Parameters& p = scenario.parameters;
  p.mass = 8.362;
  p.eccentricity = 9.657e-5;
  p.stator_radius = p.rotor_radius + 1.525e-3;
  p.support_stiffness = 1555;
  p.support_damping = 0;
  p.drive = Drive::constant_speed;
  p.torque = 0;
  p.loses_mass = false;
  for (scenario.until = 0.0013; scenario.until < 0.00165; scenario.until += 1e-5) {
    const Summary found = summary_of(scenario);
    EXPECT_GE(*found.peak_displacement_m, 2.27e-5) << scenario.until;
    EXPECT_GE(found.peak_bearing_force_N, 0.0353) << scenario.until;
  }
}

// A step of rolling that spans 1.2 periods of the contact, as a tolerance of 1e-6 allows: its
// interpolant leaves what the ends of the step allow.
TEST(Maxima, AreFoundInStepsLongerThanAPeriodOfTheContact) {
  Scenario scenario{.start_speed_Hz = 22.212594579392633,
                    .start = Start{.x = -2.0383244633298155e-06,
                                   .y = 8.420469264379601e-07,
                                   .velocity_x = -0.058387237665523686,
                                   .velocity_y = -0.027072622975711225},
                    .until = 0.09609056743426318,
                    .tolerance = 1e-6};
  Parameters& p = scenario.parameters;
  p.contact_damping = 656849.3011100945;
  p.contact_stiffness = 753962729099.2633;
  p.eccentricity = 3.3068580057976785e-05;
  p.friction = 4.885774503066765;
  p.gravity = 4.404900574963762;
  p.inertia = 0.0003624248168845387;
  p.mass = 0.8553464790053786;
  p.rotor_radius = 0.01573436408952067;
  p.stator_radius = 0.01839070930114179;
  p.support_damping = 0;
  p.support_stiffness = 198.95559685226883;
  p.loses_mass = false;
  p.drive = Drive::constant_speed;
  EXPECT_EQ(exceeded_maximum(scenario), "");
}

// A steady circle has no maximum but the errors of its radius, of which the slopes say nothing.
TEST(Maxima, OfASteadyCircleAreNotLessThanItsErrors) {
  Scenario scenario{.start_speed_Hz = 193.54957891, .until = 0.0198, .tolerance = 1e-6};
  Parameters& p = scenario.parameters;
  p.eccentricity = 7.362238892624584e-05;
  p.gravity = 1.71;
  p.inertia = 0.0338;
  p.mass = 0.33921041165626065;
  p.support_damping = 1.1951598871673053;
  p.support_stiffness = 763445.799332244;
  p.loses_mass = false;
  p.drive = Drive::constant_speed;
  for (const Equations equations : {Equations::published, Equations::corrected}) {
    scenario.equations = equations;
    EXPECT_EQ(exceeded_maximum(scenario), "");
  }
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
    EXPECT_GE(*summary.summary().peak_displacement_m, last.motion().displacement.norm());
    expect_maxima(summary.summary(), dense);
    maxima += in_order.count;
  }
  EXPECT_GT(maxima, 500);
}

}  // namespace
}  // namespace rotor
