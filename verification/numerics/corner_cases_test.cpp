/// Corner cases of the event-located method beyond those on a line (oscillation_test.cpp).
#include <gtest/gtest.h>

#include "figures/scenes/audience.hpp"
#include "model/phases/flight.hpp"
#include "model/simulation/summary.hpp"
#include "model/simulation/switch_limit.hpp"
#include "verification/support/balanced_run.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

/// A run from an instant to a time, whose energy must be balanced.
BalancedRun follow_motion(const Scenario& scenario, const Instant& from, double until_s) {
  BalancedRun run(scenario, from, until_s);
  EXPECT_LT(run.energy_residual(), 1e-9);  // a few thousand steps of the default tolerance
  for (const double component : run.last().state) EXPECT_TRUE(std::isfinite(component));
  return run;
}

// Whatever the phase: 3 rad/s below and above f_max, with the rim sliding at another speed.
TEST(MotorOff, IsAtItsSpeedInEveryPhase) {
  const Parameters p;
  const RotorSystem<double> rotor(p, Equations::published);
  const double rho = p.stator_radius - p.rotor_radius + 1e-6;
  for (const double beyond : {-3., 3.}) {
    const State<double> q = {rho, 0, 0, 0.1, 20, rotor.motor_off + beyond};
    const ContactChart<double> contact(rotor, q);
    const FlightChart<double> flight(rotor, q);
    const auto expect_last_guard = [&](const auto& phase, const auto& chart) {
      EXPECT_NEAR(phase.guard(phase.event_count - 1, chart.unknowns(q)), -beyond,
                  1e-9);  // rounding
    };
    expect_last_guard(FreeFlight<double>(rotor, flight), flight);
    expect_last_guard(IndentedFlight<double>(rotor, contact), contact);
    expect_last_guard(Sliding<double>(rotor, contact, 1), contact);
    expect_last_guard(Rolling<double>(rotor, contact), contact);
  }
}

/// Pressed against the ring by its own whirl, without unbalance, gravity and motor.
struct Whirl : testing::Test {
  Whirl() {
    Parameters& p = scenario.parameters;
    p.eccentricity = p.gravity = p.torque = 0;
    p.separates = false;
  }

  Instant pressed(double speed, double slip) const {
    const Parameters& p = scenario.parameters;
    const double clearance = p.stator_radius - p.rotor_radius;
    const double tangential = slip - p.rotor_radius * speed;
    const double indentation = p.mass * tangential * tangential / clearance / p.contact_stiffness;
    const double rho = clearance + indentation;
    Instant at = at_rest(scenario.parameters);
    at.motor_on = false;
    at.contact = slip == 0 ? ContactState::rolling : ContactState::sliding;
    at.state = {rho, 0, 0, 0, tangential - speed * rho, speed};
    return at;
  }

  Scenario scenario;
};

TEST_F(Whirl, ThatRollsSlowsDownUntilTheSupportsTakeTheRotorFromTheRing) {
  scenario.parameters.support_damping = 500;
  const BalancedRun run = follow_motion(scenario, pressed(100, 0), 1);
  EXPECT_EQ(run.last().contact, ContactState::free);
  EXPECT_EQ(run.count(Event::release), 1);
}

TEST_F(Whirl, InTheOtherSenseRollsAsWell) {
  const BalancedRun run = follow_motion(scenario, pressed(-300, 0), 0.05);
  EXPECT_EQ(run.last().contact, ContactState::rolling);
}

TEST_F(Whirl, SlidesForEverWithoutFriction) {
  scenario.parameters.friction = 0;
  const BalancedRun run = follow_motion(scenario, pressed(300, 2), 0.05);
  EXPECT_EQ(run.last().contact, ContactState::sliding);
  EXPECT_EQ(run.last().state[5], 300);
}

TEST_F(Whirl, WithAnOverdampedContactEndsRollingAllTheSame) {
  scenario.parameters.contact_damping = 1e7;  // 80 times critical
  const BalancedRun run = follow_motion(scenario, pressed(300, 2), 0.05);
  EXPECT_EQ(run.count(Event::rolling_onset), 1);
  EXPECT_EQ(run.last().contact, ContactState::rolling);
}

TEST_F(Whirl, OfAnUnbalancedRotorWithLittleFrictionRollsAndSlidesInTurns) {
  scenario.parameters.eccentricity = 1e-3;
  scenario.parameters.friction = 0.01;
  const BalancedRun run = follow_motion(scenario, pressed(100, 0), 0.05);
  EXPECT_GT(run.count(Event::rolling_onset), 5);
  EXPECT_GT(run.count(Event::break_away), 5);
  EXPECT_EQ(run.count(Event::slip_reversal), 0);  // it breaks away to the right side
}

