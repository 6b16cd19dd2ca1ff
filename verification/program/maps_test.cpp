/// The maps of `make maps`, coarse: their points are those of `rotor run`; closed forms; pictures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <regex>

#include "figures/data/csv.hpp"
#include "figures/scenes/names.hpp"
#include "figures/sweep/sweep_row.hpp"
#include "model/theory/accident.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

const std::string maps = ROTOR_SOURCES "/figures/maps/";

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Maps : CommandLine, testing::WithParamInterface<const char*> {
 protected:
  /// The map with so many points along each axis, as FILE.toml in the folder.
  Sweep coarse(const std::string& map, int points) const {
    const std::string whole = text_of(maps + map + ".toml");
    EXPECT_NE(whole.find("\npoints = 400\n"), std::string::npos);
    write(map + ".toml", std::regex_replace(whole, std::regex("\npoints = 400\n"),
                                            fmt::format("\npoints = {}\n", points)));
    return read_sweep(folder_ / (map + ".toml"));
  }

  /// What `rotor run` is told of a point.
  static std::string options_of(const SweepPoint& point) {
    std::string options = "--stop-on outcome";
    const auto add = [&](std::string name, const std::string& value) {
      std::replace(name.begin(), name.end(), '_', '-');
      options += fmt::format(" --{} {}", name, value);
    };
    for (const auto& [name, number] : point.statement.numbers) add(name, fmt::format("{}", number));
    add("equations", std::string(name_of(point.statement.equations.value())));
    return options;
  }
};

TEST_P(Maps, HaveTheRowsThatRunsOfTheirOwnGive) {
  const Sweep sweep = coarse(GetParam(), 40);
  const SweepPoints points(sweep);
  SweepRows rows(sweep);
  std::mt19937_64 lot(1);
  for (int drawn = 0; drawn < 8; ++drawn) {
    const long n = static_cast<long>(lot() % static_cast<unsigned long>(sweep.points()));
    write("row.csv", sweep_head(sweep) + rows(n));
    const CsvRow row = read_csv(folder_ / "row.csv").at(0);
    const std::string options = options_of(points(n));
    const Outcome run = rotor("run --json " + options + " 2> messages");
    if (run.status != 0) {
      EXPECT_EQ("rotor: " + row["refusal"] + "\n", content("messages")) << options;
      continue;
    }
    const auto summary = nlohmann::ordered_json::parse(run.output);
    for (const std::string& column : sweep.columns) {
      const auto& value = summary.at(column);
      EXPECT_EQ(row[column], value.is_null()     ? ""
                             : value.is_string() ? value.get<std::string>()
                                                 : value.dump())
          << column << ' ' << options;
    }
  }
}

// The picture that README shows is this one.
TEST_F(Maps, AreDrawnAsPreviewed) {
  coarse("speed-friction", 40);
  const Outcome drawn = shell(fmt::format(
      "$rotor sweep {0}.toml --out {0}.csv >/dev/null 2>&1 && {1} {0}.toml > theory.csv && "
      "{2}/figures/draw.sh {0}.svg \"data='{0}.csv'; theory='theory.csv'; shows='outcome'\" "
      "{3}{0}.gp {3}map.gp",
      "speed-friction", ROTOR_MAP_THEORY, ROTOR_SOURCES, maps));
  EXPECT_EQ(drawn.output, "speed-friction.svg\n");
  EXPECT_TRUE(content("speed-friction.svg") == text_of(maps + "preview/speed-friction.svg"));
}

INSTANTIATE_TEST_SUITE_P(Four, Maps,
                         testing::Values("speed-friction", "speed-clearance", "clearance-stiffness",
                                         "contact"),
                         [](const auto& map) {
                           return std::regex_replace(map.param, std::regex("-"), "_");
                         });

/// The maps of the reasons, whose borders closed forms know in part.
struct TheoryOfMaps : Maps {};

