#include "figures/data/thinning.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <cmath>
#include <limits>

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

/// One column, scaled so that its values lie between 0 and 1. A constant column is all zero; what
/// is not a number is zero as well.
std::vector<double> scaled(const Table& table, std::size_t column) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double value = table.row(i)[column];
    if (value < least) least = value;
    if (value > greatest) greatest = value;
  }
  const double range = greatest > least ? greatest - least : 1;
  std::vector<double> values(table.rows());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double value = table.row(i)[column];
    values[i] = std::isnan(value) ? 0 : (value - least) / range;
  }
  return values;
}

/// Marks the rows before and after each gap, where the column is not a number.
void mark_gaps(const Table& table, std::size_t column, std::vector<char>& needed) {
  for (std::size_t i = 1; i < table.rows(); ++i)
    if (std::isnan(table.row(i)[column]) != std::isnan(table.row(i - 1)[column]))
      needed[i - 1] = needed[i] = true;
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

Table thinned(const Table& table, double tolerance) {
  if (table.rows() == 0) return table;
  std::vector<char> needed(table.rows(), false);
  const std::vector<double> x = scaled(table, 0);
  for (std::size_t column = 1; column < table.columns(); ++column) {
    const std::vector<double> y = scaled(table, column);
    mark_corners(x, y, tolerance, needed);
    mark_gaps(table, column, needed);
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
