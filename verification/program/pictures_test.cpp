/// The drawn figures: that gnuplot has nothing to complain of, that the curves in the SVG are the
/// data's, and that its numbers are the engine's.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/support/figure_drawing.hpp"
#include "verification/support/figure_list.hpp"
#include "verification/support/summary_of.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

/// What a curve of a picture is, in the order in which they are drawn.
struct Curve {
  std::string run, x, y;
  double x_scale, y_scale;  ///< from the data's units to the axes'
};

std::vector<Curve> curves(const Figure& figure) {
  std::vector<Curve> all;
  const auto over_time = [&](const std::string& run, const std::string& y, double scale) {
    all.push_back({run, "time_s", y, 1, scale});
  };
  const auto orbit = [&](const std::string& run) {
    all.push_back({run, "y_a_m", "x_a_m", 1e3, 1e3});
  };
  const std::vector<std::string> frictions = {"mu = 0.3", "mu = 0.2", "mu = 0.08"};
  switch (figure.number) {
    case 2:
      for (const char* y : {"q1_m", "q2_m", "rho_m"}) over_time("run", y, 1e3);
      break;
    case 3:
      for (const std::string& run : frictions)
        for (const std::string& name : {run + " by rk4", run})
          over_time(name, "normal_force_N", 1e-3);
      break;
    case 4:
      for (const std::string& run : frictions) over_time(run + " by rk4", "speed_Hz", 1);
      for (const std::string& run : frictions) over_time(run, "speed_Hz", 1);
      break;
    case 6:
      over_time("run", "kinetic_energy_J", 1);
      break;
    case 7:
      for (const char* y : {"q1_m", "rho_m"}) over_time("run", y, 1e3);
      break;
    case 8:
    case 16:
      orbit("run");
      break;
    case 9:
      for (const char* run : {"rk4", "event"}) orbit(run);
      break;
    case 10:  // no curve of data
      break;
    case 14:
    case 15:
    case 17:
      for (const auto& [run, scenario] : figure.runs) over_time(run, "rho_m", 1e3);
      break;
    default:  // 5, 11, 12, 13
      for (const auto& [run, scenario] : figure.runs) over_time(run, "normal_force_N", 1e-3);
  }
  return all;
}

/// A whole number with its sign, the minus being the typographer's.
std::string with_sign(double number) {
  return (number < 0 ? "\u2212" : "+") + fmt::format("{:.0f}", std::abs(number));
}

class Pictures : public FigureDrawing,
                 public testing::WithParamInterface<std::tuple<Figure, Equations>> {
 protected:
  const Figure& figure() const { return std::get<0>(GetParam()); }
  Equations equations() const { return std::get<1>(GetParam()); }
  std::string name() const { return name_of_figure(figure().number); }
  Outcome draw(const std::string& points = "") const {
    return FigureDrawing::draw(figure().number, equations(), points);
  }

  std::vector<std::pair<double, double>> data(const Curve& curve) const {
    std::vector<std::pair<double, double>> points;
    for (const CsvRow& row : data_of(figure().number))
      if (row["run"] == curve.run)
        points.emplace_back(static_cast<double>(row.number(curve.x)) * curve.x_scale,
                            static_cast<double>(row.number(curve.y)) * curve.y_scale);
    return points;
  }

  Scenario scenario(std::size_t run) const {
    Scenario scenario = figure().runs[run].second;
    scenario.equations = equations();
    return scenario;
  }

  /// The numbers that the picture is to say, by the engine.
  std::vector<std::string> numbers() const;
  void expect_curves(const DrawnPicture& picture) const;
};

void Pictures::expect_curves(const DrawnPicture& picture) const {
  const std::vector<Curve> expected = curves(figure());
  if (expected.empty()) return;
  ASSERT_EQ(picture.curves.size(), expected.size());
  ASSERT_GE(picture.x.size(), 2U);
  for (std::size_t n = 0; n < expected.size(); ++n) {
    const DrawnCurve& drawn_curve = picture.curves[n];
    ASSERT_GE(drawn_curve.y.size(), 2U);
    const auto points = data(expected[n]);
    ASSERT_GT(points.size(), 1U);
    // At the ends, and where the curve reaches furthest to each side.
    const auto by_x = [](const auto& a, const auto& b) { return a.first < b.first; };
    const auto by_y = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_x);
    const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), by_y);
    for (const auto& at : {points.front(), points.back(), *left, *right, *lowest, *highest}) {
      const double x = pixel(picture.x, at.first), y = pixel(drawn_curve.y, at.second);
      double nearest = 1e9;
      for (const auto& [drawn_x, drawn_y] : drawn_curve.points)
        nearest = std::min(nearest, std::hypot(drawn_x - x, drawn_y - y));
      EXPECT_LT(nearest, 0.5) << expected[n].run << ": " << expected[n].y << " at " << at.first
                              << ", " << at.second;
    }
    const auto [top, bottom] =
        std::minmax_element(drawn_curve.points.begin(), drawn_curve.points.end(), by_y);
    EXPECT_NEAR(
        std::abs(bottom->second - top->second),
        std::abs(pixel(drawn_curve.y, lowest->second) - pixel(drawn_curve.y, highest->second)), 0.5)
        << expected[n].run;
  }
}

