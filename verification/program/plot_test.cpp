/// `rotor plot`.
#include <gtest/gtest.h>

#include <algorithm>

#include "figures/data/read_csv.hpp"
#include "figures/input/words.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/pattern.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class Plot : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    write("it's.toml",
          "title = \"It's 100 %\"\n[parameters]\nstart_speed_Hz = 150\nuntil = 0.03\n"
          "[[run]]\nname = \"high_mu\"\n[[run]]\nname = \"mu's 0.1, narrow\"\nfriction = 0.1\n"
          "clearance = 2.5e-3\nequations = \"published\"\n");
  }
  std::string texts(std::string_view picture) const {
    return fmt::format("{}", fmt::join(DrawnPicture(content(picture)).texts, "\n"));
  }
};

// Force in kN, speed in Hz, displacement and orbit in mm of both runs extend as far in the picture
// as in the traces, the first on top; each run has an orbit of its own, in its ring.
TEST_F(Plot, DrawsTheCurvesOfEachRun) {
  ASSERT_EQ(rotor("plot \"it's.toml\"").status, 0);
  const DrawnPicture picture(content("it's.svg"));
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  using Texts = std::vector<std::string>;
  using Numbers = std::vector<double>;  // the rings, mm: curves that are no run's
  const std::string high = "high_mu", narrow = "mu's 0.1, narrow";
  std::size_t curve = 0;
  for (const auto& [column, scale, runs, clearances_mm] :
       {std::tuple(std::string("normal_force_N"), 1e-3, Texts{narrow, high}, Numbers{}),
        {"speed_Hz", 1., Texts{narrow, high}, Numbers{}},
        {"rho_m", 1e3, Texts{narrow, high}, Numbers{3, 2.5}},
        {"x_a_m", 1e3, Texts{high}, Numbers{3}},
        {"x_a_m", 1e3, Texts{narrow}, Numbers{2.5}}}) {
    const Tics& axis = picture.curves.at(curve).y;
    EXPECT_EQ(pixel(axis, 1) > pixel(axis, 0), column == "x_a_m") << column;  // down
    for (const std::string& run : runs) {
      ASSERT_EQ(rotor("run \"it's.toml\" --run \"" + run + "\" --trace t.csv >out").status, 0);
      Numbers values, heights;
      for (const CsvRow& row : read_csv(folder_ / "t.csv"))
        values.push_back(scale * static_cast<double>(row.number(column)));
      ASSERT_LT(curve, picture.curves.size());
      const DrawnCurve& drawn = picture.curves[curve++];
      for (const auto& [x, y] : drawn.points) heights.push_back(y);
      const auto [least, most] = std::ranges::minmax(values);
      const auto [top, bottom] = std::ranges::minmax(heights);
      const auto [end, begin] = std::minmax({pixel(drawn.y, least), pixel(drawn.y, most)});
      EXPECT_NEAR(top, end, 0.5) << run << ": " << column;
      EXPECT_NEAR(bottom, begin, 0.5) << run << ": " << column;
    }
    for (const double clearance_mm : clearances_mm) {  // of each run, downwards
      const DrawnCurve& drawn = picture.curves[curve++];
      const auto furthest = std::ranges::max_element(drawn.points, {}, [&](const auto& point) {
        return std::abs(point.second - pixel(drawn.y, 0));
      });
      EXPECT_NEAR(std::abs(furthest->second - pixel(drawn.y, 0)),
                  std::abs(pixel(drawn.y, clearance_mm) - pixel(drawn.y, 0)), 0.5);
      if (column != "x_a_m") continue;  // in the orbit a circle
      const auto [left, right] = std::ranges::minmax_element(drawn.points);
      EXPECT_NEAR(right->first - left->first,
                  pixel(drawn.y, clearance_mm) - pixel(drawn.y, -clearance_mm), 1);
    }
  }
  EXPECT_EQ(curve, picture.curves.size());
}

// One of them is not the paper's, and has the corrected equations.
TEST_F(Plot, SaysWhichEquationsAllRunsHave) {
  const auto with = [&](const char* second) {
    write("e.toml", fmt::format("[parameters]\nstart_speed_Hz = 150\nuntil = 0.01\n[[run]]\n"
                                "name = \"a\"\n[[run]]\nname = \"b\"\nequations = \"{}\"\n",
                                second));
    EXPECT_EQ(rotor("plot e.toml").status, 0);
    return texts("e.svg");
  };
  EXPECT_TRUE(has(with("published"), "as printed"));
  EXPECT_TRUE(has(with("corrected"), "corrected equations"));
}

// As the summary does, in a unit that leaves at most three digits before the point.
TEST_F(Plot, SaysTheOutcomeAndTheLargestForce) {
  for (const char* stiffness : {"8e8", "1e10"}) {
    write("s.toml", fmt::format("[parameters]\nstart_speed_Hz = 400\ncontact_stiffness = {}\n"
                                "until = 0.03\n",
                                stiffness));
    ASSERT_EQ(rotor("plot s.toml").status, 0);
    const std::string summary = rotor("run s.toml").output;
    const auto force = matches(summary, "largest normal force (\\d{1,3}\\.\\d+ [kM]N)\\.");
    ASSERT_EQ(force.size(), 1U) << summary;
    EXPECT_TRUE(has(texts("s.svg"), "rolling, largest force " + force[0][1]));
  }
}

