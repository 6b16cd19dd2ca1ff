/// Verner's pair: its order, and each digit of its coefficients.
#include "model/integration/verner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "model/digits/quad.hpp"

namespace rotor {
namespace {

TEST(Verner, StepsTheHarmonicOscillatorWithOrderEight) {
  using State2 = std::array<long double, 2>;
  const auto system = [](const State2& x, State2& rates, long double) { rates = {x[1], -x[0]}; };
  const auto error_after_one = [&](int steps) {
    Verner87<State2, long double> stepper;
    State2 x = {1, 0};
    for (int i = 0; i < steps; ++i) {
      State2 rates, errors;
      system(x, rates, 0);
      stepper.do_step(system, State2(x), rates, 0.L, x, 1.L / steps, errors);
    }
    return static_cast<double>(std::abs(x[0] - std::cos(1.L)) + std::abs(x[1] + std::sin(1.L)));
  };
  const double order = std::log2(error_after_one(4) / error_after_one(8));
  EXPECT_GT(order + 0.1, 8);
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
