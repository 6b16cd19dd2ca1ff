/// The points of a sweep: their order, and how they are drawn.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "figures/sweep/sweep.hpp"
#include "verification/support/in_folder.hpp"

namespace rotor {
namespace {

class SweepPointsOf : public InFolder {
 protected:
  Sweep sweep(const std::string& text) const {
    write("s.toml", text);
    return read_sweep(folder_ / "s.toml");
  }
};

TEST_F(SweepPointsOf, AFileComeInItsOrder) {
  const Sweep sweep = this->sweep(
      "[[axis]]\nquantity = \"friction\"\nfrom = 0.3\nto = 0.9\npoints = 4\n[[axis]]\nquantity = "
      "\"mass\"\nfrom = 1\nto = 100\npoints = 3\nspacing = \"log\"\n[sample]\ncount = 2\n"
      "[[sample.over]]\nquantity = \"torque\"\nuniform = [1, 2]\n");
  const SweepPoints points(sweep);
  ASSERT_EQ(sweep.points(), 24);
  for (long n = 0; n < 24; ++n) {
    const auto& numbers = points(n).statement.numbers;
    EXPECT_NEAR(numbers.at("friction"), 0.3 + 0.2 * static_cast<double>(n / 6), 1e-15);
    EXPECT_NEAR(numbers.at("mass"), std::pow(10, (n / 2) % 3), 1e-12);
    EXPECT_EQ(numbers.at("torque"), points(n % 2).statement.numbers.at("torque"));
  }
  EXPECT_EQ(points(23).values[0], "0.9");  // which 0.3 + (0.9 - 0.3) is not
}

/// The draws of a sample over two quantities.
std::vector<std::array<double, 2>> draws(const Sweep& sweep) {
  const SweepPoints points(sweep);
  std::vector<std::array<double, 2>> all;
  for (long n = 0; n < sweep.points(); ++n) {
    const auto& numbers = points(n).statement.numbers;
    all.push_back({numbers.at("friction"), numbers.at("torque")});
  }
  return all;
}

TEST_F(SweepPointsOf, ASampleAreEven) {
  const auto sampled = [&](const std::string& how) {
    return draws(sweep("[sample]\ncount = 1024\n" + how +
                       "[[sample.over]]\nquantity = \"friction\"\nuniform = [2, 3]\n"
                       "[[sample.over]]\nquantity = \"torque\"\nlog_uniform = [1, 100]\n"));
  };
  // Of 1024 points of Sobol's sequence one lies in each box of 1/1024 of the area.
  const auto boxes_filled = [](const auto& all, int columns) {
    std::set<std::pair<int, int>> boxes;
    for (const auto& [friction, torque] : all)
      boxes.emplace((friction - 2) * columns, std::log10(torque) / 2 * (1024. / columns));
    return boxes.size();
  };
  const auto sobol = sampled("seed = 5\n");
  for (const int columns : {1, 4, 32, 1024}) EXPECT_EQ(boxes_filled(sobol, columns), 1024U);
  // Each coordinate has a shift of its own, by which the origin has come off the diagonal.
  EXPECT_GT(std::abs(sobol[0][0] - 2 - std::log10(sobol[0][1]) / 2), 1e-3);
  EXPECT_NE(sobol, sampled("seed = 6\n"));
  EXPECT_EQ(sobol, sampled("seed = 5\n"));
  // Random ones leave 1/e of the boxes empty, and have the mean, the variance and the independence
  // of such, within four deviations.
  double mean = 0, variance = 0, covariance = 0;
  const auto random = sampled("method = \"random\"\nseed = 5\n");
  EXPECT_NEAR(static_cast<double>(boxes_filled(random, 32)), 1024 * (1 - std::exp(-1)),
              50);  // five deviations
  for (const auto& [friction, torque] : random) {
    const double x = friction - 2.5, y = std::log10(torque) / 2 - 0.5;
    mean += x / 1024;
    variance += x * x / 1024;
    covariance += x * y / 1024;
  }
  EXPECT_NEAR(mean, 0, 4 * std::sqrt(1 / 12. / 1024));
  EXPECT_NEAR(variance, 1 / 12., 4 * std::sqrt(1 / 180. / 1024));
  EXPECT_NEAR(covariance, 0, 4 / 12. / 32);
}

TEST_F(SweepPointsOf, ANormalDistributionAreSo) {
  const auto all = draws(
      sweep("[sample]\ncount = 4096\n[[sample.over]]\nquantity = \"friction\"\nnormal = [7, 0.5]\n"
            "[[sample.over]]\nquantity = \"torque\"\nuniform = [0, 1]\n"));
  double within = 0, below = 0;
  for (const auto& [friction, torque] : all) {
    within += std::abs(friction - 7) < 0.5;
    below += friction < 7 - 2 * 0.5;
  }
  EXPECT_NEAR(within / 4096, 0.682689, 1e-3);  // Sobol's sequence is that even
  EXPECT_NEAR(below / 4096, 0.022750, 1e-3);
}

}  // namespace
}  // namespace rotor