std::vector<std::string> Pictures::numbers() const {
  std::vector<Summary> of;
  for (std::size_t n = 0; n < figure().runs.size(); ++n) of.push_back(summary_of(scenario(n)));
  const auto force = [&](std::size_t n) { return of[n].peak_normal_force_N.value_or(0) / 1e3; };
  const auto after_loss_mm = [&](std::size_t n) {
    return 1e3 * of[n].max_displacement_m.value_or(0);
  };
  const auto at_peak = of[0].peak_normal_force_N ? fmt::format("here: {:.1f} kN at {:.4f} s",
                                                               force(0), *of[0].peak_time_s)
                                                 : std::string("here: no contact");
  const double lost_at_Hz = of[0].speed_at_separation_Hz.value_or(0);
  switch (figure().number) {
    case 2:
      return {fmt::format("largest ρ = {:.2f} mm at", 1e3 * of[0].max_displacement_before_loss_m)};
    case 3:
      return {fmt::format("largest |Fn|: {:.1f} kN", force(0)),
              fmt::format("largest |Fn|: {:.1f} kN", force(1)),
              fmt::format("largest |Fn|: {:.1f} kN", force(2))};
    case 5:
      return {at_peak, fmt::format("slipping stops at {:.4f} s", *of[0].rolling_onset_s),
              fmt::format("here: {:.4f} s after the first contact",
                          *of[0].rolling_onset_s - *of[0].first_contact_s)};
    case 7:
      return {fmt::format("from {:.4f} s", *of[0].rolling_onset_s)};
    case 10: {
      const double rho = static_cast<double>(data_of(figure().number).front().number("rho_m"));
      const double rolling_Hz = *of[0].rolling_onset_speed_Hz * 0.06 / rho;  // Eq. (26)
      return {fmt::format("onset of rolling t = {:.5f} s", *of[0].rolling_onset_s),
              fmt::format("f = {:.2f} Hz", *of[0].rolling_onset_speed_Hz),
              fmt::format("frol = f r/ρ = {:.1f} Hz", rolling_Hz),
              fmt::format("vO = {:.2f} m/s", 2 * std::numbers::pi * rolling_Hz * rho)};
    }
    case 11:
      return {fmt::format("largest |Fn|: {:.1f} kN", force(0)),
              fmt::format("{:.1f} kN, {} %", force(1), with_sign(100 * (force(1) / force(0) - 1))),
              fmt::format("{:.1f} kN, {} %", force(2), with_sign(100 * (force(2) / force(0) - 1)))};
    case 12:
    case 13:
      return {at_peak, fmt::format("here: {:.1f} Hz", lost_at_Hz)};
    case 14:
    case 15:
      return {fmt::format("f = {:.1f} Hz", lost_at_Hz),
              fmt::format("here: {:.3f} mm at ", after_loss_mm(0))};
    case 17:
      return {fmt::format("a {:.2f} mm, b {:.2f} mm", after_loss_mm(0),
                          1e3 * of[1].max_displacement_before_loss_m),
              fmt::format("speed at the mass loss: {:.1f} Hz", lost_at_Hz)};
    default:
      return {};
  }
}

// A column that is missing is an error of gnuplot's, and everything else that it says is a warning.
TEST_P(Pictures, ShowTheDataAndSayWhatTheEngineSays) {
  const Outcome drawn = draw();
  ASSERT_EQ(drawn.status, 0) << drawn.output;
  EXPECT_EQ(drawn.output, "");
  const DrawnPicture picture(content(name() + ".svg"));
  expect_curves(picture);
  for (const std::string& number : numbers())
    EXPECT_TRUE(std::any_of(
        picture.texts.begin(), picture.texts.end(),
        [&](const std::string& text) { return text.find(number) != std::string::npos; }))
        << number;
}

// Each point stands once, in the panel of its run and quantity, and where it was read off.
TEST_P(Pictures, ShowPointsThatWereReadOffThePrintedOne) {
  const std::vector<Curve> drawn = curves(figure());
  if (drawn.empty()) return;  // a scheme
  ASSERT_EQ(draw().status, 0);
  const DrawnPicture without(content(name() + ".svg"));
  std::string table = "run,quantity,x,y,x_error,y_error\n";
  Points places;
  for (std::size_t n = 0; n < drawn.size(); ++n) {
    if (drawn[n].run.ends_with("rk4")) continue;
    const auto points = data(drawn[n]);
    const auto& [x, y] = points[points.size() / 2];
    table += fmt::format("{},{},{},{},0,0\n", drawn[n].run, drawn[n].y, x, y);
    places.emplace_back(pixel(without.x, x), pixel(without.curves[n].y, y));
  }
  write("points.csv", table);
  const Outcome with_points = draw("points.csv");
  ASSERT_EQ(with_points.status, 0) << with_points.output;
  EXPECT_EQ(with_points.output, "");
  const DrawnPicture picture(content(name() + ".svg"));
  // Once each, and once in the key of each panel.
  const auto keys = std::count(picture.texts.begin(), picture.texts.end(), "printed");
  EXPECT_EQ(picture.squares.size(), places.size() + static_cast<std::size_t>(keys));
  for (const auto& [x, y] : places)
    EXPECT_TRUE(std::any_of(picture.squares.begin(), picture.squares.end(),
                            [&, at_x = x, at_y = y](const auto& square) {
                              return std::hypot(square.first - at_x, square.second - at_y) < 0.5;
                            }))
        << x << ", " << y;
}

std::string name_of_case(const testing::TestParamInfo<Pictures::ParamType>& c) {
  const auto& [figure, equations] = c.param;
  return fmt::format("Fig{:02}{}", figure.number,
                     equations == Equations::published ? "Published" : "Consistent");
}

INSTANTIATE_TEST_SUITE_P(Every, Pictures,
                         testing::Combine(testing::ValuesIn(paper_figures()),
                                          testing::Values(Equations::published,
                                                          Equations::consistent)),
                         name_of_case);

}  // namespace
}  // namespace rotor
