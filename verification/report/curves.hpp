/// The curves of a figure, as its data have them, and in words.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rotor {

struct CurvePoint {
  double x, y;
};

/// A quantity of a run over time, or the path of O, in the units of the figure's axes.
struct FigureCurve {
  std::string run, quantity;  ///< names of the data; "orbit" for the path
  std::string words, unit;    ///< of what is drawn upwards
  std::vector<CurvePoint> points;
};

/// Throws std::runtime_error if the file is none of a figure.
std::vector<FigureCurve> read_curves(const std::filesystem::path& csv);

/// What the curve does: where it begins, what it reaches and when, where it ends.
std::string in_words(const FigureCurve& curve);

}  // namespace rotor
