/// Thinning of curves.
#include "figures/data/thinning.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rotor {
namespace {

TEST(Thinning, KeepsEveryColumnWithinItsTolerance) {
  Table full(3);
  for (int i = 0; i <= 20000; ++i) {
    const double t = i * 1e-4;
    full.add(t);
    full.add(std::sin(300 * t));
    full.add(i % 5000 == 777 ? 1 : std::cos(410 * t) / 2);  // impacts that last a single sample
  }
  constexpr double tolerance = 1e-3;
  const Table thin = thinned(full, tolerance);
  EXPECT_LT(thin.rows(), full.rows() / 3);
  std::size_t next = 1;
  for (std::size_t i = 0; i < full.rows(); ++i) {
    while (thin.row(next)[0] < full.row(i)[0]) ++next;
    const auto a = thin.row(next - 1), b = thin.row(next);
    const double part = (full.row(i)[0] - a[0]) / (b[0] - a[0]);
    for (const std::size_t column : {1U, 2U}) {
      const double range = column == 1 ? 2 : 1.5;
      EXPECT_NEAR(full.row(i)[column], a[column] + part * (b[column] - a[column]),
                  (1 + 1e-9) * tolerance * range);
    }
  }
}

TEST(Thinning, KeepsWhatIsBesideAGap) {
  Table full(2);
  for (int i = 0; i <= 100; ++i) {
    full.add(i);
    full.add(i < 50 ? std::numeric_limits<double>::quiet_NaN() : i * i);
  }
  const Table thin = thinned(full, 1e-3);
  EXPECT_GT(thin.rows(), 10U);
  EXPECT_TRUE(std::isnan(thin.row(0)[1]));
  EXPECT_EQ(thin.row(1)[0], 49);
  EXPECT_EQ(thin.row(2)[0], 50);
  EXPECT_EQ(thin.row(thin.rows() - 1)[1], 10000);
}

// Annotations quote them.
TEST(Thinning, KeepsTheEndsOfTheRangeOfWhatHasGapsToTheLastDigit) {
  Table full(2);
  for (int i = 0; i <= 100; ++i) {
    full.add(i);
    full.add(i == 0 ? std::numeric_limits<double>::quiet_NaN() : 1 + 1e-5 * std::cos(i / 10.));
  }
  const Table thin = thinned(full, 1);
  ASSERT_EQ(thin.rows(), 5U);  // of the gap, of the range and at the end
  EXPECT_EQ(thin.row(1)[0], 1);
  EXPECT_EQ(thin.row(2)[0], 63);
  EXPECT_EQ(thin.row(3)[0], 94);
  EXPECT_EQ(thin.row(4)[0], 100);
}

// The range is that of all rows, the first and the last one too.
TEST(Thinning, MeasuresBySpikesAtTheEndsToo) {
  for (const int spike : {0, 100}) {
    Table full(2);
    for (int i = 0; i <= 100; ++i) {
      full.add(i);
      full.add(i == spike ? 1000 : i % 2);
    }
    EXPECT_LT(thinned(full, 2e-3).rows(), 6U) << spike;
  }
}

}  // namespace
}  // namespace rotor
