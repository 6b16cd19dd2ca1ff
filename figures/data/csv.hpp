/// Comma-separated values, as RFC 4180 has them, below lines of provenance that start with "#".
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

/// A text as a field: in quotes if it holds anything that would not survive without.
std::string csv_field(std::string_view text);

/// A number as a field, with as many digits as it takes to read the same number back; what is not a
/// number is empty.
std::string csv_field(double value);

/// Lines of provenance and the header row.
std::string csv_head(const std::vector<std::string>& provenance,
                     const std::vector<std::string_view>& headings);

/// A row: a name, then numbers.
std::string csv_row(std::string_view name, std::span<const double> values);

/// Head and rows. The first heading is that of the tables' names, the others are those of their
/// columns.
std::string to_csv(const std::vector<std::string>& provenance,
                   const std::vector<std::string_view>& headings,
                   const std::vector<NamedTable>& tables);

/// A row of a CSV file that has been read. All throw std::runtime_error, naming file and line.
class CsvRow {
 public:
  using Headings = std::shared_ptr<const std::vector<std::string>>;
  CsvRow(std::string place, Headings headings, std::vector<std::string> cells);

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
/// The same of a text, which messages call by that name.
std::vector<CsvRow> read_csv(std::istream& stream, const std::string& name);

}  // namespace rotor
