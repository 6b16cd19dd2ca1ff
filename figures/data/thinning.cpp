#include "figures/data/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rotor {
namespace {

/// The first rows with a column's least and greatest value.
struct Range {
  std::size_t least = 0, greatest = 0;

  Range(const Table& table, std::size_t column) {
    const auto at = [&](std::size_t row) { return table.row(row)[column]; };
    for (std::size_t row = 1; row < table.rows(); ++row) {
      const bool is_first = std::isnan(at(least)) && !std::isnan(at(row));
      if (is_first || at(row) < at(least)) least = row;
      if (is_first || at(row) > at(greatest)) greatest = row;
    }
  }
};

/// One column, scaled so that its values lie between 0 and 1. A constant column and NaN become
/// zero.
std::vector<double> scaled(const Table& table, std::size_t column, const Range& range) {
  const double least = table.row(range.least)[column],
               length = table.row(range.greatest)[column] - least;
  std::vector<double> values(table.rows());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const double value = table.row(i)[column]; length > 0 && !std::isnan(value))
      values[i] = (value - least) / length;
  return values;
}

/// Marks the rows before and after each gap, where the column is NaN.
void mark_gaps(const Table& table, std::size_t column, std::vector<char>& needed) {
  for (std::size_t i = 1; i < table.rows(); ++i)
    if (std::isnan(table.row(i)[column]) != std::isnan(table.row(i - 1)[column]))
      needed[i - 1] = needed[i] = true;
}

/// Curves over a common x, all of them between 0 and 1.
struct Curves {
  std::vector<double> x;
  std::vector<std::vector<double>> all;

  /// The largest distance of a row, over all curves, from the lines between two others.
  double distance(std::size_t row, std::size_t from, std::size_t until) const {
    const double length = x[until] - x[from];
    const double part = length > 0 ? (x[row] - x[from]) / length : 0;
    double largest = 0;
    for (const std::vector<double>& y : all)
      largest = std::max(largest, std::abs(y[row] - y[from] - part * (y[until] - y[from])));
    return largest;
  }
};

/// Marks the rows needed between two others so that straight lines stay within `tolerance` of all
/// curves (Douglas-Peucker, for all curves at once: a corner of one curve would otherwise bend the
/// lines of the others). The error is measured at a given x, because a scene may draw two columns
/// over each other.
void mark_corners(const Curves& curves, std::size_t first, std::size_t last, double tolerance,
                  std::vector<char>& needed) {
  std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [from, until] = open.back();
    open.pop_back();
    double largest = tolerance;
    std::size_t corner = from;
    for (std::size_t row = from + 1; row < until; ++row)
      if (const double off = curves.distance(row, from, until); off > largest) {
        largest = off;
        corner = row;
      }
    if (corner == from) continue;
    needed[corner] = true;
    open.emplace_back(from, corner);
    open.emplace_back(corner, until);
  }
}

}  // namespace

Table thinned(const Table& table, double tolerance) {
  if (table.rows() == 0) return table;
  Curves curves{scaled(table, 0, Range(table, 0)), {}};
  std::vector<char> needed(table.rows(), false);
  for (std::size_t column = 1; column < table.columns(); ++column) {
    const Range range(table, column);
    curves.all.push_back(scaled(table, column, range));
    mark_gaps(table, column, needed);
    // Annotations quote the ends of the range: these rows are kept exactly.
    needed[range.least] = needed[range.greatest] = true;
  }
  // Piece by piece, because the time needed grows faster than the length of a piece.
  constexpr std::size_t piece_length = 512;
  for (std::size_t row = 0; row < table.rows(); row += piece_length) needed[row] = true;
  needed.back() = true;
  std::size_t last = 0;
  for (std::size_t row = 1; row < table.rows(); ++row)
    if (needed[row]) mark_corners(curves, std::exchange(last, row), row, tolerance, needed);

  Table result(table.columns());
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (needed[row]) result.add(table.row(row));
  return result;
}

}  // namespace rotor
