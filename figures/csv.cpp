#include "figures/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace rotor {
namespace {

std::filesystem::path draft_of(std::filesystem::path file) { return file += ".part"; }

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view reason) {
  throw std::runtime_error(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

}  // namespace

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");  // so that an empty last cell counts
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

std::string to_csv(const std::vector<std::string>& provenance, std::string_view names,
                   const std::vector<const Column*>& columns,
                   const std::vector<NamedTable>& tables) {
  std::string csv;
  const auto end = std::back_inserter(csv);
  for (const std::string& line : provenance) fmt::format_to(end, "# {}\n", line);
  csv += names;
  for (const Column* column : columns) fmt::format_to(end, ",{}", column->name);
  csv += '\n';
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

FileTransaction::~FileTransaction() {
  std::error_code ignored;
  for (const auto& file : files_) std::filesystem::remove(draft_of(file), ignored);
  for (const auto& folder : folders_) std::filesystem::remove(folder, ignored);  // if empty
}

void FileTransaction::write(const std::filesystem::path& file, std::string_view content) {
  std::error_code error;
  for (auto folder = file.parent_path(); !folder.empty() && !std::filesystem::exists(folder);
       folder = folder.parent_path())
    folders_.push_back(folder);
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
  if (error) fail(file, error.message());
  if (std::filesystem::is_directory(file)) fail(file, "it is a directory");
  if (std::ranges::find(files_, file) != files_.end()) fail(file, "it is asked for twice");
  files_.push_back(file);
  std::ofstream stream(draft_of(file), std::ios::binary);
  stream << content << std::flush;
  if (!stream) fail(file, std::strerror(errno));
}

void FileTransaction::commit() {
  for (const auto& file : files_) {
    std::error_code error;
    std::filesystem::rename(draft_of(file), file, error);
    if (error) fail(file, error.message());
  }
  files_.clear();
  folders_.clear();
}

}  // namespace rotor
