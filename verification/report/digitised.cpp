#include "verification/report/digitised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/data/csv.hpp"

namespace rotor {
namespace {

/// A point of a printed figure, in the units of its axes, and what the reading may be off by.
struct ReadPoint {
  std::string run, quantity, unit;
  CurvePoint at, error;
};

const FigureCurve* find(const std::vector<FigureCurve>& curves, const ReadPoint& point) {
  const auto found = std::ranges::find_if(curves, [&](const FigureCurve& curve) {
    return curve.run == point.run && curve.quantity == point.quantity;
  });
  return found == curves.end() ? nullptr : &*found;
}

/// From the origin to a straight line between two points.
double distance_to_origin(const CurvePoint& a, const CurvePoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(-(a.x * dx + a.y * dy) / square, 0., 1.) : 0;
  return std::hypot(a.x + along * dx, a.y + along * dy);
}

/// In units of the reading's errors: up to 1, the curve passes through what the reading leaves
/// open.
double distance_to(const FigureCurve& curve, const ReadPoint& point) {
  const auto scaled = [&](const CurvePoint& p) {
    return CurvePoint{(p.x - point.at.x) / point.error.x, (p.y - point.at.y) / point.error.y};
  };
  double least = std::hypot(scaled(curve.points.front()).x, scaled(curve.points.front()).y);
  for (std::size_t n = 1; n < curve.points.size(); ++n)
    least =
        std::min(least, distance_to_origin(scaled(curve.points[n - 1]), scaled(curve.points[n])));
  return least;
}

std::vector<ReadPoint> read_points(const std::filesystem::path& csv, int figure,
                                   const std::vector<FigureCurve>& curves) {
  std::vector<ReadPoint> points;
  for (const CsvRow& row : read_csv(csv)) {
    const auto number = [&](const char* column) { return static_cast<double>(row.number(column)); };
    const ReadPoint point{row["run"],
                          row["quantity"],
                          row["unit"],
                          {number("x"), number("y")},
                          {number("x_error"), number("y_error")}};
    if (number("figure") != figure) row.fail(fmt::format("is not of Fig. {}", figure));
    if (!(point.error.x > 0 && point.error.y > 0)) row.fail("the reading's errors must be > 0");
    const FigureCurve* curve = find(curves, point);
    if (!curve) {
      std::string known;
      for (const FigureCurve& one : curves)
        known += fmt::format("{}{}, {}", known.empty() ? "" : "; ", one.run, one.quantity);
      row.fail(fmt::format("Fig. {} has no curve of {}, {}; it has: {}", figure, point.run,
                           point.quantity, known));
    }
    if (point.unit != curve->unit) row.fail("the axis is in " + curve->unit);
    points.push_back(point);
  }
  return points;
}

}  // namespace

Json digitised_json(const std::filesystem::path& reference_data, int figure,
                    const std::vector<FigureCurve>& curves) {
  std::vector<std::filesystem::path> files;
  const auto folder = reference_data / "digitised";
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().filename().string().starts_with(fmt::format("fig{:02}_", figure)))
        files.push_back(entry.path());
  std::ranges::sort(files);
  Json all = Json::array();
  for (const auto& file : files) {
    const std::vector<ReadPoint> points = read_points(file, figure, curves);
    long covered = 0;
    double farthest = 0;
    for (const ReadPoint& point : points) {
      const double distance = distance_to(*find(curves, point), point);
      covered += distance <= 1;
      farthest = std::max(farthest, distance);
    }
    all.push_back({{"file", file.filename().string()},
                   {"points", points.size()},
                   {"covered", covered},
                   {"farthest", farthest}});
  }
  return all;
}

}  // namespace rotor
