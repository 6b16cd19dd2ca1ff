/// The results of a sweep as far as they have got, in a file beside their place. A sweep that was
/// killed goes on from there.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rotor {

/// The journal of FILE is FILE.journal: its beginning, to the byte. All throw std::runtime_error.
class Journal {
 public:
  /// Takes up the journal that is there, or begins one. Refuses one that another sweep is writing,
  /// and one that does not begin with this head.
  Journal(const std::filesystem::path& file, std::string_view head);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  long rows() const { return rows_; }  ///< that are there already
  const std::filesystem::path& path() const { return path_; }

  /// Whole rows. What was written survives the program's death.
  void write(std::string_view rows);

  /// Puts the results in their place, whole, and takes the journal away.
  void finish();

 private:
  void take_up(std::string_view head);
  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_by_errno() const;

  std::filesystem::path file_, path_;
  int descriptor_ = -1;
  long rows_ = 0;
};

}  // namespace rotor
