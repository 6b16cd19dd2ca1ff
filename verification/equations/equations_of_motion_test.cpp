/// Eqs. (3), (4) and (15)-(25) against Lagrange's equation, with derivatives of the kinetic energy
/// of Eq. (2) by automatic differentiation, and against Newton's laws, written independently of the
/// model in verification/support.
#include <gtest/gtest.h>

#include <boost/math/differentiation/autodiff.hpp>
#include <random>

#include "model/mechanics/contact.hpp"
#include "model/mechanics/rotating_frame.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/newton.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/random_inputs.hpp"
#include "verification/support/summary_of.hpp"

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

TEST(NewtonsLaws, GiveTheSameAccelerationsInTheStatorsFrame) {
  RandomInputs random(3);
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const Scenario scenario = random.scenario();
    const Parameters& p = scenario.parameters;
    const double w = 1000 * draw(engine), angle = 10 * draw(engine),
                 reach = 1.1 * (p.stator_radius - p.rotor_radius);
    const State<double> q = {reach * draw(engine), reach * draw(engine), angle,
                             10 * draw(engine),    10 * draw(engine),    w};
    const NewtonLaws laws{p, scenario.equations.gravity_moment, Body<double>::of(p), true};
    const Newton x = in_stator_axes(q);
    const NewtonRim rim = laws.rim(x);
    const double pressure = rim.indentation <= 0 ? 0 : std::max(0., laws.pressure(rim));
    const double friction = (rim.slip > 0 ? -1 : 1) * p.friction * pressure;
    const Newton rates = laws.rates(x, rim, pressure, friction);

    const Body<double> body = Body<double>::of(p);
    const ActingLoads<double> acting(p, scenario.equations);
    const Ring<double> ring(p);
    const auto m = RotatingFrame<double>::motion(body, q);
    auto loads = acting.loads(body, m, true);
    const auto k = ring.rim_point(m);
    const double normal = ring.normal_force(k);
    loads += ring.loads(k, {normal, ring.sliding_friction(normal, k.slip_velocity > 0 ? 1 : -1)});
    const auto a = acceleration(body, m, loads);
    const Vector<double> of_O = in_stator_frame(acceleration_of_centre(a, m), angle);
    // Rounding of the largest terms, that of rho in the stiff spring among them.
    const double rest = std::hypot(p.ring_offset_x, p.ring_offset_y);
    const double stiffness = rim.indentation > 0 ? ring.law.tangent_stiffness(rim.indentation) : 0;
    const double force =
        pressure * (1 + p.friction) + stiffness * rim.rho + p.support_stiffness * (rim.rho + rest) +
        10 * p.support_damping * (1 + w * w) + p.mass * (w * w * rim.rho + p.gravity);
    const double accuracy = 1e-14 * force / p.mass,
                 angular = 1e-14 * (force * (p.rotor_radius + rim.rho) + p.torque) / p.inertia;
    EXPECT_NEAR(of_O.x(), rates[3], accuracy + angular * p.eccentricity);
    EXPECT_NEAR(of_O.y(), rates[4], accuracy + angular * p.eccentricity);
    EXPECT_NEAR(a.angular, rates[5], angular);
  }
}

// Which the equations as printed would make slip, and roll again.
TEST(NewtonsLaws, RestartNoRollingAtALossOfNoMass) {
  const Scenario scenario{.parameters = {.unbalance_factor = 1, .mass_loss_time = 0.04},
                          .start_speed_Hz = 100,
                          .start = Start{3.02e-3, 0, 0, -5},
                          .until = 0.05};
  EventRecorder ours, newtons;
  run(scenario, ours);
  ASSERT_TRUE(run_by_newton(scenario, {1e-12, 12, 100'000}, newtons));
  for (const EventRecorder* const recorded : {&ours, &newtons}) {
    EXPECT_EQ(recorded->before_mass_loss().contact, ContactState::rolling);
    EXPECT_EQ(recorded->events().back().event, Event::mass_loss);
  }
  SummaryObserver whirls(scenario);
  run_by_newton(scenario, {1e-12, 12, 100'000}, whirls);
  EXPECT_NEAR(*whirls.summary().whirl_frequency_Hz / *summary_of(scenario).whirl_frequency_Hz, 1,
              1e-6);
}

}  // namespace
}  // namespace rotor
