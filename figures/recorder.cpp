#include "figures/recorder.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#include <cmath>
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

Recorder::Recorder(const Window& window, std::vector<const Column*> columns,
                   const Scenario& scenario, double tolerance)
    : window_(window),
      open_(!window.from_rolling_onset),
      columns_(std::move(columns)),
      tolerance_(tolerance),
      context_(scenario),
      table_(columns_.size()),
      least_(columns_.size(), std::numeric_limits<double>::infinity()),
      greatest_(columns_.size(), -std::numeric_limits<double>::infinity()) {}

bool Recorder::contains(double time_s) const {
  const double since = time_s - window_.from_s;
  return open_ && since >= -time_rounding && since <= window_.length_s + time_rounding;
}

void Recorder::see(const Instant& at) {
  if (!open_ && at.contact == ContactState::rolling) {
    window_ = {.from_s = at.time_s, .length_s = window_.length_s};
    open_ = true;
  }
  if (!contains(at.time_s)) return;
  add(row(at));
  View view(at, context_);
  for (const Column* column : columns_)
    if (column->extreme) {
      double& largest = largest_[static_cast<std::size_t>(*column->extreme)];
      largest = std::max(largest, std::abs(column->value(view)));
    }
}

bool Recorder::wants_pieces(const double& from_s, const double& until_s) const {
  return open_ && until_s > window_.from_s && from_s < window_.from_s + window_.length_s;
}

void Recorder::see(const Piece& piece) {
  const double window_end = window_.from_s + window_.length_s;
  const double from = std::max(piece.from_s, window_.from_s);
  const double until = std::min(piece.until_s, window_end);
  if (!(until > from)) return;
  const double share = (until - from) / (piece.until_s - piece.from_s);
  const int parts = static_cast<int>(std::ceil(share * piece.arcs));
  double left_s = from;
  Row left = row(piece.at(left_s));
  add(left);
  for (int n = 1; n <= parts; ++n) {
    const double right_s = n == parts ? until : from + (until - from) * n / parts;
    const Row right = row(piece.at(right_s));
    refine(piece, left_s, left, right_s, right, 0);
    add(right);
    left_s = right_s;
    left = right;
  }
}

void Recorder::refine(const Piece& piece, double from_s, const Row& from, double until_s,
                      const Row& until, int depth) {
  constexpr int least_depth = 1, greatest_depth = 6;  // an arc may bend both ways
  if (depth == greatest_depth) return;
  const double middle_s = (from_s + until_s) / 2;
  const Row middle = row(piece.at(middle_s));
  if (depth > least_depth && is_straight(from, middle, until)) return;
  refine(piece, from_s, from, middle_s, middle, depth + 1);
  add(middle);
  refine(piece, middle_s, middle, until_s, until, depth + 1);
}

bool Recorder::is_straight(const Row& from, const Row& middle, const Row& until) const {
  for (std::size_t i = 0; i < middle.size(); ++i)
    if (std::abs(middle[i] - (from[i] + until[i]) / 2) > tolerance_ * (greatest_[i] - least_[i]))
      return false;
  return true;
}

bool Recorder::wants(Extreme of, const double& bound, const double& from_s,
                     const double& until_s) const {
  if (!wants_pieces(from_s, until_s)) return false;
  return std::ranges::any_of(columns_, [of](const Column* c) { return c->extreme == of; }) &&
         bound > largest_[static_cast<std::size_t>(of)];
}

Recorder::Row Recorder::row(const Instant& at) const {
  View view(at, context_);
  Row values;
  values.reserve(columns_.size());
  for (const Column* column : columns_) values.push_back(column->value(view));
  return values;
}

void Recorder::add(const Row& row) {
  if (row == last_) return;  // where one piece ends and the next begins
  last_ = row;
  for (std::size_t i = 0; i < row.size(); ++i) {
    least_[i] = std::min(least_[i], row[i]);
    greatest_[i] = std::max(greatest_[i], row[i]);
    table_.add(row[i]);
  }
}

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
