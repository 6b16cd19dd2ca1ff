/// How files get written here: whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace rotor {

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
