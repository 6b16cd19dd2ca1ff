/// Eq. (3) against Lagrange's equation, whose derivatives of the kinetic energy of Eq. (2) come
/// from automatic differentiation instead of anybody's algebra.
#include <gtest/gtest.h>

#include <boost/math/differentiation/autodiff.hpp>
#include <random>

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

TEST_F(RandomMotion, HasTheKineticEnergyOfEqs1And2) {
  for (int trial = 0; trial < 100; ++trial) {
    const State<double> x = next_state();
    const double v_x = x[3] - x[5] * x[1];
    const double v_y = x[4] + x[5] * (x[0] + body_.eccentricity);
    const double T = body_.mass / 2 * (v_x * v_x + v_y * v_y) + body_.inertia / 2 * x[5] * x[5];
    EXPECT_NEAR(kinetic_energy(body_, RotatingFrame<double>::motion(body_, x)), T, 1e-14 * T);
  }
}

TEST_F(RandomMotion, CarriesTheSupportForcesOfEq4) {
  const Parameters p;
  const Supports<double> supports(p, Equations::published);
  for (int trial = 0; trial < 100; ++trial) {
    const State<double> x = next_state();
    const auto& [q1, q2, q3, q1_rate, q2_rate, w] = x;
    const auto Q = supports.loads(body_, RotatingFrame<double>::motion(body_, x), true);
    const double v_x = q1_rate - w * q2, v_y = q2_rate + w * q1;
    // As printed in Eq. (4); 1e-13 of the largest terms is what their rounding can make.
    EXPECT_NEAR(Q.force.x(), -p.support_damping * v_x - p.support_stiffness * q1, 1e-11);
    EXPECT_NEAR(Q.force.y(), -p.support_damping * v_y - p.support_stiffness * q2, 1e-11);
    EXPECT_NEAR(
        Q.moment,
        p.support_damping * v_x * q2 - p.support_damping * v_y * q1 -
            p.mass * p.gravity * ((q1 + p.eccentricity) * std::sin(q3) + q2 * std::cos(q3)) +
            p.torque,
        1e-13);
  }
}

TEST_F(RandomMotion, KeepsOnlyTheEccentricitysGravityMomentInTheConsistentEquations) {
  const Parameters p;
  const Supports<double> supports(p, Equations::consistent);
  for (int trial = 0; trial < 100; ++trial) {
    const auto motion = RotatingFrame<double>::motion(body_, next_state());
    const double sine = -motion.down.y();
    EXPECT_NEAR(supports.gravity_moment(body_, motion), -p.mass * p.gravity * p.eccentricity * sine,
                1e-17);  // a product of four numbers of size 1e-2
  }
}

}  // namespace
}  // namespace rotor
