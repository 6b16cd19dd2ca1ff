/// Events that follow each other closely or meet a state that the paper's runs lack: the motor's
/// limit and the mass loss in contact. Each is checked by something independent: the balances of
/// energy and angular momentum, a much tighter tolerance, or a closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "figures/record/columns.hpp"
#include "model/certified/comparison.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/deviation.hpp"
#include "verification/support/starts.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// The friction that holds a rim, relative to |F_n|.
double needed_friction(const Scenario& scenario, const Instant& at) {
  const ColumnContext context(scenario);
  View view(at, context);
  return std::abs(view.friction() / view.normal_force());
}

/// The paper's rotor, driven and in contact at once: a run-up with a torque that is felt.
struct EventPairs : testing::Test {
  EventPairs() {
    Parameters& p = scenario.parameters;
    p.torque = 300;  // 33 krad/s^2 of the free rotor
    p.loses_mass = false;
    scenario.tolerance = 1e-12;
  }

  Instant pressed(double speed, double slip) const {
    return pressed_by_whirl(scenario, speed, slip);
  }

  void switch_off_at(double speed) {
    scenario.parameters.motor_off_Hz = speed / (2 * std::numbers::pi);
  }

  /// Both balances over a run through the events, and how many of a kind it has.
  BalancedRun balanced(const Instant& from, double until_s) const {
    BalancedRun run(scenario, from, until_s);
    EXPECT_LT(run.energy_residual(), 1e-9);  // the torque's work is 1e-2 of the energy and more
    EXPECT_LT(run.angular_momentum_residual(), 1e-9);
    return run;
  }

  Scenario scenario;
};

TEST_F(EventPairs, MotorOffWhileRollingChangesNothingButTheTorque) {
  switch_off_at(100.5);
  const BalancedRun run = balanced(pressed(100, 0), 5e-3);
  EXPECT_NEAR(run.first(Event::motor_off).state[5], 100.5, 1e-11);
  EXPECT_EQ(run.count(Event::break_away), 0);
  EXPECT_EQ(run.last().contact, ContactState::rolling);
  EXPECT_FALSE(run.last().motor_on);
}

// The motor holds the rim for as long as it drives; without it friction is asked for more than it
// has.
TEST_F(EventPairs, MotorOffWhileRollingEndsItWhereFrictionAloneIsTooWeak) {
  Instant from = pressed(100, 0);
  scenario.parameters.friction = 10;
  const auto needed = [&](bool motor_on) {
    from.motor_on = motor_on;
    return needed_friction(scenario, from);
  };
  const double driven = needed(true), alone = needed(false);
  from.motor_on = true;
  const double least = std::min(driven, alone), greatest = std::max(driven, alone);
  ASSERT_LT(least, 0.5 * greatest);
  scenario.parameters.friction = std::sqrt(least * greatest);
  switch_off_at(100 + 1e-6);
  EventRecorder events;
  follow(scenario, from, 1e-4, events);
  ASSERT_GE(events.events().size(), 2U);
  const Instant &first = events.events()[0], &second = events.events()[1];
  EXPECT_EQ(first.event, driven < alone ? Event::motor_off : Event::break_away);
  EXPECT_EQ(second.event, driven < alone ? Event::break_away : Event::motor_off);
  EXPECT_LT(second.time_s, 1e-6);
}

TEST_F(EventPairs, MotorOffWhileSlidingKeepsTheSlipsDirection) {
  for (const double direction : {-1., 1.}) {
    scenario.parameters.friction = 0.001;  // the slip lasts
    const Instant from = pressed(200, direction * 5);
    switch_off_at(201);
    const BalancedRun run = balanced(from, 2e-3);
    EXPECT_NEAR(run.first(Event::motor_off).state[5], 201, 1e-11) << direction;
    EXPECT_EQ(run.count(Event::slip_reversal) + run.count(Event::rolling_onset), 0) << direction;
    EXPECT_EQ(run.last().contact, ContactState::sliding) << direction;
  }
}

