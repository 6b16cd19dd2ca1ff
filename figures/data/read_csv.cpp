#include "figures/data/read_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

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

std::vector<std::string> csv_cells(std::string_view row) {
  std::istringstream stream{std::string(row)};
  int line = 1;
  return next_row(stream, line);
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
