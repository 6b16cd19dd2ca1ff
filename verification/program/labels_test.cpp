/// What the drawn figures say beside their curves: axes with their units, keys, what the paper
/// states and at which level that is drawn, and numbers that are read off the curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include "figures/sweep/sweep.hpp"
#include "verification/support/figure_drawing.hpp"
#include "verification/support/figure_list.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

using Texts = std::vector<std::string>;

/// Written out anew from the paper's text: what a figure shows, and what is stated of it.
struct Labels {
  Texts axes;                    ///< in the order of the panels
  Texts keys;                    ///< of the curves that have one, in their order
  Texts paper;                   ///< what the paper states
  std::vector<double> levels{};  ///< where on the y axis that is, and the clearance
};

const std::map<int, Labels>& labels() {
  const std::string time = "t, s", force = "Fn, kN", rho = "ρ, mm";
  const Texts orbit = {"xa (down), mm", "ya, mm"};
  static const std::map<int, Labels> all = {
      {2, {{"q1, mm", "q2, mm", rho, time}, {}, {}}},
      {3,
       {{force, force, force, time}, {}, {"paper: 400–450 kN in rolling, 455 kN at most"}, {-455}}},
      {4,
       {{"f, Hz", time},
        {"μ = 0.3", "μ = 0.2", "μ = 0.08"},
        {"paper: 45 Hz as rolling sets in, μ = 0.3"},
        {45}}},
      {5, {{force, time}, {}, {"paper: 455 kN", "paper: 0.023 s after the first collision"}}},
      {6,
       {{"T, J", time},
        {},
        {"paper: 4000 J", "paper: −1000 J by collisions", "paper: −1950 J by sliding, 1050 J left"},
        {4000, 3000, 1050}}},
      {7, {{"mm", time}, {"q1", "ρ"}, {"paper: about 770 Hz", "paper: ρ ≈ 3.5 mm"}, {3.5}}},
      {8, {orbit, {"29 s", "mass loss", "sense of motion"}, {}}},
      {9,
       {orbit, {"published method", "event method", "29 s", "mass loss", "sense of motion"}, {}}},
      {10, {{}, {}, {"paper 16.9 m/s"}}},
      {11, {{force, force, force, time}, {}, {"paper: 455 kN", "paper: minor effect"}, {-455}}},
      {12, {{force, time}, {}, {"paper: 100 Hz", "paper: 237 kN"}, {-237}}},
      {13, {{force, time}, {}, {"paper: 75 Hz", "paper: 136 kN"}, {-136}}},
      {14, {{rho, time}, {}, {"paper: no contact"}, {3}}},
      {15, {{rho, time}, {}, {"paper: no contact"}, {3}}},
      {16, {orbit, {"9.3 s", "mass loss", "sense of motion"}, {}}},
      {17,
       {{rho, time},
        {"a", "b"},
        {"paper: 11.8 Hz, which is passed at 2.23 s", "paper: no contact"},
        {3}}},
  };
  return all;
}

/// Each text where it stands first.
Texts once(const Texts& texts) {
  Texts result;
  for (const std::string& text : texts)
    if (std::ranges::find(result, text) == result.end()) result.push_back(text);
  return result;
}

class DrawnLabels : public PublishedFigures, public testing::WithParamInterface<Figure> {};

TEST_P(DrawnLabels, AreThoseOfWhatIsShownAndStated) {
  const Labels& expected = labels().at(GetParam().number);
  const DrawnPicture picture = drawn(GetParam().number);
  Texts axes;
  for (const std::string& text : picture.texts) {
    if (std::ranges::find(expected.axes, text) != expected.axes.end() || text.ends_with(", mm") ||
        text.ends_with(", μm") || text.ends_with(", N") || text.ends_with(", kN"))
      axes.push_back(text);
  }
  EXPECT_EQ(axes, expected.axes);
  if (!expected.keys.empty()) {
    EXPECT_EQ(once(picture.keys), expected.keys);
  }
  for (const std::string& stated : expected.paper)
    EXPECT_TRUE(std::ranges::any_of(picture.texts, [&](const std::string& text) {
      return text.find(stated) != std::string::npos;
    })) << stated;
  const auto says = [&](const std::string& text) {
    return std::ranges::any_of(
        expected.paper, [&](const auto& stated) { return text.find(stated) != std::string::npos; });
  };
  for (const std::string& text : picture.texts)
    EXPECT_TRUE(text.find("paper") == std::string::npos || text.starts_with("dashed: paper") ||
                says(text))
        << text;
  if (GetParam().number == 15) {
    EXPECT_TRUE(std::ranges::any_of(picture.texts, [](const std::string& text) {
      return text.find("beginning of Fig. 14:") != std::string::npos;
    }));
  }
  EXPECT_EQ(picture.levels.size(), expected.levels.size());
  for (const double level : expected.levels)
    EXPECT_TRUE(std::ranges::any_of(picture.curves, [&](const DrawnCurve& curve) {
      return std::ranges::any_of(picture.levels, [&](double y) {
        return curve.y.size() > 1 && std::abs(y - pixel(curve.y, level)) < 0.5;
      });
    })) << level;
}

