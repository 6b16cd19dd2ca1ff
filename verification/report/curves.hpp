/// The curves of a figure from its data, and in words.
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

/// Throws std::runtime_error if the file does not belong to a figure.
std::vector<FigureCurve> read_curves(const std::filesystem::path& csv);

/// Describes the curve: its start, its extremes with their times, and its end.
std::string in_words(const FigureCurve& curve);

}  // namespace rotor
