/// Points read off the printed figures, if there are any: reference-data/digitised/figNN_curve.csv.
#pragma once

#include "verification/report/curves.hpp"
#include "verification/report/document.hpp"

namespace rotor {

/// For each file of a figure: the number of points, how many agree with the curve, and the largest
/// distance in units of the reading errors. Throws std::runtime_error, naming file and
/// line, for a point of another figure, without errors, or of a curve that the figure does not
/// have.
Json digitised_json(const std::filesystem::path& reference_data, int figure,
                    const std::vector<FigureCurve>& curves);

}  // namespace rotor
