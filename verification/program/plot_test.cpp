/// `rotor plot`.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "figures/data/csv.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class Plot : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    write("it's.toml",
          "title = \"It's 100 %\"\n[parameters]\nstart_speed_hz = 150\nuntil = 0.03\n"
          "[[run]]\nname = \"high_mu\"\n[[run]]\nname = \"mu's 0.1, narrow\"\nfriction = 0.1\n"
          "clearance = 2.5e-3\n");
  }

  /// So many runs of different friction, which make contact before the end.
  void write_runs(int count, const std::string& name) const {
    std::string scene = "[parameters]\nstart_speed_hz = 150\nuntil = 0.01\n";
    for (int n = 1; n <= count; ++n)
      scene += fmt::format("[[run]]\nname = \"{} {}\"\nfriction = 0.{}\n", n, name, n);
    write("runs.toml", scene);
  }

  /// Gnuplot has nothing to complain of.
  DrawnPicture drawn(const std::string& scene) const {
    const auto [status, output] = rotor("plot " + scene + ".toml");
    EXPECT_EQ(status, 0);
    EXPECT_EQ(output, scene + ".svg\n");
    return DrawnPicture(content(scene + ".svg"));
  }

  static double top(const DrawnCurve& curve) {
    return std::ranges::min_element(curve.points, {}, &Points::value_type::second)->second;
  }
  static Points::value_type place(const DrawnPicture& picture, const std::string& text) {
    const auto at = std::ranges::find(picture.texts, text);
    return picture.places.at(static_cast<std::size_t>(at - picture.texts.begin()));
  }
};

long letters(const std::string& text) {
  return std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; });
}

/// Texts neither touch nor, in a column of tics, repeat each other, and none is cut off.
void expect_legible(const DrawnPicture& picture) {
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  const double letter = 0.6 * 11.2, panel = 100;  // pixels: a small letter, within a panel
  for (std::size_t i = 0; i < picture.texts.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const std::string &a = picture.texts[i], &b = picture.texts[k];
      if (a.empty() || b.empty()) continue;
      const double right = std::abs(picture.places[i].first - picture.places[k].first),
                   down = std::abs(picture.places[i].second - picture.places[k].second);
      if (down < 1) {
        EXPECT_GT(right, 0.5 * letter * static_cast<double>(letters(a) + letters(b)))
            << a << ", " << b;
      } else if (right < 1 && down < panel) {
        EXPECT_NE(a, b);
      }
    }
}

// Force in kN, speed in Hz, displacement and orbit in mm, each of both runs, reach as far in the
// picture as in the runs' traces; the ring is drawn around the orbit.
TEST_F(Plot, DrawsTheCurvesOfEachRun) {
  ASSERT_EQ(rotor("plot \"it's.toml\"").status, 0);
  const DrawnPicture picture(content("it's.svg"));
  struct Panel {
    std::string column;
    double scale;
    std::vector<double> clearances_mm;  ///< curves that are no run's
  };
  const std::vector<Panel> panels = {{"normal_force_N", 1e-3, {}},
                                     {"speed_Hz", 1, {}},
                                     {"rho_m", 1e3, {3, 2.5}},
                                     {"x_a_m", 1e3, {3, 2.5}}};
  std::size_t curve = 0;
  for (const Panel& panel : panels) {
    const Tics& axis = picture.curves.at(curve).y;
    EXPECT_EQ(pixel(axis, 1) > pixel(axis, 0), panel.column == "x_a_m") << panel.column;  // down
    for (const double clearance_mm : panel.clearances_mm) {  // of each run, downwards
      const DrawnCurve& drawn = picture.curves[curve++];
      const auto furthest = std::ranges::max_element(drawn.points, {}, [&](const auto& point) {
        return std::abs(point.second - pixel(drawn.y, 0));
      });
      EXPECT_NEAR(std::abs(furthest->second - pixel(drawn.y, 0)),
                  std::abs(pixel(drawn.y, clearance_mm) - pixel(drawn.y, 0)), 0.5);
      if (panel.column != "x_a_m") continue;  // in the orbit a circle
      const auto [left, right] = std::ranges::minmax_element(drawn.points);
      EXPECT_NEAR(right->first - left->first,
                  pixel(drawn.y, clearance_mm) - pixel(drawn.y, -clearance_mm), 1);
    }
    for (const std::string run : {"high_mu", "mu's 0.1, narrow"}) {
      ASSERT_EQ(rotor("run --scene \"it's.toml\" --run \"" + run + "\" --trace t.csv >out").status,
                0);
      std::vector<double> values, heights;
      for (const CsvRow& row : read_csv(folder_ / "t.csv"))
        values.push_back(panel.scale * static_cast<double>(row.number(panel.column)));
      ASSERT_LT(curve, picture.curves.size());
      const DrawnCurve& drawn = picture.curves[curve++];
      for (const auto& [x, y] : drawn.points) heights.push_back(y);
      const auto [least, most] = std::minmax_element(values.begin(), values.end());
      const auto [top, bottom] = std::minmax_element(heights.begin(), heights.end());
      const auto [end, begin] = std::minmax({pixel(drawn.y, *least), pixel(drawn.y, *most)});
      EXPECT_NEAR(*top, end, 0.5) << run << ": " << panel.column;
      EXPECT_NEAR(*bottom, begin, 0.5) << run << ": " << panel.column;
    }
  }
  EXPECT_EQ(curve, picture.curves.size());
  // The key's lines have the colours of the runs, which come last in each panel.
  const std::vector<std::string> of_runs = {picture.curves[curve - 2].colour,
                                            picture.curves[curve - 1].colour};
  EXPECT_NE(of_runs[0], of_runs[1]);
  EXPECT_EQ(picture.samples, of_runs);
}

