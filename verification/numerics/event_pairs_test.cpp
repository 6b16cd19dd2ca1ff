/// The motor's limit, the mass loss and the end of a run at any instant of a contact, unlike in the
/// paper's runs: both balances hold, and a much smaller tolerance leads to the same end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "figures/record/columns.hpp"
#include "model/digits/digits.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/deviation.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// A motion that starts at the ring, with a large torque.
struct DrivenRub {
  Scenario scenario;
  Instant from;
};

Scenario driven(double friction, double until_s) {
  Scenario scenario{.until = until_s, .tolerance = 1e-12};
  scenario.parameters.torque = 300;  // 33 krad/s^2 of the free rotor
  scenario.parameters.friction = friction;
  scenario.parameters.loses_mass = false;
  return scenario;
}

/// Rolling; sliding in either direction, with so little friction that it lasts; and bouncing on a
/// ring whose damper lets it spring back slowly.
std::vector<DrivenRub> rubs() {
  const Scenario rolling = driven(0.3, 5e-3), sliding = driven(0.001, 2e-3);
  Scenario bouncing = driven(0, 2e-3);
  bouncing.parameters.contact_damping = 1e5;
  Instant flying = at_rest(bouncing.parameters);
  flying.state = {2.9e-3, 0, 0, 0.5, -400 * 2.9e-3, 400};
  return {{rolling, pressed_by_whirl(rolling, 100, 0)},
          {sliding, pressed_by_whirl(sliding, 200, 5)},
          {sliding, pressed_by_whirl(sliding, 200, -5)},
          {bouncing, flying}};
}

/// A run with its balances, and all instants that it shows: those on both sides of each event.
struct Recorded : BalanceObserver {
  Recorded(const Scenario& scenario, const Instant& from) : BalanceObserver(scenario) {
    run(scenario, from, *this);
  }
  void on_instant(const Instant& at) override {
    BalanceObserver::on_instant(at);
    instants.push_back(at);
  }
  const Instant& last() const { return instants.back(); }
  long events() const {
    return std::ranges::count_if(instants,
                                 [](const Instant& at) { return at.event != Event::none; });
  }
  auto first(Event kind) const { return std::ranges::find(instants, kind, &Instant::event); }

  std::vector<Instant> instants;
};

/// The middle of each interval between two events.
std::vector<double> middles_s(const Recorded& run) {
  std::vector<double> all;
  for (std::size_t n = 1; n < run.instants.size(); ++n)
    if (const double from_s = run.instants[n - 1].time_s, until_s = run.instants[n].time_s;
        until_s > from_s)
      all.push_back((from_s + until_s) / 2);
  return all;
}

Instant at_time(DrivenRub rub, double time_s) {
  rub.scenario.until = time_s;
  return Recorded(rub.scenario, rub.from).last();
}

void expect_sound(const DrivenRub& rub, const Recorded& run) {
  EXPECT_LT(run.energy_residual(), 1e-9);  // the torque's work is at least 1e-2 of the energy
  EXPECT_LT(run.angular_momentum_residual(), 1e-9);
  Scenario finer = rub.scenario;
  finer.tolerance = 1e-14;
  const Recorded reference(finer, rub.from);
  EXPECT_EQ(run.last().contact, reference.last().contact);
  EXPECT_LT(deviation(run.last().state, reference.last().state), 1e-8);
}

const std::set<ContactState> all_states = {ContactState::free, ContactState::sliding,
                                           ContactState::rolling, ContactState::indented};

TEST(RubInEachState, GoesOnWithoutItsMotor) {
  std::set<ContactState> seen;
  for (const DrivenRub& rub : rubs())
    for (const double middle_s : middles_s(Recorded(rub.scenario, rub.from))) {
      const double speed = at_time(rub, middle_s).state[5];
      DrivenRub limited = rub;
      limited.scenario.parameters.motor_off_Hz = speed / two_pi;
      const Recorded run(limited.scenario, limited.from);
      const auto off = run.first(Event::motor_off);
      ASSERT_NE(off, run.instants.end());
      EXPECT_NEAR(off->state[5] / speed, 1, 1e-13);
      EXPECT_EQ(off->contact, (off - 1)->contact);  // neither slip nor contact changes at once
      EXPECT_FALSE(run.last().motor_on);
      expect_sound(limited, run);
      seen.insert(off->contact);
    }
  EXPECT_EQ(seen, all_states);
}

// Eqs. (5) and (14): only q2' jumps, and only as printed.
TEST(RubInEachState, LosesItsMass) {
  std::set<ContactState> seen;
  for (const Equations equations : {Equations::published, Equations::corrected})
    for (const DrivenRub& rub : rubs())
      for (const double middle_s : middles_s(Recorded(rub.scenario, rub.from))) {
        DrivenRub losing = rub;
        Parameters& p = losing.scenario.parameters;
        p.loses_mass = true;
        p.mass_loss_time = middle_s;
        losing.scenario.equations = equations;
        const Recorded run(losing.scenario, losing.from);
        const auto loss = run.first(Event::mass_loss);
        ASSERT_NE(loss, run.instants.end());
        EXPECT_EQ(loss->contact, (loss + 1)->contact);
        const double e = p.eccentricity, e_1 = 3 * e, r = p.rotor_radius;
        const double lost = p.mass * (e_1 - e) / (r + e_1);
        State<double> expected = (loss - 1)->state;
        if (equations == Equations::published)
          expected[4] += lost * expected[5] * (r + e) / (p.mass - lost);
        EXPECT_LT(deviation(loss->state, expected), 1e-13);
        EXPECT_NEAR(loss->body.mass, p.mass - lost, 1e-14);
        expect_sound(losing, run);
        seen.insert((loss - 1)->contact);
      }
  EXPECT_EQ(seen, all_states);
}

