/// Events that are easily missed, doubled or misplaced, and motions that may not finish.
#include <gtest/gtest.h>

#include "model/methods/event_method.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/follow.hpp"

namespace rotor {
namespace {

// A rotor without unbalance, gravity and damping: O oscillates along a line, with the
// eigenfrequency of the supports, and touches the ring if its amplitude exceeds the clearance.
class Oscillation : public testing::Test {
 protected:
  Oscillation() {
    Parameters& p = scenario_.parameters;
    p.eccentricity = p.gravity = p.support_damping = p.contact_damping = p.torque = p.friction = 0;
    p.loses_mass = false;
    scenario_.until = 0.2;
  }

  double clearance() const { return Ring<double>(scenario_.parameters).clearance; }
  double frequency() const {
    return std::sqrt(scenario_.parameters.support_stiffness / scenario_.parameters.mass);
  }

  /// From the centre, with the velocity that gives this amplitude.
  Instant with_amplitude(double amplitude) const {
    Instant at = at_rest(scenario_.parameters);
    at.state = {0, 0, 0, 0.6 * amplitude * frequency(), 0.8 * amplitude * frequency(), 0};
    return at;
  }

  EventRecorder run_from(const Instant& at) const {
    EventRecorder run;
    follow(scenario_, at, scenario_.until, run);
    return run;
  }

  Scenario scenario_;
};

TEST_F(Oscillation, GlancingContactIsMissedByNoStepSize) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    scenario_.tolerance = tolerance;
    // The tolerance of a step is a part of 1/300 of the clearance; hundreds of steps may add up.
    const double margin = tolerance;
    EXPECT_GT(run_from(with_amplitude(clearance() * (1 + margin))).count(Event::touch_down), 0)
        << tolerance;
    EXPECT_TRUE(run_from(with_amplitude(clearance() * (1 - margin))).events().empty()) << tolerance;
  }
}

TEST_F(Oscillation, ContactAtTheEndOfARunIsSeenOnce) {
  const Instant first = with_amplitude(2 * clearance());
  const double touch = run_from(first).first(Event::touch_down).time_s;
  for (const double end : {touch, std::nextafter(touch, 0), std::nextafter(touch, 1)}) {
    EventRecorder run;
    EventMethod<double> method(scenario_, scenario_.tolerance, first);
    method.advance(end, run);
    method.advance(touch + 1e-4, run);
    EXPECT_EQ(run.count(Event::touch_down), 1) << end - touch;
  }
}

TEST_F(Oscillation, HeadOnImpactAtZeroSlipGoesStraightToRolling) {
  scenario_.parameters.friction = 0.3;
  Instant first = at_rest(scenario_.parameters);
  first.state[3] = 2 * clearance() * frequency();  // along an axis, where the slip is zero exactly
  const EventRecorder run = run_from(first);
  EXPECT_EQ(run.first(Event::touch_down).contact, ContactState::rolling);
}

TEST_F(Oscillation, ImpactsAtASlipOfRoundingSizeDoNotChatter) {
  scenario_.parameters.friction = 0.3;
  scenario_.until = 2;
  const EventRecorder run = run_from(with_amplitude(2 * clearance()));
  // A contact every 16.8 ms, with at most the events touch-down, rolling, break-away, release and
  // clear.
  EXPECT_EQ(run.count(Event::touch_down), 119);
  EXPECT_LE(run.events().size(), 5 * 119U);
}

TEST_F(Oscillation, MotorOffAndContactAtOneInstantBothHappenOnce) {
  scenario_.parameters.torque = 0.3;
  Instant first = with_amplitude(2 * clearance());
  const Instant touch = run_from(first).first(Event::touch_down);
  for (const double shift : {-1e-16, 0., 1e-16}) {
    scenario_.parameters.motor_off_Hz = touch.state[5] / two_pi * (1 + shift);
    scenario_.until = touch.time_s + 1e-4;
    const EventRecorder run = run_from(first);
    EXPECT_EQ(run.count(Event::touch_down), 1) << shift;
    EXPECT_EQ(run.count(Event::motor_off), 1) << shift;
  }
}

/// Pressed against the ring by its own whirl, without unbalance, gravity and motor.
struct Whirl : testing::Test {
  Whirl() {
    Parameters& p = scenario.parameters;
    p.eccentricity = p.gravity = p.torque = 0;
    p.loses_mass = false;
  }

  /// Its energy must be balanced.
  BalancedRun follow_motion(Instant from, double until_s) const {
    from.motor_on = false;
    BalancedRun run(scenario, from, until_s);
    EXPECT_LT(run.energy_residual(), 1e-9);  // a few thousand steps of the default tolerance
    return run;
  }
  BalancedRun pressed(double speed, double slip, double until_s) const {
    return follow_motion(pressed_by_whirl(scenario, speed, slip), until_s);
  }

  Scenario scenario;
};

TEST_F(Whirl, WithAnOverdampedContactEndsRollingAllTheSame) {
  scenario.parameters.contact_damping = 1e7;  // 80 times critical
  const BalancedRun run = pressed(300, 2, 0.05);
  EXPECT_EQ(run.count(Event::rolling_onset), 1);
  EXPECT_EQ(run.last().contact, ContactState::rolling);
}

TEST_F(Whirl, OfAnUnbalancedRotorWithLittleFrictionRollsAndSlidesInTurns) {
  scenario.parameters.eccentricity = 1e-3;
  scenario.parameters.friction = 0.01;
  const BalancedRun run = pressed(100, 0, 0.05);
  EXPECT_GT(run.count(Event::rolling_onset), 5);
  EXPECT_GT(run.count(Event::break_away), 5);
  EXPECT_EQ(run.count(Event::slip_reversal), 0);  // it breaks away to the right side
}

TEST_F(Whirl, ThatTheDashpotReleasesMeetsTheRingBeforeItHasComeBack) {
  scenario.parameters.contact_damping = 2e5;
  Instant at = pressed_by_whirl(scenario, 300, 0);
  at.state[3] = -4;  // leaves the ring faster than its spot springs back
  const BalancedRun run = follow_motion(at, 0.01);
  EXPECT_GE(run.count(Event::renewed_contact), 1);
}

// Without damping the ring has sprung back where the force vanishes: there is no indented phase
// then, which would chatter in rounding.
TEST_F(Whirl, BouncesAThousandTimesOnARingWithoutDamping) {
  Parameters& p = scenario.parameters;
  p.friction = p.contact_damping = p.support_damping = 0;
  Instant at = pressed_by_whirl(scenario, 50, 1);
  at.state[3] = 1;  // m/s against the ring, ten times what its load of 7 kN presses it in
  const BalancedRun run = follow_motion(at, 3);
  EXPECT_GT(run.count(Event::touch_down), 1000);
  EXPECT_EQ(run.count(Event::ring_clear), 0);
  EXPECT_EQ(run.count(Event::renewed_contact), 0);
}

}  // namespace
}  // namespace rotor
