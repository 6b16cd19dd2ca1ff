/// The loss of a piece from any point of the rim.
#include "verification/paper/place_of_loss.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "model/mechanics/mass_loss.hpp"

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

}  // namespace
}  // namespace rotor
