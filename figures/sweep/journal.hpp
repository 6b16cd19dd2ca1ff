/// The results of a sweep as far as they have got, in a file beside their place. A sweep that was
/// killed resumes from it.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace rotor {

/// The journal of FILE is FILE.journal: its head, and its rows, each behind a check sum of all that
/// comes before it and of itself. All throw std::runtime_error.
class Journal {
 public:
  /// Takes up the journal that is there as far as it is as it was written, or begins one. Refuses
  /// one that another sweep is writing, and one that does not begin with this head.
  Journal(const std::filesystem::path& file, std::string head);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  long rows() const { return rows_; }         ///< that are there
  off_t dropped() const { return dropped_; }  ///< bytes behind them that were no such rows
  const std::filesystem::path& path() const { return path_; }

  /// Whole rows, a line each. What was written survives the program's death; after a power cut the
  /// check sums show how much did.
  void write(std::string_view rows);

  /// Puts the results in their place, whole, and removes the journal. Shows each row to `see`.
  void finish(const std::function<void(std::string_view row)>& see = {});

 private:
  void take_up();
  template <class Take>
  off_t read_rows(const Take& take);
  void write_all(std::string_view text);
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno() const;

  std::filesystem::path file_, path_;
  std::string head_;
  int descriptor_ = -1;
  long rows_ = 0;
  off_t dropped_ = 0;
  std::uint64_t sum_ = 0;  ///< of the head and the rows up to here
};

}  // namespace rotor
