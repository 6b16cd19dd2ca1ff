/// What figures say in numbers, and where their arrows and schemes point, is what their data say.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <regex>
#include <tuple>

#include "model/simulation/simulation.hpp"
#include "verification/support/figure_drawing.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

using Drawn = PublishedFigures;

// Arrows on orbits point where the rotor goes.
TEST_F(Drawn, OrbitsHaveArrowsInTheSenseOfTheMotion) {
  for (const auto& [number, run, times] : {std::tuple(8, "run", std::array{29.102, -2e-4}),
                                           {9, "event", {29.102, -1e-3}},
                                           {16, "run", {9.408, -0.05}}}) {
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

TEST_F(Drawn, WhirlOfRollingIsTheMeanOverItsWindow) {
  const DrawnPicture picture = drawn(10);
  double turned = 0, x = 0, y = 0, first_s = -1, last_s = 0;
  for (const CsvRow& row : data_of(10)) {
    const auto at_x = static_cast<double>(row.number("x_a_m")),
               at_y = static_cast<double>(row.number("y_a_m"));
    last_s = static_cast<double>(row.number("time_s"));
    if (first_s < 0)
      first_s = last_s;
    else
      turned += std::atan2(x * at_y - y * at_x, x * at_x + y * at_y);
    x = at_x;
    y = at_y;
  }
  const std::string whirl = fmt::format(
      "whirl of O {:.1f} Hz", std::abs(turned) / (2 * std::numbers::pi) / (last_s - first_s));
  EXPECT_TRUE(std::ranges::any_of(picture.texts, [&](const std::string& text) {
    return text.find(whirl) != std::string::npos;
  })) << whirl;
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
  // So does the contact around O_a; the rotor turns about O with the rotation.
  const auto turns = [&](const std::string& name, const std::string& centre) {
    const auto [beside_x, beside_y] = place(name);
    const auto distance = [x = beside_x, y = beside_y](const Arrow& arrow) {
      return std::hypot(arrow.tip.first - x, arrow.tip.second - y);
    };
    const auto [base, tip] = *std::ranges::min_element(picture.arrows, {}, distance);
    const auto [centre_x, centre_y] = place(centre);
    return (tip.first - centre_x) * (tip.second - base.second) -
           (tip.second - centre_y) * (tip.first - base.first);
  };
  // What is dashed leads from K to the opposite point and to the tip of its velocity.
  ASSERT_EQ(picture.dashes.size(), 2U);
  EXPECT_EQ(picture.dashes[0][0], picture.dashes[1][0]);
  EXPECT_LT(std::hypot(picture.dashes[0][0].first - x, picture.dashes[0][0].second - y), 30);
  EXPECT_LT(turns("f", "O"), 0);
  EXPECT_GT(turns("frol", "Oa"), 0);
}

}  // namespace
}  // namespace rotor