// From a slip of 0 that friction cannot hold, the motor is off an instant later: the slip goes on
// growing, at first as the moments and the friction say.
TEST_F(EventPairs, MotorOffRightAfterSlipFromRestLeavesTheSlipAsItIs) {
  scenario.parameters.friction = 0.001;
  scenario.parameters.torque = 3000;
  Instant from = pressed(100, 0);
  const double off = 100 + 1e-4;
  switch_off_at(off);
  EventRecorder events;
  follow(scenario, from, 1e-3, events);
  ASSERT_GE(events.count(Event::break_away), 1);
  ASSERT_EQ(events.events()[1].event, Event::motor_off);
  EXPECT_LT(events.first(Event::motor_off).time_s - events.first(Event::break_away).time_s, 1e-6);
  balanced(from, 1e-3);
  Scenario finer = scenario;
  finer.tolerance = 1e-14;
  EventRecorder reference;
  follow(finer, from, 1e-3, reference);
  EXPECT_LT(deviation(events.last().state, reference.last().state), 1e-9);
}

TEST_F(EventPairs, MotorOffAndTouchDownInOneStepBothHappenInTheirOrder) {
  scenario.parameters.torque = 0.3;
  Instant from = at_rest(scenario.parameters);
  from.state = {2.9e-3, 0, 0, 0.5, 1, 400};
  EventRecorder touching;
  switch_off_at(1e6);
  follow(scenario, from, 1e-3, touching);
  const Instant touch = touching.first(Event::touch_down);
  for (const double ahead_s : {-1e-6, -1e-9, 1e-9, 1e-6}) {
    // The speed there, by which the motor is switched off so much before the touch-down.
    switch_off_at(touch.state[5] - ahead_s * 0.3 / scenario.parameters.inertia);
    EventRecorder events;
    follow(scenario, from, 1e-3, events);
    ASSERT_EQ(events.count(Event::touch_down), 1) << ahead_s;
    const double touch_s = events.first(Event::touch_down).time_s;
    EXPECT_NEAR(touch_s, touch.time_s, 1e-12) << ahead_s;
    // In contact friction brakes: the motor is not switched off after it any more.
    EXPECT_EQ(events.count(Event::motor_off), ahead_s > 0 ? 1 : 0) << ahead_s;
    if (ahead_s > 0) {
      EXPECT_NEAR(touch_s - events.first(Event::motor_off).time_s, ahead_s, 0.1 * ahead_s);
    }
    balanced(from, 1e-3);
  }
}

/// A mass loss at a time, in the state that the run is in then.
struct LossInContact : EventPairs {
  /// On its way to a ring whose damper lets it come back slowly.
  Instant bouncing() {
    scenario.parameters.torque = 0.3;
    scenario.parameters.contact_damping = 1e5;
    Instant from = at_rest(scenario.parameters);
    from.state = {2.9e-3, 0, 0, 0.5, -400 * 2.9e-3, 400};
    return from;
  }

  /// Between the release and what comes next.
  double while_indented_s(const Instant& from) const {
    EventRecorder events;
    follow(scenario, from, 2e-3, events);
    for (std::size_t n = 1; n < events.events().size(); ++n)
      if (events.events()[n - 1].contact == ContactState::indented)
        return (events.events()[n - 1].time_s + events.events()[n].time_s) / 2;
    throw std::runtime_error("the ring is never indented without a force");
  }