TEST_P(DrawnLabels, LieWithinThePicture) { EXPECT_EQ(drawn(GetParam().number).clipped, Texts()); }

// The formats differ in the size of their letters, which the style alone knows.
TEST(Labels, AreOfNoSizeOfTheirOwn) {
  const std::regex size(R"(font *["'][^"']*,[0-9])");
  int scripts = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(ROTOR_SOURCES "/figures"))
    if (entry.path().extension() == ".gp" && entry.path().stem() != "style") {
      std::ifstream file(entry.path());
      const std::string script{std::istreambuf_iterator<char>(file), {}};
      EXPECT_FALSE(std::regex_search(script, size)) << entry.path();
      ++scripts;
    }
  EXPECT_GT(scripts, 20);
}

// In orbits x_a points downwards, y_a to the right.
TEST_P(DrawnLabels, OfOrbitsHaveTheStatorsAxes) {
  const int number = GetParam().number;
  if (number != 8 && number != 9 && number != 16) return;
  const DrawnPicture picture = drawn(number);
  for (const DrawnCurve& curve : picture.curves) EXPECT_GT(pixel(curve.y, 1), pixel(curve.y, -1));
  EXPECT_GT(pixel(picture.x, 1), pixel(picture.x, -1));
  // Circles are round; the dotted one is the clearance.
  const Tics& down = picture.curves.front().y;
  const double mm = pixel(picture.x, 1) - pixel(picture.x, 0);
  EXPECT_NEAR(pixel(down, 1) - pixel(down, 0), mm, 1e-3 * mm);
  const Parameters& p = GetParam().runs.front().second.parameters;
  ASSERT_FALSE(picture.circles.empty());
  for (const Points& circle : picture.circles)
    for (const auto& [at_x, at_y] : circle)
      EXPECT_NEAR(std::hypot(at_x - pixel(picture.x, 0), at_y - pixel(down, 0)),
                  1e3 * (p.stator_radius - p.rotor_radius) * mm, 0.5);
  // Marked are the first place and that at the mass loss.
  const std::vector<CsvRow> rows = data_of(number);
  const double loss_s = GetParam().runs.front().second.parameters.separation_time;
  const auto at_loss = std::ranges::find_if(
      rows, [&](const CsvRow& row) { return static_cast<double>(row.number("time_s")) == loss_s; });
  ASSERT_NE(at_loss, rows.end());
  for (const CsvRow& row : {rows.front(), *at_loss}) {
    const double x = pixel(picture.x, 1e3 * static_cast<double>(row.number("y_a_m"))),
                 y = pixel(picture.curves.front().y,
                           1e3 * static_cast<double>(row.number("x_a_m")));
    EXPECT_TRUE(std::ranges::any_of(picture.marks, [&](const auto& mark) {
      return std::hypot(mark.first - x, mark.second - y) < 0.1;  // pixels
    })) << row["time_s"];
  }
}

INSTANTIATE_TEST_SUITE_P(Every, DrawnLabels, testing::ValuesIn(paper_figures()),
                         [](const auto& c) { return fmt::format("Fig{:02}", c.param.number); });

// How long the rotors of all maps run.
TEST(MapLabels, SayTheTimeThatTheMapsRunFor) {
  const std::filesystem::path maps(ROTOR_SOURCES "/figures/maps");
  std::ifstream stream(maps / "map.gp");
  const std::string script(std::istreambuf_iterator<char>(stream), {});
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(maps)) {
    if (entry.path().extension() != ".toml") continue;
    const Sweep sweep = read_sweep(entry.path());
    ++count;
    EXPECT_EQ(sweep.base.numbers.at("until"), 0.5) << entry.path();
    for (const char* label :
         {"bouncing after 0.5 s", "sliding after 0.5 s", "undecided after 0.5 s"})
      EXPECT_NE(script.find(label), std::string::npos) << label;
  }
  EXPECT_GT(count, 3);
}

}  // namespace
}  // namespace rotor
