/// The map over the rounding of the inputs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "figures/data/csv.hpp"
#include "figures/sweep/sweep.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

const std::string maps = ROTOR_SOURCES "/figures/maps/";

TEST(MapOfRounding, DrawsWhatThePrintedDigitsAllow) {
  const Sweep sweep = read_sweep(maps + "rounding.toml");
  std::vector<Draw> expected;
  for (const CsvRow& row : read_csv(ROTOR_REFERENCE_DATA "/printed-inputs.csv")) {
    const std::string input = row["input"];
    const bool is_left_out = input == "gravity" || input == "torque" || input == "motor_off_hz" ||
                             input.starts_with("mu_") || input.starts_with("t_");
    if (!is_left_out)
      expected.push_back({input, Distribution::uniform, static_cast<double>(row.number("least")),
                          static_cast<double>(row.number("greatest"))});
  }
  ASSERT_EQ(sweep.sample.over.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(sweep.sample.over[i].quantity, expected[i].quantity);
    EXPECT_EQ(sweep.sample.over[i].a, expected[i].a) << expected[i].quantity;
    EXPECT_EQ(sweep.sample.over[i].b, expected[i].b) << expected[i].quantity;
  }
}

struct MapOfShares : CommandLine {};

TEST_F(MapOfShares, ShowsThemWithTheirErrors) {
  std::string rows = "# from\nequations_varied,friction,start_speed_hz,mass,outcome,refusal\n";
  int rolling = 0;  // of the four draws at each of eight points
  for (const char* equations : {"published", "consistent"})
    for (const double friction : {0.1, 0.2})
      for (const double speed : {3., 9.}) {
        for (int n = 0; n < 4; ++n)
          rows += fmt::format("{},{},{},{},{},\n", equations, friction, speed, n,
                              n < rolling  ? "rolling"
                              : n % 2 == 0 ? "sliding"
                                           : "freed");
        rolling = (rolling + 3) % 5;
      }
  write("r.csv", rows);
  ASSERT_EQ(shell("awk -f " + maps + "shares.awk r.csv > s.csv").status, 0);
  const auto shares = read_csv(folder_ / "s.csv");
  ASSERT_EQ(shares.size(), 8U);
  for (const auto& [n, share, error] :
       {std::tuple(0U, 0., 0.), {1U, 0.75, 0.216506}, {3U, 1., 0.}, {7U, 0.25, 0.216506}}) {
    EXPECT_EQ(shares[n].number("draws"), 4);
    EXPECT_EQ(shares[n].number("rolling_share"), share);
    EXPECT_NEAR(static_cast<double>(shares[n].number("standard_error")), error, 1e-6);  // as said
  }
}

}  // namespace
}  // namespace rotor
