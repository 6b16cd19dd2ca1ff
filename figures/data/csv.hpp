/// Comma-separated values (RFC 4180), below lines of provenance that start with "#".
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figures/data/table.hpp"

namespace rotor {

/// A text as a field, in quotes if it needs them.
std::string csv_field(std::string_view text);

/// A number as a field, with as many digits as are needed to read the same number back; empty for
/// NaN.
std::string csv_field(double value);

/// Lines of provenance and the header row.
std::string csv_head(const std::vector<std::string>& provenance,
                     const std::vector<std::string_view>& headings);

/// A row: a name, then numbers.
std::string csv_row(std::string_view name, std::span<const double> values);

/// Head and rows. The first heading is for the tables' names, the others are for their columns.
std::string to_csv(const std::vector<std::string>& provenance,
                   const std::vector<std::string_view>& headings,
                   const std::vector<NamedTable>& tables);

/// A row that was read from a CSV file. Throws std::runtime_error with file and line.
class CsvRow {
 public:
  using Headings = std::shared_ptr<const std::vector<std::string>>;
  CsvRow(std::string place, Headings headings, std::vector<std::string> cells);

  const std::vector<std::string>& headings() const { return *headings_; }
  const std::string& operator[](std::string_view heading) const;
  long double number(std::string_view heading) const;
  [[noreturn]] void fail(std::string_view reason) const;

 private:
  std::string place_;  ///< file and line
  Headings headings_;
  std::vector<std::string> cells_;
};

/// The rows of a CSV file below its header row. Lines that start with "#" are skipped.
std::vector<CsvRow> read_csv(const std::filesystem::path& file);
/// The same for a text; messages refer to it by `name`.
std::vector<CsvRow> read_csv(std::istream& stream, const std::string& name);

}  // namespace rotor
