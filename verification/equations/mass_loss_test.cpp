/// The mass loss, Eqs. (5)-(14): of any piece of the rim, and of the one opposite to the unbalance.
#include "model/mechanics/mass_loss.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "verification/support/place_of_loss.hpp"

namespace rotor {
namespace {

TEST(MassLoss, RaisesTheMassCentresVelocityByDeltaVyThroughEq1Alone) {
  const MassLoss<double> loss{Parameters{}};
  for (const double speed : {942., -10.}) {
    const State<double> x = {-0.15e-3, 0, 0, 0, 0, speed};
    const auto velocity = [](const Body<double>& body, const State<double>& state) {
      return RotatingFrame<double>::motion(body, state).mass_centre_velocity();
    };
    const auto before = velocity(loss.before, x);
    const auto corrected = velocity(loss.after, loss.lose_mass(x, Equations::corrected));
    const auto published = velocity(loss.after, loss.lose_mass(x, Equations::published));
    const double jump = loss.velocity_jump(942) * speed / 942;  // in the sense of rotation
    EXPECT_NEAR((corrected - before).y(), jump, 1e-15);
    EXPECT_NEAR((published - before).y(), 2 * jump, 1e-15);
  }
}

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
  for (const Equations equations : {Equations::published, Equations::corrected}) {
    const State<double> found = place.lose_mass(moving(), equations).state;
    const State<double> expected = loss.lose_mass(moving().state, equations);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(found[i], expected[i], rounding) << i;
  }
}

TEST(PlaceOfLoss, KeepsEnergyMomentumAndAngularMomentumInTheCorrectedEquationsWhereverItIs) {
  for (double angle = 0; angle < 2 * pi; angle += 0.3) {
    const PlaceOfLoss place({}, angle);
    const Instant at = moving(), left = place.lose_mass(at, Equations::corrected);
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

}  // namespace
}  // namespace rotor
