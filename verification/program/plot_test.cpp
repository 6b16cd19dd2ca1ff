/// `rotor plot`.
#include <gtest/gtest.h>

#include <algorithm>

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
};

// Force in kN, speed in Hz, displacement and orbit in mm of both runs extend as far in the picture
// as in the traces; each run has an orbit of its own, in its ring.
TEST_F(Plot, DrawsTheCurvesOfEachRun) {
  ASSERT_EQ(rotor("plot \"it's.toml\"").status, 0);
  const DrawnPicture picture(content("it's.svg"));
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  struct Panel {
    std::string column;
    double scale;
    std::vector<std::string> runs;
    std::vector<double> clearances_mm;  ///< curves that are no run's
  };
  const std::string high = "high_mu", narrow = "mu's 0.1, narrow";
  const std::vector<Panel> panels = {{"normal_force_N", 1e-3, {high, narrow}, {}},
                                     {"speed_Hz", 1, {high, narrow}, {}},
                                     {"rho_m", 1e3, {high, narrow}, {3, 2.5}},
                                     {"x_a_m", 1e3, {high}, {3}},
                                     {"x_a_m", 1e3, {narrow}, {2.5}}};
  std::size_t curve = 0;
  for (const Panel& panel : panels) {
    const Tics& axis = picture.curves.at(curve).y;
    EXPECT_EQ(pixel(axis, 1) > pixel(axis, 0), panel.column == "x_a_m") << panel.column;  // down
    for (const std::string& run : panel.runs) {
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
  }
  EXPECT_EQ(curve, picture.curves.size());
}

// In ten times the time that a picture shows, curves of the same look have hardly more corners.
// (The old picture of these runs had a megabyte.)
TEST_F(Plot, DrawsNoMoreThanItsPixelsShow) {
  write("s.toml",
        "[parameters]\nstart_speed_hz = 150\nuntil = 0.25\n[[run]]\nname = \"a\"\n[[run]]\n"
        "name = \"b\"\nfriction = 0.08\n");
  ASSERT_EQ(rotor("plot s.toml").status, 0);
  EXPECT_LT(content("s.svg").size(), 400'000U);
}

// A title of its own, what varies and what does not, in mm; rectangles for the cells of a map, also
// where a renderer would blend those of an image; bars at the points of an axis.
TEST_F(Plot, SaysAndShowsWhatASweepStates) {
  const std::string head =
      "columns = [\"outcome\"]\n[parameters]\nequations = \"corrected\"\nstart_speed_hz = "
      "150\nuntil = "
      "0.01\n[[axis]]\nquantity = \"clearance\"\nfrom = 2e-3\nto = 3e-3\npoints = 3\n";
  write("map.toml", head + "[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.3]\n");
  write("bars.toml",
        head +
            "[sample]\ncount = 4\nseed = 1\n[[sample.over]]\nquantity = \"eccentricity\"\n"
            "uniform = [1e-4, 2e-4]\n");
  for (const auto& [name, says] :
       {std::pair("map", "corrected equations, start speed = 150 Hz, until = 0.01 s"),
        {"bars", "4 draws of eccentricity from 0.1 to 0.2 mm; corrected equations, "}}) {
    ASSERT_EQ(rotor(std::string("plot ") + name + ".toml").status, 0);
    const std::string svg = content(std::string(name) + ".svg");
    for (const std::string text : {says, "clearance, mm"})
      EXPECT_NE(svg.find(text), std::string::npos) << text;
    EXPECT_EQ(svg.find("<image"), std::string::npos);
    std::size_t cells = 0;
    for (std::size_t at = 0;
         (at = svg.find("<polygon shape-rendering='crispEdges'", at)) != svg.npos; ++at)
      ++cells;
    if (name == std::string("map")) {
      EXPECT_EQ(cells, 6U);
    }
  }
}

// All that is stated, in whole items, and as far as it is drawn.
TEST_F(Plot, SaysWhatIsDrawnInWholeItems) {
  const std::vector<std::string> items = {
      "mass = 2 kg",         "inertia = 0.0016 kg m^2",       "eccentricity = 0.02 mm",
      "friction = 0.25",     "support stiffness = 10000 N/m", "contact stiffness = 1e+09 N/m",
      "clearance = 2 mm",    "support damping = 10 N s/m",    "lost mass = 0.012 kg",
      "rotor radius = 40 mm"};
  write("s.toml",
        "[parameters]\nequations = \"corrected\"\nmass = 2\ninertia = 1.6e-3\neccentricity = "
        "2e-5\nsupport_stiffness = 1e4\nsupport_damping = 10\ncontact_stiffness = 1e9\nfriction = "
        "0.25\nrotor_radius = 0.04\nclearance = 2e-3\nlost_mass = 0.012\nstart_speed_hz = "
        "120\nuntil = 0.03\n");
  ASSERT_EQ(rotor("plot s.toml --until 0.01").status, 0);
  const DrawnPicture picture(content("s.svg"));
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  const auto shows = [&](const std::string& item) {
    return std::ranges::any_of(picture.texts, [&](const auto& text) {
      return (", " + text + ",").find(", " + item + ",") != std::string::npos;
    });
  };
  for (const std::string& item : items) EXPECT_TRUE(shows(item)) << item;
  EXPECT_TRUE(shows("until = 0.01 s"));
  EXPECT_FALSE(shows("until = 0.03 s"));
}

// A row belongs to the point of its values, wherever it is; what belongs to none is refused.
TEST_F(Plot, PlacesRowsByTheirValues) {
  write("s.toml",
        "columns = [\"outcome\", \"peak_force_to_rolling_N\"]\n[parameters]\nstart_speed_hz = "
        "150\nuntil = 0.01\n[[axis]]\nquantity = \"clearance\"\nfrom = 2e-3\nto = 3e-3\npoints = "
        "3\n[[axis]]\nquantity = \"friction\"\nvalues = [0.1, 0.3]\n");
  ASSERT_EQ(rotor("sweep s.toml --out s.csv").status, 0);
  const std::string change =
      "sed -n '/^#/p;/^clearance/p' s.csv >b.csv; sed '/^#/d;/^clearance/d' ";
  const auto drawn = [&](const std::string& command) {
    shell(change + command + " >>b.csv");
    EXPECT_EQ(rotor("plot b.csv --out b.svg").status, 0);
    return content("b.svg");
  };
  EXPECT_TRUE(drawn("s.csv | sort -t, -k2 -r") == drawn("s.csv"));
  for (const auto& [edit, complaint] :
       {std::pair("2d;1p",
                  "is no point of the sweep file above the results, or one that an earlier"),
        {"1s/^0.002/0.007/", "is no point of the sweep file above the results"},
        {"1s/bouncing/bounce/", ": outcome: must be one of: "},
        {"1s/,[0-9.]*,,$/,-inf,,/", ": peak_force_to_rolling_N: must be a number below"},
        {"1s/,[0-9.]*,,$/,1e305,,/", ": peak_force_to_rolling_N: must be a number below"}}) {
    shell(change + "s.csv | sed '" + edit + "' >>b.csv");
    expect_refusal("plot b.csv", complaint);
  }
}

// Also of a name that is not UTF-8. iconv reads nothing else.
TEST_F(Plot, DrawsLettersOnly) {
  write("a.toml", "[parameters]\nstart_speed_hz = 150\nuntil = 0.001\n");
  for (const std::string name : {"\xff", "\xc3(", "\xed\xa0\x80", "\xc0\xaf", "\xef\xbf\xbe"}) {
    fs::copy_file(folder_ / "a.toml", folder_ / (name + ".toml"));
    ASSERT_EQ(rotor("plot '" + name + ".toml' --out a.svg").status, 0);
    EXPECT_EQ(shell("iconv -f UTF-8 -t UTF-16 a.svg >a.txt").status, 0) << name;
    EXPECT_EQ(content("a.svg").find("\xef\xbf\xbe"), std::string::npos);
  }
}

// Also where the rows of the panels alternate. Listed values have none: they are in any order.
TEST_F(Plot, DrawsTheLineOfASweepInEachPanel) {
  for (const auto& [axis, lines] :
       {std::pair("from = 0.1\nto = 0.2\npoints = 11\n", 1), {"values = [0.1, 0.2, 0.15]\n", 0}}) {
    write("s.toml",
          "columns = [\"outcome\", \"peak_force_to_rolling_N\"]\n[parameters]\nstart_speed_hz = "
          "150\nuntil = 0.01\n[[axis]]\nquantity = \"friction\"\n" +
              std::string(axis) +
              "[[axis]]\nquantity = \"equations\"\nvalues = [\"published\", \"consistent\"]\n");
    ASSERT_EQ(rotor("plot s.toml").status, 0);
    const std::string picture = content("s.svg");
    for (const std::string of : {"a", "b"}) {  // after a gap, a path goes on with an M
      const auto from = picture.find("gnuplot_plot_1" + of),
                 to = picture.find("gnuplot_plot_2" + of);
      ASSERT_LT(from, to);
      EXPECT_EQ(std::ranges::count(picture.substr(from, to - from), 'M'), lines);
    }
  }
}

// Of whichever largest force is drawn.
TEST_F(Plot, DrawsAForceOfZeroWhereNothingTouches) {
  write("s.toml",
        "stop_on = \"end\"\n[parameters]\nequations = \"consistent\"\nstart_speed_hz = 50\nuntil = "
        "0.1\n[[axis]]\nquantity = \"friction\"\nfrom = 0.1\nto = 0.2\npoints = 3\n");
  for (const char* column : {"peak_force_to_rolling_N", "peak_normal_force_N"}) {
    ASSERT_EQ(rotor(std::string("plot s.toml --column ") + column).status, 0);
    EXPECT_EQ(content(std::string("s-") + column + ".svg").find("no point has this result"),
              std::string::npos)
        << column;
  }
}

}  // namespace
}  // namespace rotor
