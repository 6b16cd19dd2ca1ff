/// Comma-separated files, and how files get written here: whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "figures/recorder.hpp"

namespace rotor {

/// Rows that belong together, all named alike in their first column.
struct NamedTable {
  std::string name;
  Table table;
};

/// Header row and rows of CSV, below lines of provenance that start with "# ". The first column,
/// under the heading `names`, has the names of the tables. Numbers are written with as many digits
/// as it takes to read the same number back; what is not a number stays empty.
std::string to_csv(const std::vector<std::string>& provenance, std::string_view names,
                   const std::vector<const Column*>& columns,
                   const std::vector<NamedTable>& tables);

/// The cells of a line of CSV that quotes nothing.
std::vector<std::string> cells_of(const std::string& line);

/// Files that appear together: each is written beside its place first, and commit() moves them
/// there, one after the other. Without commit() nothing is left behind and nothing existing is
/// touched.
class FileTransaction {
 public:
  FileTransaction() = default;
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;
  ~FileTransaction();

  /// Throws std::runtime_error, naming the file, if it cannot be written or has been already.
  void write(const std::filesystem::path& file, std::string_view content);
  void commit();

 private:
  std::vector<std::filesystem::path> files_, folders_;  // folders that had to be created
};

}  // namespace rotor
