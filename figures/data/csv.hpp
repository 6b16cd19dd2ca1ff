/// Tables of numbers, and comma-separated values (RFC 4180), below lines of provenance that start
/// with "#".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
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

/// Whether spreadsheets take a field that begins so for a formula.
bool begins_formula(char c);

/// A text as a field, in quotes if it needs them.
std::string csv_field(std::string_view text);

/// Lines of provenance and the header row.
std::string csv_head(const std::vector<std::string>& provenance,
                     const std::vector<std::string_view>& headings);

/// Where its header row begins.
std::size_t start_of_header_row(std::string_view head);

/// A row: a name, then numbers, with as many digits as are needed to read them back; NaN is empty.
std::string csv_row(std::string_view name, std::span<const double> values);

std::string csv_rows(const std::vector<NamedTable>& tables);

}  // namespace rotor
