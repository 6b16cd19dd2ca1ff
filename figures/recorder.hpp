/// Records the columns that are asked for, inside the window that is asked for.
#pragma once

#include <array>
#include <boost/container/small_vector.hpp>
#include <limits>
#include <span>
#include <vector>

#include "figures/columns.hpp"
#include "model/scenario.hpp"

namespace rotor {

/// Largest distance between a thinned curve and the full one, in parts of the picture's height: a
/// fifth of a pixel in a picture 1000 pixels high.
inline constexpr double thinning = 2e-4;

/// As close as a recorded curve is to the motion before it is thinned, in parts of the same.
inline constexpr double sampling = thinning / 2;

/// The part of a run that is recorded: from a given time on, or from the onset of rolling on.
struct Window {
  double from_s = 0;
  bool from_rolling_onset = false;  ///< if so, from_s does not count
  double length_s = std::numeric_limits<double>::infinity();
};

/// Rows of numbers, one after the other.
class Table {
 public:
  explicit Table(std::size_t columns) : columns_(columns) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return values_.size() / columns_; }
  std::span<const double> row(std::size_t i) const { return {&values_[i * columns_], columns_}; }
  void add(double value) { values_.push_back(value); }

 private:
  std::size_t columns_;
  std::vector<double> values_;
};

class Recorder : public Observer {
 public:
  /// Between the rows, each column is within `tolerance` of the motion where that is known, in
  /// parts of the column's range so far.
  Recorder(const Window& window, std::vector<const Column*> columns, const Scenario& scenario,
           double tolerance);

  void see(const Instant& at) override;
  bool wants_pieces(const double& from_s, const double& until_s) const override;
  void see(const Piece& piece) override;
  bool wants(Extreme of, const double& bound, const double& from_s,
             const double& until_s) const override;

  const Table& table() const { return table_; }

 private:
  using Row = boost::container::small_vector<double, 8>;

  bool contains(double time_s) const;
  Row row(const Instant& at) const;
  void add(const Row& row);
  /// Rows between two that are known, where a straight line would miss the motion.
  void refine(const Piece& piece, double from_s, const Row& from, double until_s, const Row& until,
              int depth);
  bool is_straight(const Row& from, const Row& middle, const Row& until) const;

  Window window_;
  bool open_;  ///< whether it is known where the window begins
  std::vector<const Column*> columns_;
  double tolerance_;
  ColumnContext context_;
  Table table_;
  Row last_;
  Row least_, greatest_;             ///< of each column so far
  std::array<double, 2> largest_{};  ///< of each Extreme so far
};

/// The table with only those rows that its curves need: interpolated over its first column, which
/// must not fall, each of the other columns stays within `tolerance`, in parts of its range, of its
/// values in the full table.
Table thinned(const Table& table, double tolerance);

}  // namespace rotor
