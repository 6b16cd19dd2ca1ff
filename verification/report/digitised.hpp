/// Points read off the printed figures, if there are any: reference-data/digitised/figNN_curve.csv.
#pragma once

#include "verification/report/curves.hpp"
#include "verification/report/document.hpp"

namespace rotor {

/// A point of a printed figure, in the units of its axes, with the errors of reading.
struct ReadPoint {
  std::string run, quantity, unit;
  CurvePoint at, error;
};

/// Throws std::runtime_error, naming file and line, for a point of another figure, without errors,
/// or of a curve that the figure does not have.
std::vector<ReadPoint> read_points(const std::filesystem::path& csv, int figure,
                                   const std::vector<FigureCurve>& curves);

/// Distance from a point to a curve in units of the reading errors: up to 1, the curve agrees with
/// the reading.
double distance_to(const FigureCurve& curve, const ReadPoint& point);

/// For each file of a figure: the number of points, how many agree with the curve, and the largest
/// distance.
Json digitised_json(const std::filesystem::path& reference_data, int figure,
                    const std::vector<FigureCurve>& curves);

}  // namespace rotor