  void expect_loss(ContactState in, const Instant& from, double mass_loss_s, double until_s) {
    Parameters& p = scenario.parameters;
    p.loses_mass = true;
    p.mass_loss_time = mass_loss_s;
    scenario.until = until_s;
    for (const Equations equations : {Equations::published, Equations::consistent}) {
      scenario.equations = equations;
      struct Whole : BalanceObserver {
        using BalanceObserver::BalanceObserver;
        void on_instant(const Instant& at) override {
          BalanceObserver::on_instant(at);
          if (last.event == Event::mass_loss) next = at;
          if (at.event == Event::mass_loss) after = at, before = last;
          last = at;
        }
        Instant before, after, next, last;
      } run_through(scenario);
      run(scenario, from, run_through);
      EXPECT_EQ(run_through.before.contact, in);
      EXPECT_EQ(run_through.after.contact, run_through.next.contact);
      EXPECT_LT(run_through.energy_residual(), 1e-9);
      EXPECT_LT(run_through.angular_momentum_residual(), 1e-9);
      // Eqs. (5) and (14): only q2' jumps, and only as printed.
      const double e = p.eccentricity, e_1 = 3 * e, r = p.rotor_radius;
      const double lost = p.mass * (e_1 - e) / (r + e_1);
      State<double> expected = run_through.before.state;
      if (equations == Equations::published)
        expected[4] += lost * expected[5] * (r + e) / (p.mass - lost);
      EXPECT_LT(deviation(run_through.after.state, expected), 1e-13);
      EXPECT_NEAR(run_through.after.body.mass, p.mass - lost, 1e-14);
      Scenario finer = scenario;
      finer.tolerance = 1e-14;
      Whole reference(finer);
      run(finer, from, reference);
      EXPECT_EQ(run_through.last.contact, reference.last.contact);
      EXPECT_LT(deviation(run_through.last.state, reference.last.state), 1e-8);
    }
  }
};

TEST_F(LossInContact, WhileSliding) {
  scenario.parameters.torque = 0.3;
  scenario.parameters.friction = 0.05;
  expect_loss(ContactState::sliding, pressed(300, 5), 2e-4, 2e-3);
}

// Where the published jump of the velocity points inwards and presses less than the damper pulls,
// the rim leaves the ring's spot at once; whoever watches is told so.
TEST_F(LossInContact, MayEndTheContactForceAtOnce) {
  Parameters& p = scenario.parameters;
  p.torque = 0.3;
  p.friction = 0.01;
  p.loses_mass = true;
  p.mass_loss_time = 1e-6;
  scenario.until = 1e-5;
  int released = 0, pressed_on = 0;
  for (const double tangential : {-0.5, 0.5})
    for (double angle = 0; angle < 6; angle += 0.5) {
      Instant from = pressed(300, tangential + 300 * p.rotor_radius);
      const double c = std::cos(angle), s = std::sin(angle), x = from.state[0], v = from.state[4];
      from.state = {x * c, x * s, 0, -v * s, v * c, 300};
      struct Next : Observer {
        void on_instant(const Instant& at) override {
          if (loss && !next) next = at;
          if (at.event == Event::mass_loss) loss = at;
        }
        std::optional<Instant> loss, next;
      } seen;
      run(scenario, from, seen);
      EXPECT_EQ(seen.loss->contact, seen.next->contact) << tangential << ' ' << angle;
      ++(seen.loss->contact == ContactState::indented ? released : pressed_on);
    }
  EXPECT_GT(released, 3);
  EXPECT_GT(pressed_on, 3);
}

TEST_F(LossInContact, WhileRolling) {
  scenario.parameters.torque = 0.3;
  expect_loss(ContactState::rolling, pressed(300, 0), 2e-3, 5e-3);
}

TEST_F(LossInContact, WhileTheRingIsStillIndented) {
  const Instant from = bouncing();
  expect_loss(ContactState::indented, from, while_indented_s(from), 2e-3);
}

// Without friction the motor makes the rotor only faster; it is switched off where the ring is
// still indented, and the rotor is clear of the ring where it would have been, too.
TEST_F(LossInContact, OrTheMotorsLimitMayComeWhileTheRingIsStillIndented) {
  scenario.parameters.friction = 0;
  const Instant from = bouncing();
  const double middle_s = while_indented_s(from);
  EventRecorder there, whole;
  switch_off_at(follow(scenario, from, middle_s, there).last.state[5]);
  follow(scenario, from, 2e-3, whole);
  const auto& events = whole.events();
  const auto off = std::ranges::find(events, Event::motor_off, &Instant::event);
  ASSERT_NE(off, events.end());
  EXPECT_NEAR(off->time_s, middle_s, 1e-9);
  EXPECT_EQ(off->contact, ContactState::indented);
  ASSERT_NE(off + 1, events.end());
  EXPECT_EQ((off + 1)->event, Event::ring_clear);
  balanced(from, 2e-3);
}

