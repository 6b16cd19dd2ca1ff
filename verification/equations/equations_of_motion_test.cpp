/// Eqs. (3), (4) and (15)-(25) against Lagrange's equation, with derivatives of the kinetic energy
/// of Eq. (2) by automatic differentiation, and against Newton's laws, written independently of the
/// model.
#include <gtest/gtest.h>

#include <boost/math/differentiation/autodiff.hpp>
#include <random>

#include "model/mechanics/contact.hpp"
#include "model/mechanics/rotating_frame.hpp"

namespace rotor {
namespace {

namespace ad = boost::math::differentiation;

/// Derivatives of T, which does not depend on q3. x = q1 q2 q3 q1' q2' q3'.
struct EnergyDerivatives {
  std::array<double, 6> first{};                  ///< dT/dx_i
  std::array<std::array<double, 6>, 6> second{};  ///< d2T/dx_i dx_j
};

EnergyDerivatives differentiate(const Body<double>& body, const State<double>& x) {
  const auto variables = ad::make_ftuple<double, 2, 2, 2, 2, 2>(x[0], x[1], x[3], x[4], x[5]);
  const auto& [q1, q2, q1_rate, q2_rate, speed] = variables;
  const auto v_x = q1_rate - speed * q2;                        // Eq. (1)
  const auto v_y = q2_rate + speed * (q1 + body.eccentricity);  // Eq. (1)
  const auto T = 0.5 * body.mass * (v_x * v_x + v_y * v_y) + 0.5 * body.inertia * speed * speed;

  const std::array<std::size_t, 5> index = {0, 1, 3, 4, 5};
  const auto derivative = [&T](std::array<std::size_t, 5> order) {
    return T.derivative(order[0], order[1], order[2], order[3], order[4]);
  };
  EnergyDerivatives result;
  for (std::size_t i = 0; i < 5; ++i) {
    std::array<std::size_t, 5> order{};
    order[i] = 1;
    result.first[index[i]] = derivative(order);
    for (std::size_t j = 0; j < 5; ++j) {
      auto both = order;
      ++both[j];
      result.second[index[i]][index[j]] = derivative(both);
    }
  }
  return result;
}

class RandomMotion : public testing::Test {
 protected:
  /// Values of the sizes that occur in the rub.
  State<double> next_state() {
    return {3e-3 * unit(), 3e-3 * unit(), 10 * unit(), 10 * unit(), 10 * unit(), 900 * unit()};
  }
  double unit() { return distribution_(generator_); }

  Body<double> body_ = Body<double>::of(Parameters{});

 private:
  std::mt19937 generator_{20061};
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

TEST_F(RandomMotion, ObeysLagrangesEquationForEveryGeneralisedForce) {
  for (int trial = 0; trial < 100; ++trial) {
    const State<double> x = next_state();
    const Loads<double> Q = {{1e4 * unit(), 1e4 * unit()}, 1e2 * unit()};
    const auto motion = RotatingFrame<double>::motion(body_, x);
    const auto rates = RotatingFrame<double>::rates(motion, x, acceleration(body_, motion, Q));
    const EnergyDerivatives T = differentiate(body_, x);
    const std::array<double, 3> force = {Q.force.x(), Q.force.y(), Q.moment};
    for (std::size_t i = 0; i < 3; ++i) {
      // d/dt (dT/dq_i') - dT/dq_i, by the chain rule along the rates.
      double left = -T.first[i], size = std::abs(left);
      for (std::size_t j = 0; j < 6; ++j) {
        const double term = T.second[i + 3][j] * rates[j];
        left += term;
        size += std::abs(term);
      }
      EXPECT_NEAR(left, force[i], 1e-14 * size) << "i = " << i + 1;  // 20 products, each rounded
    }
  }
}

// Newton's laws in the stator's frame, written independently: O at (x, y), mass centre C at
// distance e in the direction of the angle, x downwards.
TEST(NewtonsLaws, GiveTheSameAccelerationsInTheStatorsFrame) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const Parameters p;
    const Equations equations = n % 2 == 0 ? Equations::published : Equations::consistent;
    const double w = 1000 * draw(random), angle = 10 * draw(random);
    const State<double> q = {3.3e-3 * draw(random), 3.3e-3 * draw(random), angle,
                             10 * draw(random),     10 * draw(random),     w};
    const double c = std::cos(angle), s = std::sin(angle);

    // Position and velocity of O in the stator's frame.
    const double x = c * q[0] - s * q[1], y = s * q[0] + c * q[1];
    const double vx = c * q[3] - s * q[4] - w * y, vy = s * q[3] + c * q[4] + w * x;
    const double rho = std::hypot(x, y), delta = rho + p.rotor_radius - p.stator_radius;
    const double nx = x / rho, ny = y / rho, rate = vx * nx + vy * ny;
    const double slip = -vx * ny + vy * nx + p.rotor_radius * w;
    double pressure = p.contact_stiffness * delta + p.contact_damping * rate;
    if (delta <= 0 || pressure < 0) pressure = 0;
    const double friction = (slip > 0 ? -1 : 1) * p.friction * pressure;

    const double fx =
        -p.support_stiffness * x - p.support_damping * vx - pressure * nx - friction * ny;
    const double fy =
        -p.support_stiffness * y - p.support_damping * vy - pressure * ny + friction * nx;
    const double ex = p.eccentricity * c, ey = p.eccentricity * s;
    // Moments about C: supports and F_n act at O, friction at K.
    const double kx = p.rotor_radius * nx - ex, ky = p.rotor_radius * ny - ey;
    double moment = p.torque;
    const double sx = fx + friction * ny, sy = fy - friction * nx;  // all but friction
    moment += -ex * sy + ey * sx + kx * friction * nx + ky * friction * ny;
    // Gravity's moment about O_a: of the whole weight as printed, of C's offset if balanced.
    moment += -p.mass * p.gravity * (equations == Equations::published ? y + ey : ey);
    const double angular = moment / p.inertia;
    // C's acceleration is that of O with the turn about it.
    const double ox = fx / p.mass + angular * ey + w * w * ex;
    const double oy = fy / p.mass - angular * ex + w * w * ey;

    const Body<double> body = Body<double>::of(p);
    const Supports<double> supports(p, equations);
    const Ring<double> ring(p);
    const auto m = RotatingFrame<double>::motion(body, q);
    auto loads = supports.loads(body, m, true);
    const auto k = ring.rim_point(m);
    const double normal = ring.normal_force(k);
    loads += ring.loads(k, {normal, ring.sliding_friction(normal, k.slip_velocity > 0 ? 1 : -1)});
    const auto a = acceleration(body, m, loads);
    const Vector<double> of_O = in_stator_frame(acceleration_of_centre(a, m), angle);
    // Rounding of the largest term, and that of rho in the stiff spring: 8e8 N/m of 1e-18 m.
    const double accuracy = 1e-12 * (1 + std::abs(ox) + std::abs(oy) + pressure / p.mass) + 5e-9;
    EXPECT_NEAR(of_O.x(), ox, accuracy);
    EXPECT_NEAR(of_O.y(), oy, accuracy);
    EXPECT_NEAR(a.angular, angular, 1e-12 * std::abs(angular) + 100 * accuracy);
  }
}

}  // namespace
}  // namespace rotor
