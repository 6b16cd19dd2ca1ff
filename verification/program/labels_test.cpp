/// That no text of a picture is cut off, and that orbits have the stator's axes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/support/figure_drawing.hpp"
#include "verification/support/figure_list.hpp"
#include "verification/support/svg_picture.hpp"

namespace rotor {
namespace {

class DrawnLabels : public PublishedFigures, public testing::WithParamInterface<Figure> {};

TEST_P(DrawnLabels, LieWithinThePicture) { EXPECT_TRUE(drawn(GetParam().number).clipped.empty()); }

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

}  // namespace
}  // namespace rotor
