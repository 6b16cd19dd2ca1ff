#include "figures/data/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

/// A line that no spreadsheet takes for a formula where it splits the line.
std::string without_formulas(std::string_view text) {
  std::string line;
  for (const char c : one_line(text)) {
    if (begins_formula(c) && (line.ends_with(',') || line.ends_with(';'))) line += ' ';
    line += c;
  }
  return line;
}

}  // namespace

bool begins_formula(char c) { return contains(std::string_view("=+-@"), c); }

std::string csv_field(std::string_view text) {
  const bool plain = std::none_of(text.begin(), text.end(), [](char c) {
    return c == ',' || c == '"' || c == '#' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (plain) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

std::string csv_head(const std::vector<std::string>& provenance,
                     const std::vector<std::string_view>& headings) {
  std::string head;
  for (const std::string& line : provenance) head += "# " + without_formulas(line) + '\n';
  return head + fmt::format("{}\n", fmt::join(headings, ","));
}

std::size_t start_of_header_row(std::string_view head) {
  return head.rfind('\n', head.size() - 2) + 1;  // it ends with one
}

std::string csv_row(std::string_view name, std::span<const double> values) {
  std::string row = csv_field(name);
  for (const double value : values) {
    row += ',';
    if (!std::isnan(value)) fmt::format_to(std::back_inserter(row), "{}", value);
  }
  return row + '\n';
}

std::string csv_rows(const std::vector<NamedTable>& tables) {
  std::string csv;
  for (const auto& [name, table] : tables)
    for (std::size_t i = 0; i < table.rows(); ++i) csv += csv_row(name, table.row(i));
  return csv;
}

}  // namespace rotor
