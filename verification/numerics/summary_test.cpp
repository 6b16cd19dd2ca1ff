/// The quantities of a summary, which are gathered along the run.
#include "model/results/summary.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>

#include "figures/input/names.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/instant.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/random_runs.hpp"
#include "verification/support/result_formulas.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

// No supports: the mass centre does not move, and O circles about it.
TEST(Summary, OfARotorWithoutSupportsHasItsWholeReach) {
  Scenario scenario{.until = 1.5};
  Parameters& p = scenario.parameters;
  p.support_stiffness = p.support_damping = p.gravity = 0;
  p.eccentricity = 2e-3;
  p.loses_mass = false;
  p.stator_radius = p.rotor_radius + 5e-3;
  EXPECT_NEAR(summary_until(1.5, scenario).peak_displacement_before_loss_m, 2 * p.eccentricity,
              1e-3 * p.eccentricity);
  p.stator_radius = p.rotor_radius + 3.999e-3;
  EXPECT_GT(summary_until(1.5, scenario).touch_downs, 0);
}

// With a strong damper the force is largest at touch-down: F_n jumps to -d_t v_n, although the
// indentation there is only rounding, of either sign.
TEST(Summary, HasTheForceOfTheImpactWhereItIsTheLargest) {
  int gaps = 0;
  for (int n = 0; n < 100; ++n) {
    Scenario scenario{.equations = Equations::published, .start_speed_Hz = 140, .until = 0.01};
    Parameters& p = scenario.parameters;
    p.mass_loss_time = 0;
    p.rotor_radius = 0.05;
    p.stator_radius = 0.0525 + 2e-6 * n;
    p.contact_damping = 1e6;
    const EventRecorder recorder = recorded(scenario);
    const Instant& at = recorder.first(Event::touch_down);
    const Motion<double> m = at.motion();
    const double rho = m.displacement.norm();
    gaps += rho <= Ring<double>(p).clearance;
    const double impact = p.contact_damping * m.displacement.dot(m.velocity) / rho;
    const Summary summary = summary_of(scenario);
    EXPECT_NEAR(summary.peak_normal_force_N.value_or(0) / impact, 1, 1e-9);
    EXPECT_EQ(summary.peak_time_s, at.time_s);
  }
  EXPECT_GT(gaps, 0);
}

TEST(Summary, SaysWhenRollingEndsAndHowFastTheRotorWhirls) {
  const Scenario scenario{.equations = Equations::published};
  const Summary rolling = summary_until(29.35, scenario);
  EXPECT_FALSE(rolling.rolling_until_s);
  EXPECT_EQ(rolling.whirl_from_s, rolling.rolling_onset_s);  // whatever the steps are
  // The time integral of the whirl's rate, and what it must be by another method.
  struct Whirl : Observer {
    void on_instant(const Instant& at) override { rolls = at.contact == ContactState::rolling; }
    bool wants_dense_output(const double&, const double&) const override { return rolls; }
    void on_step(const DenseOutput& step) override {
      if (!rolls || step.from_s < from_s) return;
      using Rule = boost::math::quadrature::gauss<double, 15>;
      turns += Rule::integrate(
                   [&](double time_s) {
                     const Motion<double> m = step.at(time_s).motion();
                     return cross(m.displacement, m.velocity) / m.displacement.squaredNorm();
                   },
                   step.from_s, step.until_s) /
               two_pi;
      until_s = step.until_s;
    }
    double from_s = 0, until_s = 0, turns = 0;
    bool rolls = false;
  } whirl;
  whirl.from_s = rolling.whirl_from_s.value_or(0);
  run(scenario, whirl);
  EXPECT_LT(whirl.turns, -100);
  EXPECT_EQ(rolling.whirl_until_s, whirl.until_s);
  EXPECT_NEAR(*rolling.whirl_frequency_Hz * (whirl.until_s - whirl.from_s) / whirl.turns, 1, 1e-9);
  Scenario by_steps = scenario, sliding = scenario;
  by_steps.method = Method::rk4;
  EXPECT_NEAR(*summary_until(29.35, by_steps).whirl_frequency_Hz / *rolling.whirl_frequency_Hz, 1,
              0.01);
  sliding.parameters.friction = 0.08;
  EXPECT_FALSE(summary_until(29.35, sliding).whirl_frequency_Hz);
  const Summary later = summary_until(60, scenario);
  EXPECT_NEAR(later.rolling_until_s.value_or(0), 30.49, 0.005);
  EXPECT_EQ(later.outcome, Outcome::rolling);
}

TEST(Summary, OfRandomRotorsIsWhatTheirMotionsGive) {
  RandomRuns runs(7);
  for (int n = 0; n < 250; ++n) {
    const RandomInputs::Rotor rotor = runs.rotor();
    try {
      EXPECT_EQ(wrong_results(rotor.scenario), "") << options_of(rotor.stated);
    } catch (const std::runtime_error& error) {  // steps that are too long for this rotor
      EXPECT_EQ(rotor.scenario.method, Method::rk4) << error.what() << options_of(rotor.stated);
    }
  }
}

