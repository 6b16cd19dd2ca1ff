#include "verification/report/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "figures/data/csv.hpp"
#include "model/mechanics/parameters.hpp"

namespace rotor {
namespace {

/// How figures show a column.
struct Shown {
  std::string_view column, words, unit;
  double scale;
};
constexpr std::array shown_columns = {Shown{"q1_m", "coordinate q1", "mm", 1e3},
                                      Shown{"q2_m", "coordinate q2", "mm", 1e3},
                                      Shown{"rho_m", "displacement rho", "mm", 1e3},
                                      Shown{"normal_force_N", "normal force", "kN", 1e-3},
                                      Shown{"kinetic_energy_J", "kinetic energy", "J", 1},
                                      Shown{"speed_Hz", "rotation speed", "Hz", 1}};

/// The header row of a CSV.
std::string header_of(const std::filesystem::path& csv) {
  std::ifstream file(csv);
  for (std::string line; std::getline(file, line);)
    if (!line.starts_with('#')) return line;
  throw std::runtime_error(csv.string() + " has no header row");
}

double number(const CsvRow& row, std::string_view column) {
  return static_cast<double>(row.number(column));
}

FigureCurve& curve_of(std::vector<FigureCurve>& all, const std::string& run,
                      std::string_view quantity) {
  const auto found = std::ranges::find_if(all, [&](const FigureCurve& curve) {
    return curve.run == run && curve.quantity == quantity;
  });
  return found != all.end()
             ? *found
             : all.emplace_back(
                   FigureCurve{run, std::string(quantity), "path of the rotor's centre", "mm", {}});
}

std::string length_of(const CurvePoint& from_centre) {
  return fmt::format("{:.2f} mm", std::hypot(from_centre.x, from_centre.y));
}

/// Turns about the centre with the rotation, and against it. On the page y_a points to the right
/// and x_a down, so that the rotation, from x_a to y_a, is positive here.
std::array<double, 2> turns(const std::vector<CurvePoint>& path) {
  std::array<double, 2> sums{};
  for (std::size_t n = 1; n < path.size(); ++n) {
    const CurvePoint &a = path[n - 1], &b = path[n];
    const double angle = std::atan2(a.y * b.x - a.x * b.y, a.x * b.x + a.y * b.y);
    sums[angle < 0] += std::abs(angle) / two_pi;
  }
  return sums;
}

std::string path_in_words(const FigureCurve& curve) {
  const auto farthest = std::ranges::max_element(
      curve.points, {}, [](const CurvePoint& point) { return std::hypot(point.x, point.y); });
  const auto [along, against] = turns(curve.points);
  return fmt::format(
      "it begins {} from the centre, reaches out to {} and ends at {}, after {:.1f} turns with the "
      "rotation and {:.1f} against it",
      length_of(curve.points.front()), length_of(*farthest), length_of(curve.points.back()), along,
      against);
}

long contacts(const std::vector<CurvePoint>& force) {
  long count = 0;
  for (std::size_t n = 0; n < force.size(); ++n)
    count += force[n].y < 0 && (n == 0 || force[n - 1].y == 0);
  return count;
}

std::string force_in_words(const FigureCurve& curve) {
  const long times = contacts(curve.points);
  if (times == 0) return "it stays zero: there is no contact";
  const CurvePoint peak = *std::ranges::min_element(curve.points, {}, &CurvePoint::y);
  return fmt::format(
      "zero until {:.4f} s, then {} contacts; its magnitude is greatest, {:.1f} kN, at {:.4f} s, "
      "and "
      "{:.1f} kN at the end",
      std::ranges::find_if(curve.points, [](const CurvePoint& p) { return p.y < 0; })->x, times,
      -peak.y, peak.x, -curve.points.back().y);
}

}  // namespace

std::vector<FigureCurve> read_curves(const std::filesystem::path& csv) {
  const std::string header = header_of(csv);
  const bool is_path = header.find("x_a_m") != std::string::npos;
  std::vector<Shown> columns;
  // Where displacement or force are shown, the speed is there for the captions.
  for (const Shown& column : shown_columns)
    if (header.find(column.column) != std::string::npos &&
        (column.column != "speed_Hz" || columns.empty()))
      columns.push_back(column);
  std::vector<FigureCurve> curves;
  for (const CsvRow& row : read_csv(csv)) {
    if (is_path) {
      curve_of(curves, row["run"], "orbit")
          .points.push_back({1e3 * number(row, "y_a_m"), 1e3 * number(row, "x_a_m")});
      continue;
    }
    for (const Shown& column : columns) {
      FigureCurve& curve = curve_of(curves, row["run"], column.column);
      curve.words = column.words;
      curve.unit = column.unit;
      curve.points.push_back({number(row, "time_s"), column.scale * number(row, column.column)});
    }
  }
  return curves;
}

std::string in_words(const FigureCurve& curve) {
  if (curve.quantity == "orbit") return path_in_words(curve);
  if (curve.quantity == "normal_force_N") return force_in_words(curve);
  const auto [least, greatest] = std::ranges::minmax_element(curve.points, {}, &CurvePoint::y);
  const auto& unit = curve.unit;
  return fmt::format(
      "from {:.4g} {} at {:g} s to {:.4g} {} at {:g} s; greatest {:.4g} {} at {:.4f} s, least "
      "{:.4g} "
      "{} at {:.4f} s",
      curve.points.front().y, unit, curve.points.front().x, curve.points.back().y, unit,
      curve.points.back().x, greatest->y, unit, greatest->x, least->y, unit, least->x);
}

}  // namespace rotor
