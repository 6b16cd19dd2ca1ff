/// The results of a sweep up to now, in a file next to the output. A sweep that was killed resumes
/// from it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "figures/sweep/results_file.hpp"

namespace rotor {

/// FILE.journal, the journal of FILE.
std::filesystem::path journal_of(const std::filesystem::path& file);

/// The journal of a file: its head, and the lines of the first points, each with one more field,
/// the check sum of the head and of the lines up to this one. All functions throw
/// std::runtime_error.
class Journal {
 public:
  /// Resumes after the last row of the journal that exists, or starts one; rows from the first one
  /// on that does not have its check sum are cut off. Refuses a journal that another sweep is
  /// writing, and one with another head.
  Journal(const std::filesystem::path& file, ResultHeads heads, long points);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  long rows() const { return rows_; }
  off_t dropped() const { return dropped_; }  ///< bytes that were cut off
  const std::filesystem::path& path() const { return path_; }

  /// Adds the line of the next point, without a line end. It survives the end of the program.
  void write(std::string_view line);

  /// Writes FILE, and that of sections, whole or not at all, and removes the journal. Passes each
  /// line to `see`. Fails if the journal no longer has all of them.
  void write_results(const std::function<void(std::string_view line)>& see = {});

 private:
  void open();
  std::string own_head() const;
  off_t read_rows(const std::function<void(std::string_view line)>& see);
  void write_all(std::string_view text);
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno(std::string_view what = "cannot be written") const;

  std::filesystem::path file_, path_;
  ResultHeads heads_;
  CheckSum sum_;  ///< up to the last line
  int descriptor_ = -1;
  long points_, rows_ = 0;
  off_t dropped_ = 0;
};

}  // namespace rotor
