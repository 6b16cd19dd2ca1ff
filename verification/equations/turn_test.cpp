/// Cosines and sines against those of the mathematical library.
#include "model/mechanics/turn.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace rotor {
namespace {

// The truncation error of the series is below rounding, which is that of three sums.
TEST(CosinesAndSines, AreThoseOfTheMathematicalLibrary) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> any(-2, 2);  // rad; beyond 1.5 the library is used
  constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
  for (int n = 0; n < 100000; ++n) {
    const std::array<double, 2> angle = {any(engine), std::ldexp(any(engine), -n % 30)};
    const auto [cosine, sine] = cosines_and_sines(angle[0], angle[1]);
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_NEAR(cosine[i], std::cos(angle[i]), rounding) << angle[i];
      ASSERT_NEAR(sine[i] / std::sin(angle[i]), 1, rounding) << angle[i];
    }
  }
}

// Near a zero the error is absolute: that of a quarter turn is less than 1e-20 rad.
TEST(UnitVectors, AreThoseOfTheMathematicalLibrary) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> any(-1100, 1100);  // rad; beyond 1000 the library is used
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  for (int n = 0; n < 100000; ++n) {
    const double angle = n % 2 == 0 ? any(engine) : n % 1000 * std::acos(0.);
    const Vector<double> vector = unit_vector(angle);
    ASSERT_NEAR(vector.x(), std::cos(angle), rounding * (std::abs(std::cos(angle)) + 1e-4))
        << angle;
    ASSERT_NEAR(vector.y(), std::sin(angle), rounding * (std::abs(std::sin(angle)) + 1e-4))
        << angle;
  }
}

}  // namespace
}  // namespace rotor
