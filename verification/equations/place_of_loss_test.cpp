/// The loss of a piece from any point of the rim.
#include "verification/support/place_of_loss.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "model/mechanics/mass_loss.hpp"
#include "model/simulation/start.hpp"
#include "model/simulation/summary.hpp"
#include "verification/support/follow.hpp"

namespace rotor {
namespace {

constexpr double pi = std::numbers::pi;

Instant moving() {
  Instant at = at_rest({});
  at.state = {-0.15e-3, 2e-5, 0.7, 0.02, -0.01, 942};
  return at;
}

TEST(PlaceOfLoss, OppositeToTheUnbalanceIsTheTexts) {
  const PlaceOfLoss place({}, 0);
  const MassLoss<double> loss{Parameters{}};
  EXPECT_EQ(place.after().mass, loss.after.mass);
  const double rounding = 1e-15;
  EXPECT_NEAR(place.after().eccentricity / loss.after.eccentricity, 1, rounding);
  EXPECT_NEAR(place.after().inertia / loss.after.inertia, 1, rounding);
  for (const Equations equations : {Equations::published, Equations::consistent}) {
    const State<double> found = place.separate(moving(), equations).state;
    const State<double> expected = loss.separate(moving().state, equations);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], expected[i], rounding) << i;
  }
}

TEST(PlaceOfLoss, KeepsEnergyMomentumAndAngularMomentumInTheConsistentEquationsWhereverItIs) {
  for (double angle = 0; angle < 2 * pi; angle += 0.3) {
    const PlaceOfLoss place({}, angle);
    const Instant at = moving(), left = place.separate(at, Equations::consistent);
    const Motion<double> before = at.motion(), after = left.motion();
    const double m_u = place.lost_mass(), turn = at.state[2], turn_after = left.state[2];
    // In the stator's axes, about O_a.
    const Vector<double> piece = in_stator_frame(before.displacement + place.piece(), turn);
    const Vector<double> piece_velocity =
        in_stator_frame(before.velocity + before.speed * quarter_turn(place.piece()), turn);
    const auto momentum = [](const Body<double>& body, const Motion<double>& m, double angle_now) {
      return Vector<double>(body.mass * in_stator_frame(m.mass_centre_velocity(), angle_now));
    };
    const auto angular = [](const Body<double>& body, const Motion<double>& m) {
      return body.inertia * m.speed + body.mass * cross(m.mass_centre(), m.mass_centre_velocity());
    };
    const Vector<double> gain = momentum(left.body, after, turn_after) + m_u * piece_velocity -
                                momentum(at.body, before, turn);
    EXPECT_LT(gain.norm(), 1e-14) << angle;  // of 1.4 N s
    EXPECT_NEAR(angular(left.body, after) + m_u * cross(piece, piece_velocity),
                angular(at.body, before), 1e-14)  // of 8.5 N m s
        << angle;
    EXPECT_NEAR(kinetic_energy(left.body, after) + m_u * piece_velocity.squaredNorm() / 2,
                kinetic_energy(at.body, before), 1e-11)  // of 4000 J
        << angle;
  }
}

TEST(PlaceOfLoss, LeavesOWhereItWasAndGivesItTheChangeOfTheMassCentresVelocityAsPrinted) {
  const PlaceOfLoss place({}, 2);
  const auto velocity = [&](Equations equations) {
    const Instant left = place.separate(moving(), equations);
    return in_stator_frame(left.motion().velocity, left.state[2]);
  };
  const Instant left = place.separate(moving(), Equations::published), at = moving();
  EXPECT_LT((in_stator_frame(left.motion().displacement, left.state[2]) -
             in_stator_frame(at.motion().displacement, at.state[2]))
                .norm(),
            1e-18);
  const double jump = MassLoss<double>(Parameters{}).velocity_jump(at.state[5]);
  const double gain = (velocity(Equations::published) - velocity(Equations::consistent)).norm();
  // |CD| is r + e_x only opposite to the unbalance, and r - e_x at least.
  EXPECT_LT(gain, jump);
  EXPECT_GT(gain, jump * (0.06 - 0.15e-3) / (0.06 + 0.15e-3));
}

Scenario at_operating_speed(Equations equations) {
  Scenario scenario{.equations = equations, .start_speed_Hz = 150, .until = 0.1};
  scenario.parameters.separation_time = 0;
  scenario.parameters.torque = 0;
  return scenario;
}

double lost_mass(const Scenario& scenario) {
  return MassLoss<double>(scenario.parameters).lost_mass;
}

/// Just after the loss of a piece at an angle from the x axis, on which the unbalance lies.
Instant lost_at(const Scenario& scenario, double lost_mass, double angle) {
  return PlaceOfLoss(scenario.parameters, angle - pi, lost_mass)
      .separate(start_of(scenario), scenario.equations);
}

// Without eccentricity and gravity all points are alike but for the direction.
TEST(PlaceOfLoss, OfABalancedRotorIsTheSameWherever) {
  Scenario scenario = at_operating_speed(Equations::published);
  const double m_u = lost_mass(scenario);
  scenario.parameters.eccentricity = scenario.parameters.gravity = 0;
  const auto peak = [&](double angle) {
    SummaryObserver summary(scenario);
    follow(scenario, lost_at(scenario, m_u, angle), scenario.until, summary);
    return summary.summary().peak_normal_force_N.value();
  };
  const double expected = peak(pi);
  EXPECT_GT(expected, 3e5);
  // Roundings of 1e-16 grow by some 1e6 over the contacts until rolling.
  for (const double angle : {0.5, 2., 5.}) EXPECT_NEAR(peak(angle) / expected, 1, 1e-8);
}

// The text's two sentences on the location. How far C moves hardly depends on it, so that whether
// the ring is touched does not; how far C then lies from O does.
TEST(PlaceOfLoss, MovesTheMassCentreAlikeButUnbalancesMostOpposite) {
  const Scenario scenario = at_operating_speed(Equations::consistent);
  const Parameters& p = scenario.parameters;
  const double m_u = lost_mass(scenario), most = p.unbalance_factor * p.eccentricity;
  const double opposite = m_u * (p.rotor_radius + p.eccentricity) / (p.mass - m_u);
  double last = most;
  for (int n = 0; n <= 16; ++n) {
    const double from_opposite = n * pi / 16;
    const Instant at = lost_at(scenario, m_u, pi - from_opposite);
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
