/// The results of a sweep up to now, in a file next to the output. A sweep that was killed resumes
/// from it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "figures/sweep/point_scheduler.hpp"

namespace rotor {

/// Why a head is not the one that is wanted, and how to keep what is below it. The advice is for a
/// head of another sweep.
std::string difference(std::string_view head, std::string_view wanted, std::string_view advice);

/// The journal of FILE is FILE.journal: the head, and the rows in the order in which they were
/// done, each after its point and a check sum of everything up to and including the row. All
/// functions throw std::runtime_error.
class Journal {
 public:
  /// Resumes from the undamaged part of the journal that exists, as far as its rows are of
  /// different points of the sweep, or starts one. Refuses a journal that another sweep is writing,
  /// and one with another head.
  Journal(const std::filesystem::path& file, std::string head, long points);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  const DonePoints& done() const { return done_; }  ///< whose rows are in the journal
  off_t dropped() const { return dropped_; }        ///< bytes after them, damaged or too many
  const std::filesystem::path& path() const { return path_; }

  /// Adds the row of a point, a line. It survives the end of the program; after a power cut the
  /// check sums show how many did.
  void write(long point, std::string_view row);

  /// Writes FILE in the order of the points, whole or not at all, and removes the journal. Passes
  /// each row to `see`.
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
  long points_;
  DonePoints done_;
  off_t dropped_ = 0;
  std::uint64_t sum_ = 0;  ///< of the head and all rows
};

}  // namespace rotor
