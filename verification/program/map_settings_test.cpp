/// What the maps are of: the paper's rotor, about the paper's inputs; and over their rounding.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <variant>

#include "figures/data/csv.hpp"
#include "figures/sweep/sweep.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

const std::string maps = ROTOR_SOURCES "/figures/maps/";

using Texts = std::vector<std::string>;

class MapSettings : public testing::TestWithParam<const char*> {};

TEST_P(MapSettings, AreThePapersButForWhatTheAxesSpan) {
  Scenario expected{.start_speed_Hz = Parameters().motor_off_Hz,
                    .until = 0.5};  // the operating speed
  expected.parameters.torque = 0;
  expected.parameters.separation_time = 0;
  Sweep sweep = read_sweep(maps + GetParam() + ".toml");
  sweep.sample = {};
  const SweepPoints points(sweep);
  const Scenario first = scenario_of(points(0).statement),
                 last = scenario_of(points(sweep.points() - 1).statement);
  const auto varied = sweep.quantities();
  for (const Quantity& quantity : quantities()) {
    const bool is_radius = quantity.name == "stator_radius";
    const bool varies = std::ranges::count(varied, is_radius ? "clearance" : quantity.name) > 0;
    const double value = quantity.of(expected);
    const auto [least, greatest] = std::minmax({quantity.of(first), quantity.of(last)});
    EXPECT_LE(least, value) << quantity.name;
    EXPECT_GE(greatest, value) << quantity.name;
    EXPECT_EQ(least < greatest, varies) << quantity.name;
  }
  EXPECT_EQ(first.equations, Equations::published);
  EXPECT_EQ(last.equations, Equations::consistent);
  EXPECT_EQ(sweep.stop_on, StopOn::outcome);
}

INSTANTIATE_TEST_SUITE_P(Five, MapSettings,
                         testing::Values("speed-friction", "speed-clearance", "clearance-stiffness",
                                         "contact", "rounding"),
                         [](const auto& map) {
                           return std::regex_replace(map.param, std::regex("-"), "_");
                         });

// As far as the maps have been looked at: soft and hard contacts, slow and fast rotors.
TEST_P(MapSettings, SpanWhatTheyAreMeantTo) {
  const std::map<std::string, std::pair<double, double>> ends = {
      {"friction", {0, 0.5}},          {"start_speed_hz", {3, 180}},
      {"clearance", {0.25e-3, 6e-3}},  {"support_stiffness", {2e3, 1e7}},
      {"contact_damping", {1e2, 1e6}}, {"contact_stiffness", {1e7, 1e11}}};
  int ranges = 0;
  for (const Axis& axis : read_sweep(maps + GetParam() + ".toml").axes)
    if (const auto* const range = std::get_if<Range>(&axis.values)) {
      EXPECT_EQ(std::pair(range->from, range->until), ends.at(axis.quantity)) << axis.quantity;
      EXPECT_EQ(range->logarithmic, range->until / range->from > 100 && range->from > 0);
      ++ranges;
    }
  EXPECT_EQ(ranges, 2);
}

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

/// The colours of an image's cells, panel by panel, as SVG has them.
Texts cells(const std::string& svg) {
  Texts all;
  const std::regex cell("fill = 'rgb\\(([^)]*)\\)' points = '([0-9.]+),[0-9.]+ ([0-9.]+),");
  for (std::sregex_iterator found(svg.begin(), svg.end(), cell), none; found != none; ++found)
    if (std::stod((*found)[3]) - std::stod((*found)[2]) > 50) all.push_back((*found)[1]);  // no key
  return all;
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
  // Whose cells are drawn one by one, for once, so that their colours can be read.
  const auto [status, output] =
      shell(fmt::format("sed 's/with image/& pixels/' {}rounding.gp > r.gp; "
                        "{}/figures/draw.sh s.svg \"data='s.csv'\" r.gp >/dev/null",
                        maps, ROTOR_SOURCES));
  EXPECT_EQ(output, "");
  // Two of speed by two of friction in each panel, the shares above their errors.
  EXPECT_EQ(cells(content("s.svg")),
            Texts({"244, 244, 244", "228, 147,  80", "243, 223, 202", "213,  94,   0",  //
                   "243, 201, 160", "244, 244, 244", "228, 147,  80", "243, 223, 202",  //
                   "255, 255, 255", "112, 112, 112", "112, 112, 112", "255, 255, 255",  //
                   "112, 112, 112", "255, 255, 255", "112, 112, 112", "112, 112, 112"}));
  const DrawnPicture picture(content("s.svg"));
  EXPECT_EQ(picture.clipped, Texts());
  Texts panels = picture.texts;  // twice, shares above errors
  std::erase_if(panels, [](const std::string& text) { return !text.ends_with(" equations"); });
  EXPECT_EQ(panels, Texts({"published equations", "consistent equations", "published equations",
                           "consistent equations"}));
  // The colours of errors go to 0.05, which is that of a half among a hundred draws.
  for (const char* said : {"4 draws at each point", "standard error of the share", ">0.05<"})
    EXPECT_NE(content("s.svg").find(said), std::string::npos) << said;
  EXPECT_EQ(content("s.svg").find(">0.06<"), std::string::npos);
}

}  // namespace
}  // namespace rotor
