/// The audit: where the paper contradicts itself, shown by measurement, in both sets of equations.
#include <gtest/gtest.h>

#include <boost/math/tools/roots.hpp>

#include "model/mechanics/mass_loss.hpp"
#include "model/scenario/instant.hpp"
#include "verification/paper/paper_runs.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/place_of_loss.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

TEST(Audit, TheGravityMomentAsPrintedDoesNotConserveTheEnergyOfAnUndampedUndrivenRotor) {
  const auto drift = [](Equations equations, bool potential_of_the_whole_weight) {
    Scenario scenario{.equations = equations, .until = 2, .tolerance = 1e-12};
    Parameters& p = scenario.parameters;
    p.support_damping = p.torque = 0;
    p.loses_mass = false;
    const auto energy = [&](const Instant& at) {
      const auto m = at.motion();
      const Vector<double> arm = potential_of_the_whole_weight ? m.mass_centre() : m.eccentricity;
      return kinetic_energy(at.body, m) + p.support_stiffness * m.displacement.squaredNorm() / 2 -
             p.mass * p.gravity * arm.dot(m.down);
    };
    Instant first = at_rest(p);
    first.state = {1e-3, 0, 0, 0, 0.02, 20};
    Observer null_observer;
    const Instant last = run(scenario, first, null_observer).last;
    return std::abs(energy(last) - energy(first)) / energy(first);
  };
  EXPECT_LT(drift(Equations::consistent, false), 1e-11);  // the integrator's accuracy
  EXPECT_GT(drift(Equations::published, false), 1e-4);
  EXPECT_GT(drift(Equations::published, true), 1e-4);
}

// By the turns of O about O_a in either frame, over the first 5 ms of rolling, in which the speed
// falls by 1 Hz.
TEST(Audit, InTheRotatingFrameTheWhirlHasTheFrequencyOfRollingPlusThatOfRotation) {
  PaperRuns runs{{}};
  const auto rolling = runs.high().first_5_ms().value();
  EXPECT_NEAR(rolling.whirl_Hz, 770, 770 * 0.01);
  EXPECT_NEAR(rolling.q1_Hz - rolling.whirl_Hz, in_Hz(runs.high().onset()->state[5]), 1);
}

TEST(Audit, ALossBeforeTheGreatestSwingTouchesTheRing) {
  for (const Equations equations : {Equations::published, Equations::consistent})
    for (const auto& [loss_s, touches] : {std::pair(2.0, true), {2.2, false}}) {  // as the text has
      const Scenario scenario{
          .parameters = {.mass_loss_time = loss_s}, .equations = equations, .until = 6};
      EXPECT_EQ(summary_of(scenario).touch_downs > 10, touches) << loss_s;
    }
}

// With F_n < 0 in contact, Eqs. (21) and (22) give a "magnitude" F_tau < 0, and the two sides of
// Eq. (24), F_tau c_y and -mu F_ny, differ in sign. Condition (23) then reverses whichever was
// taken.
TEST(Audit, TheFrictionOfEq22HasTheOppositeSignOfThatInEq24) {
  const Scenario scenario{.until = 29.11};
  EventRecorder seen;
  run(scenario, seen);
  const Instant& at = seen.first(Event::touch_down);
  const Ring<double> ring(scenario.parameters);
  const RimPoint<double> k = ring.rim_point(at.motion());
  const double f_n = ring.touching_force(k), mu = scenario.parameters.friction;
  ASSERT_LT(f_n, -1e3);
  const double f_tau = mu * f_n;                                           // Eq. (22)
  const Vector<double> c = k.normal, left(f_tau * c.y(), -f_tau * c.x()),  // Eq. (24)
      right(-mu * f_n * c.y(), mu * f_n * c.x());
  EXPECT_NEAR((left + right).norm(), 0, 1e-12 * right.norm());
  const Vector<double> slip = k.slip_velocity * k.tangent;
  EXPECT_GT(left.dot(slip), 0);   // drives the rim
  EXPECT_LT(right.dot(slip), 0);  // brakes it, as condition (23) asks for
}

/// The lowest speed at which the loss of the same piece leads to contact, from a point of the rim
/// at an angle from opposite to the unbalance.
double border_Hz(const Equations& equations, double angle) {
  const auto touches = [&](double speed_Hz) {
    Scenario scenario{.equations = equations, .start_speed_Hz = speed_Hz, .until = 0.1};
    scenario.parameters.torque = 0;
    Instant at =
        PlaceOfLoss(scenario.parameters, angle, MassLoss<double>(scenario.parameters).lost_mass)
            .lose_mass(start_of(scenario), equations);
    at.motor_on = false;
    SummaryObserver summary(scenario);
    follow(scenario, at, scenario.until, summary);
    return summary.summary().touch_downs > 0 ? 1. : -1.;
  };
  const auto close = [](double a, double b) { return b - a < 5e-3; };
  return boost::math::tools::bisect(touches, 40., 140., close).second;
}

TEST(Audit, ThePlaceOfTheLossMovesTheBorderOfContact) {
  for (const auto& [equations, least, greatest] :
       {std::tuple(Equations::published, 50.89, 54.84), {Equations::consistent, 94.27, 102.6}}) {
    std::vector<double> borders;
    for (int part = 0; part < 8; ++part) borders.push_back(border_Hz(equations, part * two_pi / 8));
    EXPECT_NEAR(std::ranges::min(borders), least, 0.05);
    EXPECT_NEAR(std::ranges::max(borders), greatest, 0.1);
  }
}

}  // namespace
}  // namespace rotor