TEST_F(Whirl, ThatTheDashpotReleasesMeetsTheRingBeforeItHasComeBack) {
  scenario.parameters.contact_damping = 2e5;
  Instant at = pressed(300, 0);
  at.state[3] = -4;  // leaves the ring faster than its spot springs back
  const BalancedRun run = follow_motion(scenario, at, 0.01);
  EXPECT_GE(run.count(Event::renewed_contact), 1);
}

// Without damping the ring has sprung back where the force vanishes: there is no indented phase
// then, which would chatter in rounding.
TEST_F(Whirl, BouncesAThousandTimesOnARingWithoutDamping) {
  Parameters& p = scenario.parameters;
  p.friction = p.contact_damping = p.support_damping = 0;
  Instant at = pressed(50, 1);
  at.state[3] = 1;  // m/s against the ring, ten times what its load of 7 kN presses it in
  const BalancedRun run = follow_motion(scenario, at, 3);
  EXPECT_GT(run.count(Event::touch_down), 1000);
  EXPECT_EQ(run.count(Event::ring_clear), 0);
  EXPECT_EQ(run.count(Event::renewed_contact), 0);
}

TEST(Centre, IsNoSpecialPlaceOfFlight) {
  Scenario scenario;
  scenario.parameters.separates = false;
  const BalancedRun run = follow_motion(scenario, at_rest(scenario.parameters), 0.5);
  EXPECT_EQ(run.last().contact, ContactState::free);
}

TEST(Speed, MayPassThroughZero) {
  Scenario scenario;
  scenario.parameters.separates = false;
  Instant at = at_rest(scenario.parameters);
  at.state[5] = -5;
  const BalancedRun run = follow_motion(scenario, at, 1);
  const double rate = scenario.parameters.torque / scenario.parameters.inertia;
  EXPECT_NEAR(run.last().state[5], -5 + rate, 1e-3 * rate);  // drag and gravity are that small
}

TEST(SwitchLimit, IsAThousandWithinAPeriod) {
  SwitchLimit<double> limit;
  limit.restart(3);
  for (int n = 0; n < 1000; ++n) EXPECT_FALSE(limit.exceeded(3, 0.5)) << n;
  EXPECT_TRUE(limit.exceeded(3.5, 0.5));
  EXPECT_FALSE(limit.exceeded(3.75, 0.5));  // a period has passed: counted anew
}

// A rotor that does not turn meets the ring without slip, wherever that is, and whirls no more than
// it did.
TEST(Summary, HasNoWhirlWhereATouchDownRollsAtOnce) {
  Scenario scenario;
  Parameters& p = scenario.parameters;
  p.gravity = p.torque = p.eccentricity = 0;
  p.separates = false;
  Instant from = at_rest(p);
  from.state = {0, 2.9e-3, 0, 0, 0.5, 0};
  SummaryObserver observer(scenario);
  EventRecorder events;
  Audience audience;
  audience.add(observer);
  audience.add(events);
  const double touch_s = [&] {
    EventRecorder look;
    follow(scenario, from, 5e-4, look);
    return look.first(Event::touch_down).time_s;
  }();
  follow(scenario, from, touch_s + 1e-5, audience);
  EXPECT_EQ(events.first(Event::touch_down).contact, ContactState::rolling);
  EXPECT_LT(std::abs(observer.summary().whirl_frequency_Hz.value_or(0)), 1);
}

// Where friction hardly holds a rim that rolls, the guard takes the loads at the ends of steps,
// too.
TEST(Counters, CountTheContactLawInGuardsThatNeedIt) {
  Scenario scenario;
  Parameters& p = scenario.parameters;
  p.gravity = p.torque = 0;
  const double speed = 300, clearance = p.stator_radius - p.rotor_radius,
               rim = p.rotor_radius * speed,
               rho = clearance + p.mass * rim * rim / clearance / p.contact_stiffness;
  Instant from = at_rest(p);
  from.contact = ContactState::rolling;
  from.state = {rho, 0, 0, 0, -rim - speed * rho, speed};
  Observer nobody;
  for (const auto& [friction, is_close] : {std::pair(1., false), {0.03, true}}) {
    p.friction = friction;
    const RunEnd end = follow(scenario, from, 1e-4, nobody);
    EXPECT_EQ(end.last.contact, ContactState::rolling);
    EXPECT_EQ(end.counters.contact_evaluations > end.counters.right_hand_sides, is_close)
        << end.counters.contact_evaluations << ' ' << end.counters.right_hand_sides;
  }
}

}  // namespace
}  // namespace rotor
