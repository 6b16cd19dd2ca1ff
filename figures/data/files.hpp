/// Reads files whole, and writes them whole or not at all.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace rotor {

/// The content of a file, or of a pipe until its end, but not more than the given number of bytes.
/// Throws std::runtime_error with the file and the reason; Interrupted.
std::string read_file(const std::filesystem::path& file, std::size_t most);

/// The name of what is made from a file, in the present folder, unless another is stated. Throws
/// std::runtime_error if the file has no name of its own, such as a pipe.
std::string name_made_from(const std::filesystem::path& file, std::string_view ending);

/// A file that is being written. A regular file is written as a draft in the same folder, which
/// replaces it, with its mode, on commit. Until then no existing file changes; without a commit the
/// draft is removed; if the process is killed, by the next one that writes this file. Links are
/// followed; folders are not created. A device, a pipe or "-", which is standard output, is written
/// directly. Throws std::runtime_error with the file and the reason; ReaderGone.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& file);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void write(std::string_view text);
  /// Passes everything written to the operating system.
  void flush();
  /// Passes it on to the disk, where it survives a power cut.
  void sync();
  void commit();

 private:
  void open_draft();
  void require_folder() const;  ///< of the file
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno() const;

  std::filesystem::path named_;   ///< as stated
  std::filesystem::path target_;  ///< the target of named_
  std::filesystem::path draft_;   ///< empty if the file is written directly
  int descriptor_ = -1;
  std::string buffer_;
};

/// Whether a path leads to an open file or folder; if not, it has been removed or replaced since.
bool is_at(int descriptor, const std::filesystem::path& path);

/// A new hidden file or folder for a draft of what a path names, in the same folder. It is locked
/// while its descriptor is open; an unlocked one of the same name was left by a killed process, and
/// is removed. Throws std::system_error.
struct Draft {
  enum class Kind { file, folder };
  Draft(const std::filesystem::path& of, Kind kind);

  std::filesystem::path path;
  int descriptor = -1;
};

/// Whether a path leads to standard output: "-" or another name for it.
bool is_standard_output(const std::filesystem::path& file);

/// Files that appear together once all have been written.
class FileTransaction {
 public:
  /// The runs may be read from a source, which must not be written.
  explicit FileTransaction(const std::filesystem::path& source = {});

  /// Throws, too, if the file is the source or has been opened already.
  OutputFile& open(const std::filesystem::path& file);
  void write(const std::filesystem::path& file, std::string_view text) { open(file).write(text); }
  void commit();

 private:
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::string source_;
  std::vector<std::string> identities_;  ///< of files_
};

}  // namespace rotor
