#include "figures/data/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <istream>
#include <stdexcept>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

/// Splits a text into the cells of its rows.
class CsvReader {
 public:
  explicit CsvReader(std::istream& stream) : stream_(stream) {}

  /// The cells of the next row, none at the end.
  std::vector<std::string> next() {
    std::vector<std::string> cells;
    while (stream_.peek() == '#') skip_line();
    if (stream_.peek() == std::istream::traits_type::eof()) return cells;
    line_ = next_line_;
    do cells.push_back(cell());
    while (last_ == ',');
    return cells;
  }

  int line() const { return line_; }  ///< of the row that was read last

 private:
  void skip_line() {
    std::string ignored;
    std::getline(stream_, ignored);
    ++next_line_;
  }

  std::string cell() {
    std::string text;
    bool quoted = false;
    for (char c = 0; stream_.get(c);) {
      if (c == '\n') ++next_line_;
      if (c == '"' && quoted && stream_.peek() == '"') {
        text += static_cast<char>(stream_.get());
      } else if (c == '"') {
        quoted = !quoted;
      } else if (!quoted && (c == ',' || c == '\n')) {
        last_ = c;
        return text;
      } else {
        text += c;
      }
    }
    last_ = '\n';
    return text;
  }

  std::istream& stream_;
  int line_ = 0, next_line_ = 1;
  char last_ = '\n';  ///< what ended the last cell
};

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

std::string to_csv(const std::vector<std::string>& provenance,
                   const std::vector<std::string_view>& headings,
                   const std::vector<NamedTable>& tables) {
  std::string csv = csv_head(provenance, headings);
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

std::vector<CsvRow> read_csv(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  return read_csv(stream, file.string());
}

std::vector<CsvRow> read_csv(std::istream& stream, const std::string& name) {
  CsvReader reader(stream);
  const auto headings = std::make_shared<std::vector<std::string>>(reader.next());
  std::vector<CsvRow> rows;
  for (auto cells = reader.next(); !cells.empty(); cells = reader.next())
    rows.emplace_back(fmt::format("{}:{}", name, reader.line()), headings, std::move(cells));
  return rows;
}

}  // namespace rotor
