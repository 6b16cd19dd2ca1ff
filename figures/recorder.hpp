/// Records the columns that are asked for, inside the window that is asked for.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "figures/columns.hpp"
#include "model/scenario.hpp"

namespace rotor {

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

class Recorder {
 public:
  Recorder(const Window& window, std::vector<const Column*> columns, const Scenario& scenario);

  /// Takes the instants of a run in order.
  void operator()(const Instant& at);
  const Table& table() const { return table_; }

 private:
  Window window_;
  std::vector<const Column*> columns_;
  Ring<double> ring_;
  Table table_;
};

/// The table with only those rows that its curves need: interpolated over its first column, each of
/// the other columns stays within `tolerance`, in parts of its range, of its values in the full
/// table.
Table thinned(const Table& table, double tolerance);

}  // namespace rotor
