/// Comma-separated files, and how files get written here: whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "figures/recorder.hpp"

namespace rotor {

/// The data of one run, named in the first column of every row.
struct NamedTable {
  std::string run;
  Table table;
};

/// Header row and rows of CSV, below lines of provenance that start with "# ". Numbers are written
/// with as many digits as it takes to read the same number back; what is not a number stays empty.
std::string to_csv(const std::vector<std::string>& provenance,
                   const std::vector<const Column*>& columns,
                   const std::vector<NamedTable>& tables);

/// Files that appear together: each is written beside its place first, and moved there by commit().
/// Without commit() nothing is left behind and nothing existing is touched.
class FileTransaction {
 public:
  FileTransaction() = default;
  FileTransaction(const FileTransaction&) = delete;
  FileTransaction& operator=(const FileTransaction&) = delete;
  ~FileTransaction();

  /// Throws std::runtime_error, naming the file, if it cannot be written.
  void write(const std::filesystem::path& file, std::string_view content);
  void commit();

 private:
  std::vector<std::filesystem::path> files_;
};

}  // namespace rotor
