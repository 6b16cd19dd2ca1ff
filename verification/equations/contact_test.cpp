/// The contact law, Eqs. (15)-(25), at single instants.
#include "model/mechanics/contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/mechanics/rotating_frame.hpp"

namespace rotor {
namespace {

class Contact : public testing::Test {
 protected:
  /// A motion with O at `rho` along the direction `angle`, moving outwards with `outwards`.
  Motion<double> motion(double rho, double angle, double outwards, double speed = 900) const {
    State<double> x = {rho * std::cos(angle),      rho * std::sin(angle),      0.3,
                       outwards * std::cos(angle), outwards * std::sin(angle), speed};
    return RotatingFrame<double>::motion(body_, x);
  }

  Parameters parameters_;
  Body<double> body_ = Body<double>::of(parameters_);
  Ring<double> ring_{parameters_};
};

TEST_F(Contact, PressesWithSpringAndDashpotUntilTheDashpotEndsIt) {
  const auto force = [&](double rho, double outwards) {
    return ring_.normal_force(ring_.rim_point(motion(rho, 1, outwards)));
  };
  EXPECT_TRUE(ring_.is_clear_of(motion(2.9e-3, 1, 5)));
  EXPECT_EQ(force(2.9e-3, 5), 0);
  // Eq. (21), negative in compression; 8e8 N/m times the rounding of 63 mm - 60 mm.
  EXPECT_NEAR(force(3.1e-3, 2), -(8e8 * 0.1e-3 + 1e4 * 2), 1e-7);
  // k_t Delta = 80 kN is outweighed by d_t Delta' = -90 kN before the ring has sprung back.
  EXPECT_EQ(force(3.1e-3, -9), 0);
}

TEST_F(Contact, SlipsWithTheRimVelocityOfEq19) {
  const State<double> x = {2e-3, -2.4e-3, 0.3, 3, -5, 700};
  const auto k = ring_.rim_point(RotatingFrame<double>::motion(body_, x));
  const double rho = std::hypot(x[0], x[1]), c_x = x[0] / rho, c_y = x[1] / rho;
  const double contact_radius = parameters_.rotor_radius + rho;  // r_a + Delta
  EXPECT_NEAR(k.slip_velocity, x[5] * contact_radius + x[4] * c_x - x[3] * c_y, 1e-13);
  EXPECT_NEAR(k.normal_velocity, x[4] * c_y + x[3] * c_x, 1e-14);
}

TEST_F(Contact, PutsFrictionAgainstTheSlipWithTheComponentsAndMomentOfEqs24And25) {
  for (const double speed : {900., -900.}) {
    const auto at = motion(3.1e-3, 2.2, 1, speed);
    const auto k = ring_.rim_point(at);
    const int direction = k.slip_velocity > 0 ? 1 : -1;
    const double F_n = ring_.normal_force(k);
    const auto Q = ring_.loads(k, {F_n, ring_.sliding_friction(F_n, direction)});
    const double c_x = std::cos(2.2), c_y = std::sin(2.2), mu = parameters_.friction;
    const double F_tx = direction * -mu * F_n * c_y, F_ty = direction * mu * F_n * c_x;  // Eq. (24)
    const double arm = parameters_.rotor_radius + k.displacement;
    const double rounding = 1e-14 * -F_n;
    EXPECT_NEAR(Q.force.x(), F_n * c_x + F_tx, 10 * rounding);
    EXPECT_NEAR(Q.force.y(), F_n * c_y + F_ty, 10 * rounding);
    EXPECT_NEAR(Q.moment, F_ty * arm * c_x - F_tx * arm * c_y, rounding);        // Eq. (25)
    EXPECT_LT(F_tx * -k.slip_velocity * c_y + F_ty * k.slip_velocity * c_x, 0);  // Eq. (23)
  }
}

TEST_F(Contact, ChangesTheSlipByItsMobilityTimesTheFriction) {
  const auto at = motion(3.1e-3, 2.2, 1);
  const auto k = ring_.rim_point(at);
  const double r = ring_.rotor_radius;
  const auto mobility = friction_mobility(body_, at, k, r);
  const auto slip = [&](double friction) {  // rate of v_Ktau under F_n and friction
    return slip_acceleration(at, k, acceleration(body_, at, ring_.loads(k, {-1e5, friction})), r);
  };
  EXPECT_NEAR(slip(1e4) - slip(0), 1e4 * slip_mobility(at, k, mobility, r),
              1e-9);  // 1e-13 of 6 km/s^2
}

TEST_F(Contact, KeepsTheSlipAsItIsByTheFrictionOfRolling) {
  const auto at = motion(3.1e-3, 2.2, 1);
  const auto k = ring_.rim_point(at);
  const double r = ring_.rotor_radius;
  const auto mobility = friction_mobility(body_, at, k, r);
  const auto without = acceleration(body_, at, ring_.loads(k, {-1e5, 0}));
  const double friction = friction_without_slip(at, k, without, mobility, r);
  EXPECT_NE(friction, 0);
  // The slip velocity a little later, from positions and velocities moved on by their rates.
  const auto a = acceleration(body_, at, ring_.loads(k, {-1e5, friction}));
  const double dt = 1e-8;
  Motion<double> later = at;
  later.displacement += dt * at.velocity;
  later.velocity += dt * acceleration_of_centre(a, at);
  later.speed += dt * a.angular;
  // Second order: slip'' dt^2 with slip'' of some 1e8 m/s^3.
  EXPECT_NEAR(ring_.rim_point(later).slip_velocity, k.slip_velocity, 1e-7);
}

}  // namespace
}  // namespace rotor
