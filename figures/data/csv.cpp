#include "figures/data/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rotor {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");  // so that an empty last cell counts
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::string to_csv(const std::vector<std::string>& provenance,
                   const std::vector<std::string_view>& headings,
                   const std::vector<NamedTable>& tables) {
  std::string csv;
  const auto end = std::back_inserter(csv);
  for (const std::string& line : provenance) fmt::format_to(end, "# {}\n", line);
  fmt::format_to(end, "{}\n", fmt::join(headings, ","));
  for (const auto& [name, table] : tables)
    for (std::size_t i = 0; i < table.rows(); ++i) {
      csv += name;
      for (const double value : table.row(i)) {
        csv += ',';
        if (!std::isnan(value)) fmt::format_to(end, "{}", value);
      }
      csv += '\n';
    }
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
  } catch (const std::logic_error&) {  // said below
  }
  fail(fmt::format("{}: must be a number, not \"{}\"", heading, cell));
}

void CsvRow::fail(std::string_view reason) const {
  throw std::runtime_error(fmt::format("{}: {}", place_, reason));
}

std::vector<CsvRow> read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  std::vector<CsvRow> rows;
  CsvRow::Headings headings;
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    if (line.starts_with("#")) continue;
    if (!headings)
      headings = std::make_shared<std::vector<std::string>>(cells_of(line));
    else
      rows.emplace_back(fmt::format("{}:{}", file.string(), number), headings, cells_of(line));
  }
  return rows;
}

}  // namespace rotor