// A run that ends there says so, and goes on from there as if it had not ended.
TEST_F(LossInContact, OrTheEndOfARunMayComeWhileTheRingIsStillIndented) {
  const Instant from = bouncing();
  const double middle_s = while_indented_s(from);
  EventRecorder whole, first, second;
  follow(scenario, from, 2e-3, whole);
  follow(scenario, from, middle_s, first);
  EXPECT_EQ(first.last().contact, ContactState::indented);
  EXPECT_EQ(first.last().time_s, middle_s);
  follow(scenario, first.last(), 2e-3, second);
  EXPECT_LT(deviation(second.last().state, whole.last().state), 1e-9);
  EXPECT_EQ(first.events().size() + second.events().size(), whole.events().size());
}

// Its slip stays zero, whatever rounding makes of it, and its whirl is that of the whole rolling,
// though the angle begins anew. So it is where the jump that counts twice is none.
TEST(LossInRolling, OfNothingChangesNothing) {
  for (const Equations& equations : {Equations::consistent, Equations::published})
    for (const Method method : {Method::event, Method::rk4})
      for (const double loss_s : {2.4, 2.5, 2.65}) {
        Scenario scenario{.equations = equations, .method = method, .until = 2.8};
        Parameters& p = scenario.parameters;
        p.stator_radius = p.rotor_radius + 1e-3;
        p.friction = 0.8;
        p.unbalance_factor = 1;  // so that the piece has no mass; it rolls from 2.34 s on
        p.mass_loss_time = loss_s;
        Scenario without = scenario;
        without.parameters.loses_mass = false;
        const Summary expected = summary_of(without), summary = summary_of(scenario);
        ASSERT_EQ(expected.outcome, Outcome::rolling);
        EXPECT_EQ(summary.outcome, Outcome::rolling);
        EXPECT_NEAR(*summary.whirl_from_s, *expected.whirl_from_s, 1e-9) << loss_s;
        EXPECT_EQ(summary.whirl_until_s, expected.whirl_until_s) << loss_s;
        const double error = method == Method::event ? 1e-8 : 1e-3;
        EXPECT_NEAR(*summary.whirl_frequency_Hz / *expected.whirl_frequency_Hz, 1, error) << loss_s;
        if (method == Method::rk4) continue;
        EventRecorder events;
        run(scenario, events);
        EXPECT_EQ(events.events().back().event, Event::mass_loss) << loss_s;
      }
}

// The lighter rotor needs more friction than there is: it breaks away where it loses its mass.
TEST(LossInRolling, IsItsEndWhereFrictionCannotHoldTheRimAnyMore) {
  Scenario scenario{.equations = Equations::consistent, .until = 0.1708};
  Parameters& p = scenario.parameters;
  p.stator_radius = p.rotor_radius + 0.001475357217480754;
  p.friction = 0.37190941845000236;
  p.eccentricity = 0.0020541422388225413;
  p.torque = 3.34606887213461;
  p.contact_stiffness = 531646519.4155671;
  p.contact_damping = 129.3553134786258;
  p.inertia = 0.0032870302767832728;
  p.unbalance_factor = 1.5;
  p.mass_loss_time = 0.17064984521861742;
  EventRecorder events;
  run(scenario, events);
  const auto loss = std::ranges::find(events.events(), Event::mass_loss, &Instant::event);
  EXPECT_LT(needed_friction(scenario, events.before_mass_loss()), p.friction);
  EXPECT_GT(needed_friction(scenario, *loss), 1.01 * p.friction);
  ASSERT_NE(loss + 1, events.events().end());
  EXPECT_EQ((loss + 1)->event, Event::break_away);
  EXPECT_EQ((loss + 1)->time_s, loss->time_s);
  scenario.until = p.mass_loss_time + 1e-6;  // its digits are known nevertheless
  const auto found = compare<double>(scenario, 1e-10, [](double /*time_s*/) { return true; });
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_course_sure());
}

}  // namespace
}  // namespace rotor
