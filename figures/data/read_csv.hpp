/// Reads comma-separated values (RFC 4180), below lines of provenance that start with "#".
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

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

/// The cells of one row, with or without its line end.
std::vector<std::string> csv_cells(std::string_view row);

/// The rows of a CSV file below its header row, one after the other. Lines that start with "#" are
/// skipped.
void read_csv(const std::filesystem::path& file, const std::function<void(const CsvRow&)>& take);
std::vector<CsvRow> read_csv(const std::filesystem::path& file);
/// The same for a text; messages refer to it by `name`.
std::vector<CsvRow> read_csv(std::istream& stream, const std::string& name);

}  // namespace rotor
