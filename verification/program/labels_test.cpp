/// What the drawn figures say beside their curves: axes with their units, keys, what the paper
/// states and at which level that is drawn, and numbers that are read off the curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>

#include "model/simulation/simulation.hpp"
#include "verification/support/figure_drawing.hpp"
#include "verification/support/figure_list.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

using Texts = std::vector<std::string>;

/// Written out anew from the paper's text: what a figure shows, and what is stated of it.
struct Labels {
  Texts axes;                    ///< in the order of the panels
  Texts keys;                    ///< of the curves that have one, in their order
  Texts paper;                   ///< what the paper states
  std::vector<double> levels{};  ///< where on the y axis that is
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
      {14, {{rho, time}, {}, {"paper: no contact"}}},
      {15, {{rho, time}, {}, {"paper: no contact"}}},
      {16, {orbit, {"9.3 s", "mass loss", "sense of motion"}, {}}},
      {17,
       {{rho, time},
        {"a", "b"},
        {"paper: 11.8 Hz, which is passed at 2.23 s", "paper: no contact"}}},
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

/// The published figures.
class Drawn : public FigureDrawing {
 protected:
  DrawnPicture drawn(int number) const {
    const Outcome outcome = draw(number, Equations::published);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    return DrawnPicture(content(name_of_figure(number) + ".svg"));
  }
  static void expect_said(const DrawnPicture& picture, const std::string& text) {
    EXPECT_NE(std::ranges::find(picture.texts, text), picture.texts.end()) << text;
  }
};

class DrawnLabels : public Drawn, public testing::WithParamInterface<Figure> {};

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

// Arrows on orbits point where the rotor goes.
TEST_F(Drawn, OrbitsHaveArrowsInTheSenseOfTheMotion) {
  for (const auto& [number, run, times] :
       {std::tuple(8, "run", std::array{29.102, -2e-4}), {9, "event", {29.102, -1e-3}}}) {
    const DrawnPicture picture = drawn(number);
    std::vector<CsvRow> rows = data_of(number);
    std::erase_if(rows, [run = std::string(run)](const CsvRow& row) { return row["run"] != run; });
    const auto place = [&](const CsvRow& row) {
      return std::pair(
          pixel(picture.x, 1e3 * static_cast<double>(row.number("y_a_m"))),
          pixel(picture.curves.front().y, 1e3 * static_cast<double>(row.number("x_a_m"))));
    };
    for (const double time : times) {
      const double time_s =
          time > 0 ? time : static_cast<double>(rows.back().number("time_s")) + time;
      const auto later = std::ranges::find_if(rows, [&](const CsvRow& row) {
        return static_cast<double>(row.number("time_s")) > time_s;
      });
      const std::pair<double, double> here = place(*later), before = place(*(later - 1));
      const double x = here.first, y = here.second;
      const double on_x = x - before.first, on_y = y - before.second;
      EXPECT_TRUE(std::ranges::any_of(
          picture.arrows,
          [&](const auto& arrow) {
            const auto& [base, tip] = arrow;
            const double dx = tip.first - base.first, dy = tip.second - base.second;
            const double along =
                (dx * on_x + dy * on_y) / (std::hypot(dx, dy) * std::hypot(on_x, on_y));
            return std::hypot(tip.first - x, tip.second - y) < 8 && along > 0.9;
          }))
          << number << ' ' << time_s;
    }
  }
}

// Bars to both sides of a point that was read off: as wide and as high as it says.
TEST_F(Drawn, PointsThatWereReadOffHaveTheirErrors) {
  write("points.csv", "run,quantity,x,y,x_error,y_error\nrun,,0,1,0.5,0.1\n");
  const Outcome outcome = draw(8, Equations::published, "points.csv");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const std::string svg = content("fig08.svg");
  const DrawnPicture picture(svg);
  const Tics& y = picture.curves.front().y;
  const std::regex bars(
      R"(M([\d.]+),([\d.]+) L([\d.]+),([\d.]+) M([\d.]+),([\d.]+) L([\d.]+),([\d.]+) )");
  bool is_seen = false;
  for (std::sregex_iterator at(svg.begin(), svg.end(), bars), end; at != end; ++at) {
    const auto n = [&](std::size_t i) { return std::stod((*at)[i]); };
    is_seen = is_seen ||
              (std::abs(n(1) - pixel(picture.x, 0)) < 0.1 &&
               std::abs(std::abs(n(4) - n(2)) - std::abs(pixel(y, 0.2) - pixel(y, 0))) < 0.1 &&
               std::abs(std::abs(n(7) - n(5)) - (pixel(picture.x, 1) - pixel(picture.x, 0))) < 0.1);
  }
  EXPECT_TRUE(is_seen);
}

TEST_F(Drawn, EnergiesOfTheRubAreThoseBetweenItsEvents) {
  const DrawnPicture picture = drawn(6);
  const auto change = [](double joule) { return fmt::format("−{:.0f} J", -joule); };
  const Scenario scenario;  // until 29.35 s
  EventRecorder events;
  run(scenario, events);
  const auto energy = [](const Instant& at) { return kinetic_energy(at.body, at.motion()); };
  const double before = energy(events.before_mass_loss()),
               after = energy(events.first(Event::mass_loss)),
               continuous = energy(events.events(Event::touch_down).at(5)),
               rolling = energy(events.first(Event::rolling_onset));
  expect_said(picture,
              fmt::format("here: {:.0f} J, and {:.0f} J after the mass loss", before, after));
  expect_said(picture, change(continuous - after));
  expect_said(picture, change(rolling - continuous));
  expect_said(picture, fmt::format("{:.0f} J left", rolling));
}

TEST_F(Drawn, GreatestDisplacementIsNamedWithItsTime) {
  const DrawnPicture picture = drawn(2);
  double greatest_mm = 0, time_s = 0;
  for (const CsvRow& row : data_of(2)) {
    const double rho_mm = 1e3 * static_cast<double>(row.number("rho_m"));
    if (rho_mm > greatest_mm) time_s = static_cast<double>(row.number("time_s"));
    greatest_mm = std::max(greatest_mm, rho_mm);
  }
  expect_said(picture, fmt::format("largest ρ = {:.2f} mm at {:.2f} s", greatest_mm, time_s));
}

TEST_F(Drawn, FrequencyOfQ1IsThatOfItsFirstPeriodsOfRolling) {
  const DrawnPicture picture = drawn(7);
  std::vector<double> upwards;
  double onset = -1, time = 0, q1 = 0;
  for (const CsvRow& row : data_of(7)) {
    const auto t = static_cast<double>(row.number("time_s")),
               q = static_cast<double>(row.number("q1_m"));
    if (onset < 0 && row.number("contact_state") == 2) onset = t;
    if (onset > 0 && t > onset && t < onset + 5e-3 && q1 < 0 && q >= 0)
      upwards.push_back(time - q1 * (t - time) / (q - q1));
    time = t;
    q1 = q;
  }
  const auto periods = static_cast<double>(upwards.size() - 1);
  ASSERT_GT(periods, 1);
  expect_said(picture, fmt::format("frequency of q1, first {:.0f} periods of rolling", periods));
  expect_said(picture,
              fmt::format("here: {:.0f} Hz", periods / (upwards.back() - upwards.front())));
}

// In the scheme, from O_a towards K is where O lies: x_a downwards, y_a to the right.
TEST_F(Drawn, SchemeOfRollingHasItsContactWhereTheRotorIs) {
  const DrawnPicture picture = drawn(10);
  const auto place = [&](const std::string& name) {
    const auto at = std::ranges::find(picture.texts, name);
    EXPECT_NE(at, picture.texts.end()) << name;
    return picture.places.at(static_cast<std::size_t>(at - picture.texts.begin()));
  };
  const auto [from_x, from_y] = place("Oa");
  const auto [x, y] = place("K");
  const CsvRow onset = data_of(10).front();
  const auto right = static_cast<double>(onset.number("y_a_m")),
             down = static_cast<double>(onset.number("x_a_m"));
  const double along = ((x - from_x) * right + (y - from_y) * down) /
                       (std::hypot(x - from_x, y - from_y) * std::hypot(right, down));
  EXPECT_GT(along, 0.9);  // labels stand beside what they name
  // O and the rim opposite to K move against the rotation, which is from x_a to y_a.
  const double rho = std::hypot(right, down);
  EXPECT_GE(std::ranges::count_if(
                picture.arrows,
                [&](const auto& arrow) {
                  const auto& [base, tip] = arrow;
                  const double dx = tip.first - base.first, dy = tip.second - base.second;
                  return (-dx * down + dy * right) / (std::hypot(dx, dy) * rho) > 0.99;
                }),
            2);
}

}  // namespace
}  // namespace rotor