// Of an orbit that is smaller than the ring, and of whichever run has the widest, too.
TEST_F(Plot, DrawsTheWholeRing) {
  const auto expect_whole = [](const DrawnCurve& ring, double clearance_mm) {
    const double diameter = pixel(ring.y, clearance_mm) - pixel(ring.y, -clearance_mm);
    const auto [left, right] = std::ranges::minmax_element(ring.points);
    EXPECT_NEAR(right->first - left->first, diameter, 1) << clearance_mm;
    const auto [top, bottom] = std::ranges::minmax_element(
        ring.points, {}, [](const auto& point) { return point.second; });
    EXPECT_NEAR(bottom->second - top->second, diameter, 1) << clearance_mm;
  };
  const std::string clear = "[parameters]\nstart_speed_hz = 30\nno_separation = true\nuntil = 1\n";
  write("clear.toml", clear);
  expect_whole(drawn("clear").curves.at(4), 3);
  for (const bool widens : {true, false}) {
    const double first_mm = widens ? 3 : 6, second_mm = 9 - first_mm;
    write("clear.toml", clear + fmt::format("[[run]]\nname = \"a\"\nclearance = {}e-3\n"
                                            "[[run]]\nname = \"b\"\nclearance = {}e-3\n",
                                            first_mm, second_mm));
    const DrawnPicture picture = drawn("clear");
    expect_whole(picture.curves.at(8), first_mm);
    expect_whole(picture.curves.at(9), second_mm);
  }
}

// However long its names are, the key lies above all panels.
TEST_F(Plot, HasAKeyThatHidesNoCurve) {
  write_runs(8, std::string(70, 'n'));
  const DrawnPicture of_eight = drawn("runs");
  expect_legible(of_eight);
  for (int n = 1; n <= 8; ++n) {
    const std::string name = fmt::format("{} {}\u2026", n, std::string(33, 'n'));
    ASSERT_EQ(std::ranges::count(of_eight.texts, name), 1) << name;
    EXPECT_LT(place(of_eight, name).second, top(of_eight.curves.at(0))) << name;
  }
  write("one.toml", "[parameters]\nstart_speed_hz = 150\nuntil = 0.03\n");
  const DrawnPicture of_one = drawn("one");
  for (const DrawnPicture& picture : {of_eight, of_one}) {
    ASSERT_EQ(std::ranges::count(picture.texts, "clearance"), 1);
    EXPECT_LT(place(picture, "clearance").second, top(picture.curves.at(0)));
  }
}

TEST_F(Plot, SaysHowManyRunsItsKeyLeavesOut) {
  write_runs(17, std::string(70, 'n'));
  const DrawnPicture picture = drawn("runs");
  expect_legible(picture);
  EXPECT_EQ(std::ranges::count(picture.texts, "and 3 more runs"), 1);
  EXPECT_EQ(std::ranges::count_if(picture.texts,
                                  [](const auto& text) { return text.ends_with("n\u2026"); }),
            14);
}

