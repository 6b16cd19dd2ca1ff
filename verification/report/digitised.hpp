/// Points read off the printed figures, if somebody has: reference-data/digitised/figNN_curve.csv.
#pragma once

#include "verification/report/curves.hpp"
#include "verification/report/document.hpp"

namespace rotor {

/// A point of a printed figure, in the units of its axes, and what the reading may be off by.
struct ReadPoint {
  std::string run, quantity, unit;
  CurvePoint at, error;
};

/// Throws std::runtime_error, naming file and line, for a point of another figure, without errors,
/// or of a curve that the figure does not have.
std::vector<ReadPoint> read_points(const std::filesystem::path& csv, int figure,
                                   const std::vector<FigureCurve>& curves);

/// From a point to a curve, in units of the reading's errors: up to 1, the curve passes through
/// what the reading leaves open.
double distance_to(const FigureCurve& curve, const ReadPoint& point);

/// Of each file of a figure: how many points, how many of them the curve covers, and how far the
/// farthest one is.
Json digitised_json(const std::filesystem::path& reference_data, int figure,
                    const std::vector<FigureCurve>& curves);

}  // namespace rotor
