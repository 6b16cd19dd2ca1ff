/// Writes files whole or not at all.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

/// A file that is being written. A regular one is written as a draft in the same folder, which
/// replaces it, with its mode, when it is committed; before that nothing existing is touched, and
/// without it nothing is left behind, unless the process is killed. Links are followed; no folder
/// is created. A device or a pipe is written straight away; so is "-", which is standard output.
/// All throw std::runtime_error, naming the file and the reason.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& file);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  /// After this, all that was written has left the program.
  void flush();
  /// After this, it survives a power cut.
  void sync();
  void commit();

 private:
  void open_draft();
  void require_folder() const;  ///< that the file is to be in
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno() const;

  std::filesystem::path named_;   ///< as it was asked for
  std::filesystem::path target_;  ///< what that leads to
  std::filesystem::path draft_;   ///< empty if it is written straight away
  int descriptor_ = -1;
  std::string buffer_;
};

/// Whether a path leads to standard output: "-", or another name of it.
bool is_standard_output(const std::filesystem::path& file);

/// Files that appear together, when all have been written.
class FileTransaction {
 public:
  /// To be called before any work, for the files that will be opened: throws if two are the same.
  static void require_distinct(const std::vector<std::filesystem::path>& files,
                               const std::filesystem::path& source = {});

  OutputFile& open(const std::filesystem::path& file);
  void write(const std::filesystem::path& file, std::string_view text) { open(file).write(text); }
  void write_to_all(std::string_view text);
  void commit();

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
};

}  // namespace rotor
