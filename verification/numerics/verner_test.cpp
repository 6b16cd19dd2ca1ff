/// Verner's pair in Odeint's own loops: its order and its error estimate; and each digit of its
/// coefficients.
#include "model/integration/verner.hpp"

#include <gtest/gtest.h>

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <cmath>
#include <limits>

#include "model/digits/quad.hpp"

namespace rotor {
namespace {

namespace odeint = boost::numeric::odeint;

/// x'' = -x.
template <class S>
void oscillate(const std::array<S, 2>& x, std::array<S, 2>& rates, S /*time*/) {
  rates = {x[1], -x[0]};
}

TEST(Verner, StepsTheHarmonicOscillatorWithOrderEight) {
  using State2 = std::array<long double, 2>;
  const auto error_after_one = [&](int steps) {
    State2 x = {1, 0};
    odeint::integrate_const(Verner87<State2, long double>(), oscillate<long double>, x, 0.L, 1.L,
                            1.L / steps);
    return static_cast<double>(std::abs(x[0] - std::cos(1.L)) + std::abs(x[1] + std::sin(1.L)));
  };
  const double order = std::log2(error_after_one(4) / error_after_one(8));
  EXPECT_GT(order + 0.1, 8);
}

// A rotation of x and x' does not amplify errors, which add up: each is at most the tolerance times
// 1 + |x| + h |x'|, by components.
TEST(Verner, KeepsToTheToleranceInOdeintsController) {
  using State2 = std::array<double, 2>;
  constexpr double until = 100;
  const auto steps_at = [&](double tolerance) {
    State2 x = {1, 0};
    const std::size_t steps = odeint::integrate_adaptive(
        odeint::make_controlled<Verner87<State2, double>>(tolerance, tolerance), oscillate<double>,
        x, 0., until, 0.01);
    const double error = std::hypot(x[0] - std::cos(until), x[1] + std::sin(until));
    EXPECT_LT(error, std::sqrt(2.) * tolerance * (2. * static_cast<double>(steps) + until));
    return static_cast<double>(steps);
  };
  // An error in proportion to the eighth power of a step's length.
  EXPECT_NEAR(std::log(1e6) / std::log(steps_at(1e-12) / steps_at(1e-6)), 8, 1);
}

// Why the engine has an error control of its own.
TEST(OdeintsController, AcceptsAStepThatIsNotFinite) {
  using State2 = std::array<double, 2>;
  auto stepper = odeint::make_controlled<Verner87<State2, double>>(1e-6, 1e-6);
  State2 x = {std::numeric_limits<double>::quiet_NaN(), 0};
  double time = 0, length = 0.01;
  EXPECT_EQ(stepper.try_step(oscillate<double>, x, time, length), odeint::success);
}

template <class A, class B>
Quad dot(const A& a, const B& b) {
  Quad sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Quadrature of the nodes' powers by the weights of both orders and by each stage, in quadruple
// precision, which tests every digit of a coefficient. Rounding is some 1e-34 of terms up to 120.
TEST(Verner, MeetsItsOrderConditionsToTheLastDigit) {
  using std::abs;
  const verner::Tableau<Quad> tableau;
  const auto &c = tableau.nodes, &b = tableau.rows[verner::weights],
             &e = tableau.rows[verner::error_weights];
  constexpr double rounding = 1e-30;
  std::array<std::array<Quad, 13>, 8> powers;
  for (std::size_t i = 0; i < 13; ++i) {
    powers[0][i] = 1;
    for (std::size_t k = 1; k < 8; ++k) powers[k][i] = powers[k - 1][i] * c[i];
  }
  const auto is_near = [&](const Quad& a, const Quad& exact) { return abs(a - exact) < rounding; };
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_TRUE(is_near(dot(b, powers[k]), Quad(1) / (k + 1))) << k;
    if (k < 7) {
      EXPECT_TRUE(is_near(dot(e, powers[k]), Quad(0))) << k;
    }
  }
  for (std::size_t stage = 1; stage < verner::stages; ++stage) {
    const auto& row = tableau.rows[stage - 1];
    // The first stages are of lower order, and are made up for.
    const std::size_t orders = stage < 2 ? 1 : stage < 3 ? 2 : stage < 5 ? 3 : 4;
    Quad power = 1;
    for (std::size_t k = 0; k < orders; ++k) {
      power *= c[stage];
      EXPECT_TRUE(is_near(dot(row, powers[k]), power / (k + 1))) << stage << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace rotor
