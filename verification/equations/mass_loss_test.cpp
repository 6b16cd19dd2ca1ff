/// The mass loss, Eqs. (5)-(14), at single instants.
#include "model/mechanics/mass_loss.hpp"

#include <gtest/gtest.h>

namespace rotor {
namespace {

TEST(MassLoss, GivesTheMassInertiaAndVelocitiesOfTheText) {
  const MassLoss<double> loss{Parameters{}};
  const double speed = 943;                               // as printed
  EXPECT_NEAR(loss.lost_mass, 0.0248, 0.00005);           // m_u, last digit printed
  EXPECT_NEAR(loss.after.inertia, 8.91e-3, 0.005e-3);     // I_C1
  EXPECT_NEAR(loss.piece_velocity(speed), 56.7, 0.05);    // v_DC
  EXPECT_NEAR(loss.velocity_jump(speed), 0.283, 0.0005);  // Delta_vy
}

TEST(MassLoss, LeavesRotorAndPieceTogetherTheirMassCentreAndInertia) {
  const MassLoss<double> loss{Parameters{}};
  const auto& [m, I_C, e] = loss.before;
  const auto& [m_1, I_C1, e_1] = loss.after;
  const double shift = e_1 - e, distance = loss.piece_distance;
  EXPECT_NEAR(m_1 + loss.lost_mass, m, 1e-15);
  EXPECT_NEAR(m_1 * shift, loss.lost_mass * distance, 1e-17);
  EXPECT_NEAR(I_C1 + m_1 * shift * shift + loss.lost_mass * distance * distance, I_C, 1e-17);
}

TEST(MassLoss, RaisesTheMassCentresVelocityByDeltaVyThroughEq1Alone) {
  const MassLoss<double> loss{Parameters{}};
  for (const double speed : {942., -10.}) {
    const State<double> x = {-0.15e-3, 0, 0, 0, 0, speed};
    const auto velocity = [](const Body<double>& body, const State<double>& state) {
      return RotatingFrame<double>::motion(body, state).mass_centre_velocity();
    };
    const auto before = velocity(loss.before, x);
    const auto consistent = velocity(loss.after, loss.separate(x, Equations::consistent));
    const auto published = velocity(loss.after, loss.separate(x, Equations::published));
    const double jump = loss.velocity_jump(942) * speed / 942;  // that way it turns
    EXPECT_NEAR((consistent - before).y(), jump, 1e-15);
    EXPECT_NEAR((published - before).y(), 2 * jump, 1e-15);
  }
}

}  // namespace
}  // namespace rotor
