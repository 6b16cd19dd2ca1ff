/// Rows of numbers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace rotor {

/// Rows of numbers, one after the other.
class Table {
 public:
  explicit Table(std::size_t columns) : columns_(columns) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return values_.size() / columns_; }
  std::span<const double> row(std::size_t i) const { return {&values_[i * columns_], columns_}; }
  void add(double value) { values_.push_back(value); }
  void add(std::span<const double> row) { values_.insert(values_.end(), row.begin(), row.end()); }

 private:
  std::size_t columns_;
  std::vector<double> values_;
};

/// Rows with the same name in their first column.
struct NamedTable {
  std::string name;
  Table table;
};

}  // namespace rotor
