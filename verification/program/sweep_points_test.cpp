/// The points of sweeps: their order and their draws.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "figures/data/read_csv.hpp"
#include "figures/sweep/sweep.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

class SweepPointsOf : public CommandLine {
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
    const SweepPoint point = points(n);  // with decimals, unlike 0.3 + 2 (0.9 - 0.3)/3
    EXPECT_EQ(point.values[0], fmt::format("{}", static_cast<double>(3 + 2 * (n / 6)) / 10));
    EXPECT_EQ(point.values[1], fmt::format("{}", std::pow(10, (n / 2) % 3)));
    EXPECT_EQ(point.spec.numbers.at("torque"), points(n % 2).spec.numbers.at("torque"));
  }
}

/// The draws of a sample over two quantities.
std::vector<std::array<double, 2>> draws(const Sweep& sweep) {
  const SweepPoints points(sweep);
  std::vector<std::array<double, 2>> all;
  for (long n = 0; n < sweep.points(); ++n) {
    const auto& numbers = points(n).spec.numbers;
    all.push_back({numbers.at("friction"), numbers.at("torque")});
  }
  return all;
}

// Of 1024 points of Sobol's sequence each box of 1/1024 of the area has one; random points leave
// 1/e of the boxes empty, within five deviations.
TEST_F(SweepPointsOf, ASampleAreEven) {
  const auto sampled = [&](const std::string& how) {
    return draws(sweep("[sample]\ncount = 1024\n" + how +
                       "[[sample.over]]\nquantity = \"friction\"\nuniform = [2, 3]\n"
                       "[[sample.over]]\nquantity = \"torque\"\nlog_uniform = [1, 100]\n"));
  };
  const auto boxes_filled = [](const auto& all, int columns) {
    std::set<std::pair<int, int>> boxes;
    for (const auto& [friction, torque] : all)
      boxes.emplace((friction - 2) * columns, std::log10(torque) / 2 * (1024. / columns));
    return static_cast<double>(boxes.size());
  };
  const auto sobol = sampled("seed = 5\n");
  for (const int columns : {1, 4, 32, 1024}) EXPECT_EQ(boxes_filled(sobol, columns), 1024);
  // Each coordinate has its own shift, so that the origin is no longer on the diagonal.
  EXPECT_GT(std::abs(sobol[0][0] - 2 - std::log10(sobol[0][1]) / 2), 1e-3);
  EXPECT_NE(sobol, sampled("seed = 6\n"));
  EXPECT_EQ(sobol, sampled("seed = 5\n"));
  const auto random = sampled("method = \"random\"\nseed = 5\n");
  for (const int columns : {1, 32, 1024})
    EXPECT_NEAR(boxes_filled(random, columns), 1024 * (1 - std::exp(-1)), 50) << columns;
}

TEST_F(SweepPointsOf, ANormalDistributionAreSo) {
  const auto all = draws(
      sweep("[sample]\ncount = 4096\n[[sample.over]]\nquantity = \"friction\"\nnormal = [7, 0.5]\n"
            "[[sample.over]]\nquantity = \"torque\"\nuniform = [0, 1]\n"));
  for (const double deviations : {-2., -1., 0.5, 1.}) {
    const auto below = std::ranges::count_if(
        all, [&](const auto& draw) { return draw[0] < 7 + 0.5 * deviations; });
    EXPECT_NEAR(static_cast<double>(below) / 4096, std::erfc(-deviations / std::sqrt(2.)) / 2,
                1e-3);
  }
}

// The map over the rounding of the inputs varies printed inputs within their digits.
TEST(MapOfRounding, DrawsWhatThePrintedDigitsAllow) {
  const Sweep sweep = read_sweep(ROTOR_SOURCES "/figures/maps/rounding.toml");
  std::map<std::string, std::pair<double, double>> printed;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/printed-inputs.csv"))
    printed[row["input"]] = {static_cast<double>(row.number("least")),
                             static_cast<double>(row.number("greatest"))};
  EXPECT_GT(sweep.sample.over.size(), 8U);
  for (const Draw& draw : sweep.sample.over)
    EXPECT_EQ((std::pair{draw.a, draw.b}), printed.at(draw.quantity)) << draw.quantity;
}

}  // namespace
}  // namespace rotor
