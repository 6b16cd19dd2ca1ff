/// The energy by cause: its sum, and single causes against closed forms.
#include "model/results/energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/mechanics/mass_loss.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/instant.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/law.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

EnergyBalance balance_of(const Scenario& scenario) {
  EnergyObserver energy(scenario);
  run(scenario, energy);
  return energy.balance();
}

TEST(EnergyByCause, AddsUpInEveryRub) {
  // Of a few thousand steps, each good to 1e-14 or so.
  Law law("energy by cause in every rub, of the initial energy", 1e-11);
  for (const Equations equations : {Equations::published, Equations::corrected})
    for (const double friction : {0.3, 0.2, 0.08, 0.}) {
      Scenario scenario{.parameters = {.friction = friction}, .equations = equations};
      scenario.tolerance = 1e-12;
      EnergyObserver energy(scenario);
      run(scenario, energy);
      const double initial = energy.balance().initial;
      law.expect_left(energy.balance().residual() / initial);
      if (energy.until_rolling()) law.expect_left(energy.until_rolling()->residual() / initial);
      EXPECT_LE(energy.balance().work.friction, 0);
      EXPECT_LE(energy.balance().work.contact_damping, 0);
      EXPECT_LT(energy.balance().work.of("support_damping"), 0);
      EXPECT_EQ(energy.balance().work.of("motor"), 0);  // off by then
      EXPECT_EQ(energy.balance().work.friction == 0, friction == 0);
    }
}

// The balance until rolling ends at the onset of rolling, whatever follows.
TEST(EnergyByCause, UntilRollingIsThatAtItsOnset) {
  const Scenario scenario;
  EnergyObserver energy(scenario);
  EventRecorder events;
  ObserverGroup both{&energy, &events};
  run(scenario, both);
  const Instant onset = events.first(Event::rolling_onset);
  ASSERT_EQ(events.last().contact, ContactState::rolling);
  ASSERT_TRUE(energy.until_rolling());
  EXPECT_DOUBLE_EQ(energy.until_rolling()->kinetic, kinetic_energy(onset.body, onset.motion()));
  EXPECT_LT(energy.balance().kinetic, 0.5 * energy.until_rolling()->kinetic);
}

// Once the motor is off, steps have many radians, and the quadrature divides them. Three thousand
// steps with errors of about 1e-12 J leave 3e-10 J.
TEST(EnergyByCause, AddsUpOverLongSteps) {
  Scenario scenario{.until = 40, .tolerance = 1e-12};
  scenario.parameters.loses_mass = false;
  const EnergyBalance energy = balance_of(scenario);
  EXPECT_GT(energy.work.of("motor"), 4000);
  EXPECT_LT(std::abs(energy.residual()), 1e-8);
}

// The piece leaves with the energy that it had, T of a point mass at r + e_x; the jump as printed
// adds m_1 times Delta_vy times the mean of the velocities before and after it.
TEST(EnergyByCause, OfTheMassLossIsThatOfThePieceAndOfTheExtraJump) {
  for (const Equations equations : {Equations::published, Equations::corrected}) {
    Scenario scenario{.equations = equations, .start_speed_Hz = 150, .until = 0.001};
    scenario.parameters.mass_loss_time = scenario.parameters.gravity = 0;
    const MassLoss<double> loss(scenario.parameters);
    const Instant start = start_of(scenario);
    const Motion<double> m = start.motion();
    const Vector<double> piece =
        m.velocity + m.speed * quarter_turn(Vector<double>(-scenario.parameters.rotor_radius, 0));
    const double leaves = loss.lost_mass * piece.squaredNorm() / 2;
    const double jump = loss.velocity_jump(m.speed);
    const double once = m.velocity.y() + m.speed * loss.after.eccentricity;
    const double comes =
        equations == Equations::published ? loss.after.mass * jump * (once + jump / 2) : 0;
    EXPECT_NEAR(balance_of(scenario).mass_loss, comes - leaves, 1e-9 * leaves);
  }
}

// Also in the ring's spring, if the rim has left the ring before it has sprung back.
TEST(EnergyByCause, AddsUpWhereTheRingIsStillIndented) {
  Scenario scenario = short_run(0.03);
  const EventRecorder events = recorded(scenario);
  const double from_s = events.first(Event::release).time_s;
  const auto after =
      std::ranges::find_if(events.events(), [&](const Instant& at) { return at.time_s > from_s; });
  ASSERT_NE(after, events.events().end());
  scenario.until = (from_s + after->time_s) / 2;
  const EventRecorder cut = recorded(scenario);
  ASSERT_EQ(cut.last().contact, ContactState::indented);
  const EnergyBalance energy = balance_of(scenario);
  EXPECT_GT(energy.contact_spring, 1e-3);
  EXPECT_LT(std::abs(energy.residual()), 1e-9);
}

}  // namespace
}  // namespace rotor