// A run has the colour of its equations, and a picture of one set has that of no other.
TEST_F(Plot, DrawsARunInTheColourOfItsEquations) {
  const auto draws = [](const std::string& svg, std::string_view colour) {
    const auto part = [&](std::size_t at) {
      return std::stoi(std::string(colour.substr(at, 2)), nullptr, 16);
    };
    return svg.find(fmt::format("'rgb({:3}, {:3}, {:3})'", part(1), part(3), part(5))) !=
           std::string::npos;
  };
  for (const EquationsInWords& set : sets_in_words) {
    ASSERT_EQ(rotor(fmt::format("plot \"it's.toml\" --equations {}", set.name)).status, 0);
    for (const EquationsInWords& other : sets_in_words)
      EXPECT_EQ(draws(content("it's.svg"), other.light), set.name == other.name) << set.name;
  }
}

// Of several runs of a set that with the largest force has the set's colour, wherever it stands;
// each orbit ends in an arrow.
TEST_F(Plot, DrawsTheRunWithTheLargestForceDarkest) {
  write("s.toml",
        "[parameters]\nstart_speed_Hz = 150\nuntil = 0.05\n[[run]]\nname = \"weak\"\nfriction = "
        "0.08\n[[run]]\nname = \"strong\"\n");
  ASSERT_EQ(rotor("plot s.toml").status, 0);
  const auto titles =
      matches(content("s.svg"), "fill=\"rgb\\((\\d+),[^>]*>\\s*<text[^>]*>(weak|strong)</text>");
  ASSERT_EQ(titles.size(), 2U);
  EXPECT_EQ(titles[1][2], "strong");
  EXPECT_LT(std::stoi(titles[1][1]), std::stoi(titles[0][1]));
  EXPECT_EQ(matches(content("s.svg"), "<polygon").size(), 2U);
}

// In ten times the time that a picture shows, curves of the same look have hardly more corners.
TEST_F(Plot, DrawsNoMoreThanItsPixelsShow) {
  write("s.toml",
        "[parameters]\nstart_speed_Hz = 150\nuntil = 0.25\n[[run]]\nname = \"a\"\n[[run]]\n"
        "name = \"b\"\nfriction = 0.08\n");
  ASSERT_EQ(rotor("plot s.toml").status, 0);
  EXPECT_LT(content("s.svg").size(), 400'000U);
}

// All that is stated, in whole items, and as far as it is drawn.
TEST_F(Plot, SaysWhatIsDrawnInWholeItems) {
  const std::vector<std::string> items = {
      "mass = 2 kg",          "inertia = 0.0016 kg m²",        "eccentricity = 0.02 mm",
      "friction = 0.25",      "support stiffness = 10000 N/m", "contact stiffness = 1e+09 N/m",
      "clearance = 2 mm",     "support damping = 10 N s/m",    "lost mass = 0.012 kg",
      "rotor radius = 40 mm", "start speed = 7200 rpm",        "f, rpm"};
  write("s.toml",
        "[parameters]\nequations = \"corrected\"\nmass = 2\ninertia = 1.6e-3\neccentricity = "
        "2e-5\nsupport_stiffness = 1e4\nsupport_damping = 10\ncontact_stiffness = 1e9\nfriction = "
        "0.25\nrotor_radius = 0.04\nclearance = 2e-3\nlost_mass = 0.012\nstart_speed_rpm = "
        "7200\nmass_loss_time = 0.02\nuntil = 0.03\n");
  ASSERT_EQ(rotor("plot s.toml --until 0.01").status, 0);
  const DrawnPicture picture(content("s.svg"));
  EXPECT_EQ(picture.clipped, std::vector<std::string>());
  const auto shows = [&](const std::string& item) {
    return std::ranges::any_of(picture.texts, [&](const auto& text) {
      return (", " + text + ",").find(", " + item + ",") != std::string::npos;
    });
  };
  for (const std::string& item : items) EXPECT_TRUE(shows(item)) << item;
  EXPECT_TRUE(shows("until = 0.03 s"));
  EXPECT_TRUE(shows("drawn until 0.01 s, results of the whole run"));
}

// Also of a name that is not UTF-8. iconv reads nothing else.
TEST_F(Plot, DrawsLettersOnly) {
  write("a.toml", "[parameters]\nstart_speed_Hz = 150\nuntil = 0.001\n");
  for (const std::string name : {"\xff", "\xc3(", "\xed\xa0\x80", "\xc0\xaf", "\xef\xbf\xbe"}) {
    fs::copy_file(folder_ / "a.toml", folder_ / (name + ".toml"));
    ASSERT_EQ(rotor("plot '" + name + ".toml' --out a.svg").status, 0);
    EXPECT_EQ(shell("iconv -f UTF-8 -t UTF-16 a.svg >a.txt").status, 0) << name;
    EXPECT_FALSE(has(content("a.svg"), "\xef\xbf\xbe"));
  }
}

}  // namespace
}  // namespace rotor