TEST(RubInEachState, ContinuesFromWhereARunHasEnded) {
  std::set<ContactState> seen;
  for (const DrivenRub& rub : rubs()) {
    const Recorded whole(rub.scenario, rub.from);
    for (const double middle_s : middles_s(whole)) {
      Scenario until_there = rub.scenario;
      until_there.until = middle_s;
      const Recorded first(until_there, rub.from), second(rub.scenario, first.last());
      EXPECT_EQ(first.last().time_s, middle_s);
      EXPECT_LT(deviation(second.last().state, whole.last().state), 1e-9);
      EXPECT_EQ(first.events() + second.events(), whole.events());
      seen.insert(first.last().contact);
    }
  }
  EXPECT_EQ(seen, all_states);
}

/// The friction that holds a rim, relative to |F_n|.
double needed_friction(const Scenario& scenario, const Instant& at) {
  const ColumnContext context(scenario);
  InstantView view(at, context);
  return std::abs(view.friction() / view.normal_force());
}

// While the motor drives, friction can hold the rim; without the motor more friction is needed than
// is available.
TEST(MotorOff, EndsRollingWhereFrictionAloneIsTooWeak) {
  Scenario scenario = driven(10, 1e-4);
  Instant from = pressed_by_whirl(scenario, 100, 0);
  const auto needed = [&](bool motor_on) {
    from.motor_on = motor_on;
    return needed_friction(scenario, from);
  };
  const double driven = needed(true), alone = needed(false);
  ASSERT_LT(std::min(driven, alone), 0.5 * std::max(driven, alone));
  scenario.parameters.friction = std::sqrt(driven * alone);
  scenario.parameters.motor_off_Hz = (100 + 1e-6) / two_pi;
  from.motor_on = true;
  EventRecorder run;
  follow(scenario, from, scenario.until, run);
  const auto& events = run.events();
  ASSERT_GE(events.size(), 2U);
  EXPECT_EQ(events[0].event, driven < alone ? Event::motor_off : Event::break_away);
  EXPECT_EQ(events[1].event, driven < alone ? Event::break_away : Event::motor_off);
  EXPECT_LT(events[1].time_s, 1e-6);
}

// If the published velocity jump points inwards and takes more from the normal force than there is,
// the rim leaves the ring at once, and observers are shown that.
TEST(LossInSliding, MayEndTheContactForceAtOnce) {
  Scenario scenario = driven(0.01, 1e-5);
  scenario.equations = Equations::published;
  scenario.parameters.loses_mass = true;
  scenario.parameters.mass_loss_time = 1e-6;
  int released = 0, pressed_on = 0;
  for (const double tangential : {-0.5, 0.5})
    for (double angle = 0; angle < 6; angle += 0.5) {
      Instant from =
          pressed_by_whirl(scenario, 300, tangential + 300 * scenario.parameters.rotor_radius);
      const double c = std::cos(angle), s = std::sin(angle), x = from.state[0], v = from.state[4];
      from.state = {x * c, x * s, 0, -v * s, v * c, 300};
      const Recorded run(scenario, from);
      const auto loss = run.first(Event::mass_loss);
      EXPECT_EQ(loss->contact, (loss + 1)->contact) << tangential << ' ' << angle;
      ++(loss->contact == ContactState::indented ? released : pressed_on);
    }
  EXPECT_GT(released, 3);
  EXPECT_GT(pressed_on, 3);
}

// The slip stays exactly zero, and the whirl is the mean over all of the rolling, although its
// angle restarts. The same holds for the published jump, which is zero here.
TEST(LossInRolling, OfNothingChangesNothing) {
  for (const Equations& equations : {Equations::corrected, Equations::published})
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
        const EventRecorder events = recorded(scenario);
        EXPECT_EQ(events.events().back().event, Event::mass_loss) << loss_s;
      }
}

// The lighter rotor needs more friction than there is: it breaks away where it loses its mass.
TEST(LossInRolling, IsItsEndWhereFrictionCannotHoldTheRimAnyMore) {
  Scenario scenario{.equations = Equations::corrected, .until = 0.1708};
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
  const EventRecorder events = recorded(scenario);
  const auto loss = std::ranges::find(events.events(), Event::mass_loss, &Instant::event);
  EXPECT_LT(needed_friction(scenario, events.before_mass_loss()), p.friction);
  EXPECT_GT(needed_friction(scenario, *loss), 1.01 * p.friction);
  ASSERT_NE(loss + 1, events.events().end());
  EXPECT_EQ((loss + 1)->event, Event::break_away);
  EXPECT_EQ((loss + 1)->time_s, loss->time_s);
  scenario.until = p.mass_loss_time + 1e-6;  // its digits are still known
  const auto found =
      compare(Precision::double_, scenario, 1e-10, [](double /*time_s*/) { return true; });
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->is_course_sure);
}

}  // namespace
}  // namespace rotor
