/// The search for events inside a step, on functions whose zeros are known; the interpolation it
/// searches on; the stepper.
#include "model/crossing.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "model/hermite.hpp"
#include "model/verner.hpp"

namespace rotor {
namespace {

constexpr double resolution = 1e-13;

/// Searches f between 0 and 1. `bend` bounds |f''| if given.
template <class F, class Slope>
std::optional<double> crossing(const F& f, const Slope& slope,
                               std::optional<double> bend = std::nullopt) {
  const auto at = [&](double t) { return Ordinate<double>{t, f(t), slope(t)}; };
  return first_crossing(at(0), at(1), resolution, bend, at);
}

TEST(Crossing, IsFoundOnTheFarSide) {
  const auto zero = crossing([](double t) { return std::cos(2 * t); },
                             [](double t) { return -2 * std::sin(2 * t); });
  ASSERT_TRUE(zero);
  EXPECT_LE(std::cos(2 * *zero), 0);
  EXPECT_NEAR(*zero, boost::math::constants::pi<double>() / 4, 2 * resolution);
}

TEST(Crossing, IsTheFirstOfSeveralInOneStep) {
  // Zeros at 0.2, 0.5 and 0.9.
  const auto f = [](double t) { return -(t - 0.2) * (t - 0.5) * (t - 0.9); };
  const auto slope = [](double t) {
    return -((t - 0.5) * (t - 0.9) + (t - 0.2) * (t - 0.9) + (t - 0.2) * (t - 0.5));
  };
  EXPECT_NEAR(crossing(f, slope).value_or(-1), 0.2, 2 * resolution);
}

TEST(Crossing, IsNotMissedHoweverShallowTheDip) {
  for (const double depth : {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto f = [&](double t) { return (t - 0.37) * (t - 0.37) - depth; };
    const auto slope = [](double t) { return 2 * (t - 0.37); };
    const auto zero = crossing(f, slope, 2.);
    ASSERT_TRUE(zero) << depth;
    EXPECT_NEAR(*zero, 0.37 - std::sqrt(depth), 1e-9) << depth;
    const auto above = [&](double t) { return (t - 0.37) * (t - 0.37) + depth; };
    EXPECT_FALSE(crossing(above, slope, 2.)) << depth;
  }
}

TEST(Crossing, IsFoundBetweenOscillationsByTheBoundOfTheCurvature) {
  // Below zero for a hundredth of the step, in the 7th of 16 oscillations; nothing shows at the
  // ends.
  const double k = 2 * boost::math::constants::pi<double>() * 16;
  const auto f = [&](double t) {
    return 1.02 + std::cos(k * t) - 0.1 * std::exp(-400 * (t - 0.41) * (t - 0.41));
  };
  const auto slope = [&](double t) {
    return -k * std::sin(k * t) + 80 * (t - 0.41) * std::exp(-400 * (t - 0.41) * (t - 0.41));
  };
  const auto zero = crossing(f, slope, k * k + 80);
  ASSERT_TRUE(zero);
  EXPECT_LE(f(*zero), 0);
  EXPECT_GT(f(*zero - 1e-6), 0);
  for (double t = 0; t < *zero - 1e-9; t += 1e-5) ASSERT_GE(f(t), 0) << t;
}

TEST(Crossing, DoesNotFireAgainWhereTheFunctionHasJustLeftZero) {
  EXPECT_FALSE(crossing([](double t) { return t; }, [](double) { return 1.; }));
  EXPECT_FALSE(crossing([](double t) { return t * t; }, [](double t) { return 2 * t; }));
}

TEST(Crossing, FiresAtOnceWhereTheFunctionFallsFromZero) {
  EXPECT_EQ(crossing([](double t) { return -t; }, [](double) { return -1.; }), 0);
}

TEST(Crossing, IsFoundAtTheVeryEndOfAStep) {
  const auto beyond = [](double t) { return 1 + 1e-15 - t; };
  EXPECT_FALSE(crossing(beyond, [](double) { return -1.; }));
  const auto before = [](double t) { return 1 - 1e-15 - t; };
  EXPECT_NEAR(crossing(before, [](double) { return -1.; }).value_or(0), 1, resolution);
}

TEST(HermitePolynomial, ReproducesAPolynomialOfItsDegree) {
  using Value = std::array<double, 1>;
  const auto f = [](double t) { return Value{std::pow(t, 7) - 3 * std::pow(t, 4) + t}; };
  const auto rate = [](double t) { return Value{7 * std::pow(t, 6) - 12 * std::pow(t, 3) + 1}; };
  using Polynomial = HermitePolynomial<double, Value, 4>;
  std::array<Polynomial::Node, 4> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double t = static_cast<double>(i) / 3;
    nodes[i] = {t, f(t), rate(t)};
  }
  const Polynomial polynomial(nodes);
  // Values of size 1, differences divided by steps of 1/3: some hundred roundings.
  for (double t = -0.1; t < 1.1; t += 0.03) EXPECT_NEAR(polynomial(t)[0], f(t)[0], 1e-13) << t;
}

TEST(Verner, StepsTheHarmonicOscillatorWithOrderEight) {
  using Quad =
      boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                    boost::multiprecision::et_off>;
  using State2 = std::array<Quad, 2>;
  const auto system = [](const State2& x, State2& rates, const Quad&) { rates = {x[1], -x[0]}; };
  const auto error_after_one = [&](int steps) {
    Verner87<State2, Quad> stepper;
    State2 x = {1, 0};
    for (int i = 0; i < steps; ++i) stepper.do_step(system, x, Quad(0), Quad(1) / steps);
    return static_cast<double>(abs(x[0] - cos(Quad(1))) + abs(x[1] + sin(Quad(1))));
  };
  const double order = std::log2(error_after_one(32) / error_after_one(64));
  EXPECT_GT(order + 0.1, 8);
}

}  // namespace
}  // namespace rotor
