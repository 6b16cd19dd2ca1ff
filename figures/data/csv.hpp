/// Comma-separated values.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "figures/data/table.hpp"

namespace rotor {

/// Header row and rows of CSV, below lines of provenance that start with "# ". The first heading
/// is that of the tables' names, the others are those of their columns. Numbers are written with as
/// many digits as it takes to read the same number back; what is not a number stays empty.
std::string to_csv(const std::vector<std::string>& provenance,
                   const std::vector<std::string_view>& headings,
                   const std::vector<NamedTable>& tables);

/// A row of a CSV file. All throw std::runtime_error, naming file and line.
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

}  // namespace rotor
