/// A piece lost from any point of the rim, as the verification has it and the model does not.
#include <gtest/gtest.h>

#include <numbers>

#include "model/mechanics/mass_loss.hpp"
#include "model/simulation/summary.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/lost_elsewhere.hpp"

namespace rotor {
namespace {

Scenario at_operating_speed(Equations equations) {
  Scenario scenario{.equations = equations, .start_speed_Hz = 150, .until = 0.1};
  scenario.parameters.separation_time = 0;
  scenario.parameters.torque = 0;
  return scenario;
}

double lost_mass(const Scenario& scenario) {
  return MassLoss<double>(scenario.parameters).lost_mass;
}

TEST(LossElsewhere, IsThePapersLossAtThePapersPoint) {
  for (const Equations set : {Equations::published, Equations::consistent}) {
    const Scenario scenario = at_operating_speed(set);
    const MassLoss<double> loss(scenario.parameters);
    const State<double> expected = loss.separate(start_of(scenario).state, set);
    const Instant at = lost_elsewhere(scenario, loss.lost_mass, std::numbers::pi);
    EXPECT_NEAR(at.body.mass, loss.after.mass, 1e-15);
    EXPECT_NEAR(at.body.eccentricity, loss.after.eccentricity, 1e-17);
    EXPECT_NEAR(at.body.inertia, loss.after.inertia, 1e-17);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(at.state[i], expected[i], 1e-15) << i;
  }
}

// Put right, both parts together keep what they have, wherever the piece was.
TEST(LossElsewhere, KeepsMomentumAngularMomentumAndEnergyWithThePiece) {
  const Scenario scenario = at_operating_speed(Equations::consistent);
  const double m_u = lost_mass(scenario), r = scenario.parameters.rotor_radius;
  const Instant before = start_of(scenario);
  for (const double angle : {0., 1., 2.5, 4., 6.}) {
    const Instant after = lost_elsewhere(scenario, m_u, angle);
    const auto in_stator = [](const Instant& at, const Vector<double>& v) {
      return in_stator_frame(v, at.state[2]);
    };
    struct Totals {
      Vector<double> momentum;
      double angular, energy;
    };
    const auto of_body = [&](const Instant& at) -> Totals {
      const Motion<double> motion = at.motion();
      const Vector<double> p = at.body.mass * in_stator(at, motion.mass_centre_velocity());
      return {
          p, at.body.inertia * motion.speed + cross<double>(in_stator(at, motion.mass_centre()), p),
          kinetic_energy(at.body, motion)};
    };
    const Motion<double> motion = before.motion();
    const Vector<double> D(r * std::cos(angle), r * std::sin(angle));
    const Vector<double> v_D = motion.velocity + motion.speed * quarter_turn(D);
    const Totals whole = of_body(before), rest = of_body(after);
    EXPECT_LT((whole.momentum - rest.momentum - m_u * v_D).norm(), 1e-14) << angle;
    EXPECT_NEAR(rest.angular + m_u * cross<double>(motion.displacement + D, v_D), whole.angular,
                1e-14);
    EXPECT_NEAR(rest.energy + m_u * v_D.squaredNorm() / 2, whole.energy, 1e-11);  // of 4000 J
  }
}

// Without eccentricity and gravity all points are alike but for the direction.
TEST(LossElsewhere, OfABalancedRotorIsTheSameWherever) {
  Scenario scenario = at_operating_speed(Equations::published);
  const double m_u = lost_mass(scenario);
  scenario.parameters.eccentricity = scenario.parameters.gravity = 0;
  const auto peak = [&](double angle) {
    SummaryObserver summary(scenario);
    follow(scenario, lost_elsewhere(scenario, m_u, angle), scenario.until, summary);
    return summary.summary().peak_normal_force_N.value();
  };
  const double expected = peak(std::numbers::pi);
  EXPECT_GT(expected, 3e5);
  // Roundings of 1e-16 grow by some 1e6 over the contacts until rolling.
  for (const double angle : {0.5, 2., 5.}) EXPECT_NEAR(peak(angle) / expected, 1, 1e-8);
}

// The text's two sentences on the location. How far C moves hardly depends on it, so that whether
// the ring is touched does not; how far C then lies from O does.
TEST(LossElsewhere, MovesTheMassCentreAlikeButUnbalancesMostOpposite) {
  const Scenario scenario = at_operating_speed(Equations::consistent);
  const Parameters& p = scenario.parameters;
  const double m_u = lost_mass(scenario), most = p.unbalance_factor * p.eccentricity;
  const double opposite = m_u * (p.rotor_radius + p.eccentricity) / (p.mass - m_u);
  double last = most;
  for (int n = 0; n <= 16; ++n) {
    const double from_opposite = n * std::numbers::pi / 16;
    const Instant at = lost_elsewhere(scenario, m_u, std::numbers::pi - from_opposite);
    EXPECT_LE(at.body.eccentricity, last * (1 + 1e-15));  // falls all the way round
    last = at.body.eccentricity;
    // C from where it was: |C_1 - C|, C_1 at the angle of the new axis.
    const double shift = std::hypot(at.body.eccentricity * std::cos(at.state[2]) - p.eccentricity,
                                    at.body.eccentricity * std::sin(at.state[2]));
    EXPECT_NEAR(shift / opposite, 1, 2 * p.eccentricity / p.rotor_radius);
  }
  EXPECT_LT(last, p.eccentricity);  // on the side of the unbalance, the loss reduces it
}

}  // namespace
}  // namespace rotor