// Random rotors run too shortly to stall. The critical speed of these is 10 Hz.
TEST(Summary, OfRotorsThatMayStallIsWhatTheirMotionsGive) {
  long stalled = 0;
  for (const Method method : {Method::event, Method::rk4})
    for (double torque = 0.02; torque < 0.5; torque *= 1.5) {
      Scenario scenario{
          .equations = Equations::corrected, .method = method, .start_speed_Hz = 9, .until = 3};
      Parameters& p = scenario.parameters;
      p.torque = torque;
      p.eccentricity = 4.5e-4;
      p.loses_mass = false;
      EXPECT_EQ(wrong_results(scenario), "") << torque << ' ' << name_of(method);
      stalled += summary_of(scenario).outcome == Outcome::stalled;
    }
  EXPECT_GT(stalled, 3);
}

// What a rotor does before it loses mass is what it does without a loss.
TEST(Summary, BeforeTheLossIsThatOfARunThatEndsThere) {
  Scenario scenario{.equations = Equations::published, .until = 10.3, .tolerance = 1e-9};
  scenario.parameters.support_stiffness = 1.2e5;
  scenario.parameters.mass_loss_time = 10;
  const Summary whole = summary_of(scenario);
  scenario.parameters.loses_mass = false;
  const Summary before = summary_until(10, scenario);
  EXPECT_GT(before.touch_downs, 0);
  EXPECT_LT(before.touch_downs, whole.touch_downs);
  EXPECT_EQ(whole.touch_downs_before_loss, before.touch_downs);
  EXPECT_EQ(whole.peak_normal_force_before_loss_N, before.peak_normal_force_N);
  EXPECT_EQ(whole.peak_displacement_before_loss_m, before.peak_displacement_m);
}

TEST(Summary, HasNoSwitchOffOfTheMotorAtConstantSpeedNorACriticalSpeedWithoutStiffness) {
  Scenario scenario{.equations = Equations::corrected, .start_speed_Hz = 60, .until = 0.01};
  Parameters& p = scenario.parameters;
  p.mass_loss_time = 0;
  p.motor_off_Hz = 50;
  p.support_stiffness = p.gravity = 0;
  const Summary with_motor = summary_of(scenario);
  EXPECT_EQ(with_motor.motor_off_s, 0);
  EXPECT_TRUE(with_motor.speed_at_mass_loss_Hz);
  EXPECT_FALSE(with_motor.speed_ratio_at_mass_loss);
  p.drive = Drive::constant_speed;
  p.torque = 0;
  EXPECT_FALSE(summary_of(scenario).motor_off_s);
}

// If the rim rolls again, the end is that of the new rolling, and there is none yet. A touch-down
// after rolling is none on the way to it.
TEST(Summary, HasTheEndOfTheLastRollingAlone) {
  const Scenario scenario;
  SummaryObserver observer(scenario);
  const auto show = [&](double time_s, ContactState contact) {
    observer.on_instant({.time_s = time_s,
                         .state = {3.01e-3, 0, 0, 0, 0, 300},
                         .body = Body<double>::of(scenario.parameters),
                         .contact = contact});
    return observer.summary().rolling_until_s;
  };
  EXPECT_EQ(show(0.1, ContactState::rolling), std::nullopt);
  EXPECT_EQ(show(0.2, ContactState::sliding), 0.2);
  EXPECT_EQ(show(0.3, ContactState::sliding), 0.2);
  EXPECT_EQ(show(0.4, ContactState::rolling), std::nullopt);
  EXPECT_EQ(show(0.5, ContactState::free), 0.5);
  EXPECT_EQ(show(0.6, ContactState::sliding), 0.5);
  EXPECT_EQ(observer.summary().touch_downs, 2);
  EXPECT_EQ(observer.summary().touch_downs_to_rolling, 1);
}

// As where a contact ends, and a graze begins and ends.
TEST(NextMaximum, IsNoneOfRounding) {
  const Scenario scenario;
  const Ring<double> ring(scenario.parameters);
  NextMaximum<double> maximum(scenario);
  const auto pressed_by = [&](double indentation) {
    Instant at;
    at.state[0] = ring.clearance + indentation;
    at.contact = indentation > 0 ? ContactState::sliding : ContactState::free;
    maximum.on_instant(at);
  };
  maximum.await();
  for (const double indentation : {1e-4, 1e-6, 0., 1e-16, 0., 1e-15, 1e-17})
    pressed_by(indentation);
  maximum.on_maximum({Extreme::normal_force, 1e-8, {}});
  EXPECT_FALSE(maximum.is_found());
  for (const double indentation : {1e-6, 1e-7}) pressed_by(indentation);
  EXPECT_TRUE(maximum.is_found());
}

}  // namespace
}  // namespace rotor
