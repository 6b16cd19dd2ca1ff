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
#include "model/theory/mass_loss_response.hpp"
#include "model/theory/whirl.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

const std::string maps = ROTOR_SOURCES "/figures/maps/";

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

using Texts = std::vector<std::string>;

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

// What gnuplot complains of, it says. The README's picture is one of them.
TEST_P(Maps, AreDrawn) {
  const std::string map = GetParam();
  const bool is_previewed = map == "speed-friction";
  coarse(map, is_previewed ? 40 : 6);
  const auto [status, output] = shell(fmt::format(
      "$rotor sweep {0}.toml --out {0}.csv >/dev/null 2>&1 && {1} {0}.toml > theory.csv && "
      "for shows in outcome force; do {2}/figures/draw.sh $shows.svg \"data='{0}.csv'; "
      "theory='theory.csv'; shows='$shows'\" {3}{0}.gp {3}map.gp >/dev/null; done",
      map, ROTOR_MAP_THEORY, ROTOR_SOURCES, maps));
  EXPECT_EQ(status, 0);
  EXPECT_EQ(output, "");
  const std::string outcome = content("outcome.svg"), force = content("force.svg");
  for (const std::string& picture : {outcome, force}) {
    std::size_t images = 0;
    for (std::size_t at = 0; (at = picture.find("<image", at)) != std::string::npos; ++at) ++images;
    EXPECT_EQ(images, map == "contact" ? 4U : 2U);
  }
  for (const char* word : {"backward rolling", "touches or stalls before the loss", "published"})
    EXPECT_NE(outcome.find(word), std::string::npos) << word;
  EXPECT_NE(force.find("largest normal force, kN; white: no contact, or contact before the loss"),
            std::string::npos);
  // Axes with their units, the titles of the panels as the data follow each other, tics.
  struct Axes {
    Texts names, tics;
  };
  const std::map<std::string, Axes> axes = {
      {"speed-friction", {{"speed at the mass loss, Hz", "coefficient of friction μ"}, {"0.3"}}},
      {"speed-clearance", {{"speed at the mass loss, Hz", "clearance, mm"}, {"3"}}},
      {"clearance-stiffness",
       {{"clearance, mm", "stiffness of the supports k, N/m"}, {"3", "105"}}},
      {"contact", {{"contact stiffness kt, N/m", "contact damping dt, N s/m"}, {"109", "104"}}}};
  const DrawnPicture of_outcome(outcome), of_force(force);
  for (const DrawnPicture& picture : {of_outcome, of_force}) {
    const auto says = [&](const std::string& text) {
      return std::ranges::find(picture.texts, text) != picture.texts.end();
    };
    for (const std::string& text : axes.at(map).names) EXPECT_TRUE(says(text)) << text;
    for (const std::string& text : axes.at(map).tics) EXPECT_TRUE(says(text)) << text;
    EXPECT_EQ(picture.clipped, Texts());
  }
  // The force's colours, in ratios. Forces beyond the darkest are said to be drawn alike.
  double greatest_kN = 0;
  for (const CsvRow& row : read_csv(folder_ / (map + ".csv")))
    if (!row["peak_normal_force_N"].empty())
      greatest_kN =
          std::max(greatest_kN, static_cast<double>(row.number("peak_normal_force_N")) / 1e3);
  EXPECT_EQ(greatest_kN > 1000, map == "contact");
  for (const char* tic : {" 1", " 10", " 100", greatest_kN > 1000 ? "1000 and more" : " 1000"})
    EXPECT_NE(std::ranges::find(of_force.texts, tic), of_force.texts.end()) << tic;
  EXPECT_EQ(std::ranges::count(of_force.texts, " 1000"), greatest_kN > 1000 ? 0 : 1);
  Texts panels, rows;
  for (const std::string& text : of_outcome.texts)
    if (text.starts_with("published equations") || text.starts_with("consistent equations"))
      if (std::ranges::find(panels, text) == panels.end()) panels.push_back(text);
  for (const CsvRow& row : read_csv(folder_ / (map + ".csv"))) {
    const std::string row_of = map == "contact" ? ", μ = " + row["friction"] : "",
                      panel = row["equations_varied"] + " equations" + row_of;
    if (std::ranges::find(rows, panel) == rows.end()) rows.push_back(panel);
  }
  EXPECT_EQ(panels, rows);
  if (map == "contact") {
    EXPECT_EQ(panels, Texts({"published equations, μ = 0.3", "consistent equations, μ = 0.3",
                             "published equations, μ = 0.08", "consistent equations, μ = 0.08"}));
  }
  if (is_previewed) {
    EXPECT_TRUE(outcome == text_of(maps + "preview/speed-friction.svg"));
  }
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

TEST_F(Maps, ShowEveryOutcomeAsAClassOfItsOwn) {
  std::string names;
  for (int n = 0; n <= static_cast<int>(rotor::Outcome::undecided); ++n)
    names += fmt::format(" {}", name_of(static_cast<rotor::Outcome>(n)));
  EXPECT_EQ(shell("{ sed -n '/^classes/,/^kN/p' " + maps + "map.gp; echo 'do for [o in \"" + names +
                  " \"] { print name[code(o) + 1] }'; } | LC_ALL=C.UTF-8 gnuplot -d")
                .output,
            "backward rolling\ntouches or stalls before the loss\nsliding after 0.5 s\nfreed after "
            "contact\nno contact\nbouncing after 0.5 s\nundecided after 0.5 s\n");
}

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
      for (const auto& [column, expected] :
           {std::pair("greatest_m", response.greatest()),
            {"bound_m", response.bound()},
            {"steady_m", response.steady()},
            {"rolling_friction", whirl.rolling_friction(speed)},
            {"synchronous_friction", whirl.synchronous_friction(speed)},
            {"whip_friction", whirl.whip_friction()},
            {"mu", 0.3}})
        EXPECT_EQ(static_cast<double>(row.number(column)), expected) << column;
    }
  }
  EXPECT_GT(refused, 5);
  EXPECT_LT(refused, 50);
  write("drawn.toml",
        "[sample]\ncount = 3\n[[sample.over]]\nquantity = \"friction\"\nuniform = [0.1, 1]\n");
  EXPECT_EQ(shell(ROTOR_MAP_THEORY " drawn.toml").output,
            "map-theory: drawn.toml: a map has an [[axis]], and no [sample]\n");
  const auto [status, output] = shell(ROTOR_MAP_THEORY " none.toml");
  EXPECT_EQ(status, 1);
  EXPECT_TRUE(output.starts_with("map-theory: none.toml: ")) << output;
}

}  // namespace
}  // namespace rotor