TEST_P(TheoryOfMaps, KnowsWhatTouchesAndWhatCannotRubForLong) {
  const Sweep sweep = coarse(GetParam(), 24);
  const SweepPoints points(sweep);
  SweepRows rows(sweep);
  std::string all = sweep_head(sweep);
  for (long n = 0; n < sweep.points(); ++n) all += rows(n);
  write("map.csv", all);
  const auto results = read_csv(folder_ / "map.csv");
  int touching = 0, clear = 0, limited = 0;
  for (long n = 0; n < sweep.points(); ++n) {
    const CsvRow& row = results[static_cast<std::size_t>(n)];
    if (!row["refusal"].empty()) continue;
    const Scenario scenario = scenario_of(points(n).statement);
    const Parameters& p = scenario.parameters;
    const double speed = 2 * std::numbers::pi * scenario.start_speed_Hz;
    const double ratio = speed / std::sqrt(p.support_stiffness / p.mass);
    // Near resonance half a second is short, and the unbalance changes the speed.
    if (std::abs(ratio - 1) < 0.15) continue;
    const MassLossResponse response(p, scenario.equations, speed);
    const double clearance = p.stator_radius - p.rotor_radius;
    const bool touches = row.number("collisions") > 0;
    (touches ? touching : clear)++;
    // To the 0.3 % by which the speed changes, and gravity's moment.
    if (std::abs(response.greatest() / clearance - 1) > 3e-3) {
      EXPECT_EQ(touches, response.greatest() > clearance) << n;
    }
    if (touches) {
      EXPECT_GT(response.bound(), clearance) << n;
    }
    // Below the critical speed a vibration that the loss has left may touch for longer.
    if (touches && ratio > 1 && p.friction > Whirl(p).synchronous_friction(speed)) {
      ++limited;
      EXPECT_TRUE(row["outcome"] == "rolling" || row["outcome"] == "freed") << n;
    }
  }
  EXPECT_GT(touching, 300);
  EXPECT_GT(clear, 200);
  EXPECT_GT(limited, 100);
}

INSTANTIATE_TEST_SUITE_P(Three, TheoryOfMaps,
                         testing::Values("speed-friction", "speed-clearance",
                                         "clearance-stiffness"),
                         [](const auto& map) {
                           return std::regex_replace(map.param, std::regex("-"), "_");
                         });

TEST_F(Maps, HaveClosedFormsBesideThemPointByPoint) {
  const Sweep sweep = coarse("speed-clearance", 26);  // of which some are near resonance
  ASSERT_EQ(shell(ROTOR_MAP_THEORY " speed-clearance.toml > theory.csv").status, 0);
  EXPECT_EQ(content("theory.csv").find("\n\npublished,0.00025,3,"),
            content("theory.csv").find("\n\n"));
  ASSERT_EQ(shell("grep . theory.csv > rows.csv").status, 0);  // without gnuplot's blank lines
  const auto rows = read_csv(folder_ / "rows.csv");
  ASSERT_EQ(static_cast<long>(rows.size()), sweep.points());
  const SweepPoints points(sweep);
  int refused = 0;
  for (long n = 0; n < sweep.points(); ++n) {
    const CsvRow& row = rows[static_cast<std::size_t>(n)];
    if (row["greatest_m"].empty()) {
      ++refused;
      EXPECT_THROW(scenario_of(points(n).statement), std::exception);
    } else if (n % 50 == 0) {
      const Scenario scenario = scenario_of(points(n).statement);
      const double speed = 2 * std::numbers::pi * scenario.start_speed_Hz;
      const MassLossResponse response(scenario.parameters, scenario.equations, speed);
      const Whirl whirl(scenario.parameters);
      const Accident law(scenario.parameters, scenario.equations, speed);
      constexpr double none = -1;
      for (const auto& [column, expected] :
           {std::pair("greatest_m", response.greatest()),
            {"bound_m", response.bound()},
            {"steady_m", response.steady()},
            {"rolling_friction", whirl.rolling_friction(speed)},
            {"synchronous_friction", whirl.synchronous_friction(speed)},
            {"whip_friction", whirl.whip_friction()},
            {"peak_force_N", law.peak_force().value_or(none)},
            {"rebound_friction", law.whirl_friction.value_or(none)},
            {"mu", 0.3}})
        EXPECT_EQ(row[column].empty() ? none : static_cast<double>(row.number(column)), expected)
            << column;
    }
  }
  EXPECT_GT(refused, 5);
  EXPECT_LT(refused, 50);
}

}  // namespace
}  // namespace rotor
