#include "figures/data/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

/// Skips lines of provenance. Counts lines.
void skip_comments(std::istream& stream, int& line) {
  std::string ignored;
  for (; stream.peek() == '#'; ++line) std::getline(stream, ignored);
}

/// The cells of the next row. Counts lines.
std::vector<std::string> next_row(std::istream& stream, int& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (char c = 0; stream.get(c);) {
    if (c == '\n') ++line;
    if (c == '"' && quoted && stream.peek() == '"')
      cells.back() += static_cast<char>(stream.get());
    else if (c == '"')
      quoted = !quoted;
    else if (quoted || (c != ',' && c != '\n'))
      cells.back() += c;
    else if (c == ',')
      cells.emplace_back();
    else
      break;
  }
  return cells;
}

void read_rows(std::istream& stream, const std::string& name,
               const std::function<void(const CsvRow&)>& take) {
  int next_line = 1;
  skip_comments(stream, next_line);
  const auto headings = std::make_shared<std::vector<std::string>>(next_row(stream, next_line));
  for (;;) {
    skip_comments(stream, next_line);
    if (stream.peek() == std::istream::traits_type::eof()) break;
    const int line = next_line;
    take({fmt::format("{}:{}", name, line), headings, next_row(stream, next_line)});
  }
  if (stream.bad()) throw std::runtime_error(fmt::format("{}: cannot be read", name));
}

}  // namespace

std::string csv_field(std::string_view text) {
  const bool plain = std::none_of(text.begin(), text.end(), [](char c) {
    return c == ',' || c == '"' || c == '#' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
  });
  if (plain) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

std::string csv_field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string csv_head(const std::vector<std::string>& provenance,
                     const std::vector<std::string_view>& headings) {
  std::string head;
  for (const std::string& line : provenance) head += "# " + one_line(line) + '\n';
  return head + fmt::format("{}\n", fmt::join(headings, ","));
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

CsvRow::CsvRow(std::string place, Headings headings, std::vector<std::string> cells)
    : place_(std::move(place)), headings_(std::move(headings)), cells_(std::move(cells)) {
  if (cells_.size() != headings_->size())
    fail(fmt::format("has {} columns; there must be {}", cells_.size(), headings_->size()));
}

const std::string& CsvRow::operator[](std::string_view heading) const {
  const auto found = std::find(headings_->begin(), headings_->end(), heading);
  if (found == headings_->end()) fail(fmt::format("there is no column {}", heading));
  return cells_[static_cast<std::size_t>(found - headings_->begin())];
}

long double CsvRow::number(std::string_view heading) const {
  const std::string& cell = (*this)[heading];
  try {
    std::size_t length = 0;
    const long double value = std::stold(cell, &length);
    if (length == cell.size()) return value;
  } catch (const std::logic_error&) {  // reported below
  }
  fail(fmt::format("{}: must be a number, not \"{}\"", heading, cell));
}

void CsvRow::fail(std::string_view reason) const {
  throw std::runtime_error(fmt::format("{}: {}", place_, reason));
}

void read_csv(const std::filesystem::path& file, const std::function<void(const CsvRow&)>& take) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  read_rows(stream, file.string(), take);
}

std::vector<CsvRow> read_csv(const std::filesystem::path& file) {
  std::vector<CsvRow> rows;
  read_csv(file, [&](const CsvRow& row) { rows.push_back(row); });
  return rows;
}

std::vector<CsvRow> read_csv(std::istream& stream, const std::string& name) {
  std::vector<CsvRow> rows;
  read_rows(stream, name, [&](const CsvRow& row) { rows.push_back(row); });
  return rows;
}

}  // namespace rotor