// By colour, or by colour and dashes.
TEST_F(Plot, DrawsEightRunsInEightWays) {
  write_runs(8, "run");
  ASSERT_EQ(rotor("plot runs.toml").status, 0);
  const std::string picture = content("runs.svg"), drawn = "<path stroke='rgb(";
  std::set<std::string> looks;
  for (std::size_t at = 0; (at = picture.find(drawn, at)) != std::string::npos; ++at) {
    const std::size_t points = picture.find(" d='", at);
    const bool is_clearance =
        picture.substr(at, points - at).find("'1.0,1.5'") != std::string::npos;
    if (!is_clearance && picture.find('\'', points + 4) - points > 1000)
      looks.insert(picture.substr(at, points - at));
  }
  EXPECT_EQ(looks.size(), 8U);
}

// Also where a quantity hardly changes, or not at all: without contact there is no force.
TEST_F(Plot, HasLabelsThatTellItsTicsApart) {
  write("still.toml",
        "[parameters]\nlost_mass = 1e-4\ntorque = 0\nstart_speed_hz = 150\nuntil = 0.03\n");
  write("window.toml",
        "window = { from_s = 0.0127, until_s = 0.0127004 }\n"
        "[parameters]\nstart_speed_hz = 150\nuntil = 0.0127004\n");
  for (const char* scene : {"still", "window"}) {
    const DrawnPicture picture = drawn(scene);
    expect_legible(picture);
    // The name of the right axis lies between the panels.
    const auto& force = picture.curves.at(0).points;
    const double end = std::ranges::max_element(force)->first;
    EXPECT_GT(place(picture, "f, Hz").first, end + 14) << scene;
  }
}

// Where one works, under the scene's name, which is its heading if it has no title.
TEST_F(Plot, IsCalledAfterItsScene) {
  ASSERT_EQ(shell("mkdir scenes").status, 0);
  write("scenes/plain.toml", "[parameters]\nstart_speed_hz = 150\nuntil = 0.01\n");
  const auto [status, output] = rotor("plot scenes/plain.toml --equations published");
  EXPECT_EQ(output, "plain.svg\n");
  EXPECT_FALSE(fs::exists(folder_ / "scenes/plain.svg"));
  EXPECT_NE(content("plain.svg").find(">plain<"), std::string::npos);
}

// Options give way to what a [[run]] states itself.
TEST_F(Plot, LeavesARunItsOwnMethod) {
  write("own.toml",
        "[parameters]\nstart_speed_hz = 150\nseparation_time = 1e-3\nuntil = 0.01\n[[run]]\n"
        "name = \"a\"\nmethod = \"rk4\"\ncontact_stiffness = 1e13\n");
  expect_refusal("plot own.toml --method event --equations published",
                 "own.toml: a: the rk4 run diverged");
}

TEST_F(Plot, ReplacesNoSceneByItsPicture) {
  const std::string scene = "[parameters]\nstart_speed_hz = 150\nuntil = 0.01\n";
  write("own.toml", scene);
  fs::create_symlink("own.toml", folder_ / "own.svg");
  expect_refusal("plot own.toml", "own.svg: cannot be written: it is what the runs are read from");
  EXPECT_EQ(content("own.toml"), scene);
}

TEST_F(Plot, RefusesDigits) {
  write("d.toml", "[parameters]\nstart_speed_hz = 150\nuntil = 0.03\ndigits = 6\n");
  expect_refusal("plot d.toml", "d.toml: digits: those of curves are not known");
}

// A day of whirling would be a black picture, and many gigabytes.
TEST_F(Plot, RefusesMoreThanAPictureCanShow) {
  write("day.toml", "[parameters]\nno_separation = true\nuntil = 86400\n");
  expect_refusal("plot day.toml", "day.toml: run: more than 2000000 rows are too many to draw");
}

TEST_F(Plot, DrawsTheFormatThatTheNameEndsIn) {
  EXPECT_EQ(rotor("plot \"it's.toml\" --out a.pdf").status, 0);
  EXPECT_TRUE(content("a.pdf").starts_with("%PDF"));
  EXPECT_EQ(rotor("plot \"it's.toml\" --out a.png").status, 0);
  EXPECT_TRUE(content("a.png").substr(1).starts_with("PNG"));
}

}  // namespace
}  // namespace rotor
