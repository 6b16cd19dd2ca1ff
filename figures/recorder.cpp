#include "figures/recorder.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <utility>

namespace rotor {

/// A point of a curve that remembers the row it comes from.
struct CurvePoint {
  double x, y;
  std::size_t row;
};

}  // namespace rotor

BOOST_GEOMETRY_REGISTER_POINT_2D(rotor::CurvePoint, double, boost::geometry::cs::cartesian, x, y)

namespace rotor {
namespace {

/// Rounding allowed in the comparison of times with the ends of a window, s.
constexpr double time_rounding = 1e-11;

/// One column, scaled so that its values lie between 0 and 1. A constant column is all zero.
std::vector<double> scaled(const Table& table, std::size_t column) {
  std::vector<double> values(table.rows());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = table.row(i)[column];
  const auto [least, greatest] = std::ranges::minmax(values);
  const double range = greatest > least ? greatest - least : 1;
  for (double& value : values) value = (value - least) / range;
  return values;
}

/// Marks the rows at which the curve y over x has the corners that a polyline through them needs to
/// stay within `tolerance` of it (Douglas-Peucker). What counts is the error of y at a given x,
/// because a scene may draw two columns over each other: x is stretched until distances are errors
/// of y. Done piece by piece, because its time grows faster than a piece's length.
void mark_corners(const std::vector<double>& x, const std::vector<double>& y, double tolerance,
                  std::vector<char>& needed) {
  constexpr std::size_t piece_length = 512;
  constexpr double stretch = 1e5;
  boost::geometry::model::linestring<CurvePoint> piece, corners;
  for (std::size_t begin = 0; begin < y.size(); begin += piece_length) {
    piece.clear();
    corners.clear();
    for (std::size_t row = begin; row < std::min(begin + piece_length + 1, y.size()); ++row)
      piece.push_back({stretch * x[row], y[row], row});
    boost::geometry::simplify(piece, corners, tolerance);
    for (const CurvePoint& corner : corners) needed[corner.row] = true;
  }
}

}  // namespace

Recorder::Recorder(const Window& window, std::vector<const Column*> columns,
                   const Scenario& scenario)
    : window_(window),
      columns_(std::move(columns)),
      ring_(scenario.parameters),
      table_(columns_.size()) {}

void Recorder::operator()(const Instant& at) {
  if (window_.from_rolling_onset) {
    if (at.contact != ContactState::rolling) return;
    window_ = {.from_s = at.time_s, .length_s = window_.length_s};
  }
  const double since = at.time_s - window_.from_s;
  if (since < -time_rounding || since > window_.length_s + time_rounding) return;
  View view(at, ring_);
  for (const Column* column : columns_) table_.add(column->value(view));
}

Table thinned(const Table& table, double tolerance) {
  if (table.rows() == 0) return table;
  std::vector<char> needed(table.rows(), false);
  const std::vector<double> x = scaled(table, 0);
  for (std::size_t column = 1; column < table.columns(); ++column) {
    const std::vector<double> y = scaled(table, column);
    mark_corners(x, y, tolerance, needed);
    // The ends of the range are what annotations quote: they stay to the last digit.
    needed[static_cast<std::size_t>(std::ranges::min_element(y) - y.begin())] = true;
    needed[static_cast<std::size_t>(std::ranges::max_element(y) - y.begin())] = true;
  }
  Table result(table.columns());
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (needed[row])
      for (const double value : table.row(row)) result.add(value);
  return result;
}

}  // namespace rotor
