/// Cosines and sines of small angles against those of the mathematical library.
#include "model/mechanics/turn.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace rotor {
namespace {

// The truncation error of the series is below rounding, which is that of three sums.
TEST(Turns, AreThoseOfTheMathematicalLibrary) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> any(-2, 2);  // rad; beyond 1.5 the library is used
  constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
  for (int n = 0; n < 100000; ++n) {
    const std::array<double, 2> angle = {any(engine), std::ldexp(any(engine), -n % 30)};
    const auto [cosine, sine] = turns(angle[0], angle[1]);
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_NEAR(cosine[i], std::cos(angle[i]), rounding) << angle[i];
      ASSERT_NEAR(sine[i] / std::sin(angle[i]), 1, rounding) << angle[i];
    }
  }
}

}  // namespace
}  // namespace rotor
