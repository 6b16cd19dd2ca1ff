/// The results of a sweep up to now, in a file next to the output. A sweep that was killed resumes
/// from it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rotor {

/// Why a head is not the one that is wanted, and how to keep what is below it. The advice is for a
/// head of another sweep.
std::string difference(std::string_view head, std::string_view wanted, std::string_view advice);

/// The journal of FILE is FILE.journal: the head, and the rows, each after a check sum of
/// everything up to and including the row. All functions throw std::runtime_error.
class Journal {
 public:
  /// Resumes from the undamaged part of the journal that exists, up to the number of rows that the
  /// sweep has, or starts one. Refuses a journal that another sweep is writing, and one with
  /// another head.
  Journal(const std::filesystem::path& file, std::string head, long most_rows);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  long rows() const { return rows_; }         ///< in the journal
  off_t dropped() const { return dropped_; }  ///< bytes after them, damaged or too many
  const std::filesystem::path& path() const { return path_; }

  /// Adds whole rows, one line each. They survive the end of the program; after a power cut the
  /// check sums show how many did.
  void write(std::string_view rows);

  /// Writes FILE, whole or not at all, and removes the journal. Passes each row to `see`.
  void finish(const std::function<void(std::string_view row)>& see = {});

 private:
  void open();
  void resume();
  template <class Take>
  off_t read_rows(const Take& take);
  void write_all(std::string_view text);
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno(std::string_view what = "cannot be written") const;

  std::filesystem::path file_, path_;
  std::string head_;
  int descriptor_ = -1;
  long most_rows_, rows_ = 0;
  off_t dropped_ = 0;
  std::uint64_t sum_ = 0;  ///< of the head and all rows
};

}  // namespace rotor
