/// The results of a sweep up to now, in a file next to the output. A sweep that was killed resumes
/// from it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rotor {

/// Why a head is not the one that is wanted, and how to keep what is below it. The advice is for a
/// head of another sweep.
std::string difference(std::string_view head, std::string_view wanted, std::string_view advice);

/// The journal of FILE is FILE.journal: the head and the first rows of FILE. All functions throw
/// std::runtime_error.
class Journal {
 public:
  using IsRowOf = std::function<bool(long point, std::string_view row)>;

  /// Resumes after the last row of the journal that exists, or starts one; rows from the first one
  /// on that is not whole, or not of its point, are cut off. Refuses a journal that another sweep
  /// is writing, and one with another head.
  Journal(const std::filesystem::path& file, std::string head, long points, IsRowOf is_row_of);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  long rows() const { return rows_; }
  off_t dropped() const { return dropped_; }  ///< bytes that were cut off
  const std::filesystem::path& path() const { return path_; }

  /// Adds the row of the next point, with its end of line. It survives the end of the program.
  void write(std::string_view row);

  /// Writes FILE, whole or not at all, and removes the journal. Passes each row to `see`.
  void finish(const std::function<void(std::string_view row)>& see = {});

 private:
  void open();
  off_t read_rows(const std::function<void(std::string_view row)>& see);
  void write_all(std::string_view text);
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno(std::string_view what = "cannot be written") const;

  std::filesystem::path file_, path_;
  std::string head_;
  IsRowOf is_row_of_;
  int descriptor_ = -1;
  long points_, rows_ = 0;
  off_t dropped_ = 0;
};

}  // namespace rotor
