/// The file of a sweep's results: its head, a row for each point, and in the last line their check
/// sum.
#pragma once

#include <boost/crc.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace rotor {

/// The CRC-32, as in gzip, of lines one after the other.
class CheckSum {
 public:
  void add(std::string_view text) { sum_.process_bytes(text.data(), text.size()); }
  std::string text() const { return std::to_string(sum_.checksum()); }

 private:
  boost::crc_32_type sum_;
};

/// The last line of results, from the check sum of those above.
std::string last_line(const CheckSum& above);

/// Why a head is not the one that is wanted, and how to keep what is below it. The advice is for a
/// head of another sweep.
std::string difference(std::string_view head, std::string_view wanted, std::string_view advice);

/// Reads results row after row. No row can be trusted before the end has been found as it must be.
class ResultsReader {
 public:
  /// Throws std::runtime_error if the head is another, with advice on that, or the file cannot be
  /// read.
  ResultsReader(const std::filesystem::path& file, std::string_view head, std::string_view advice);

  /// The next row, without its line end; none at the end of the file.
  std::optional<std::string> next();
  /// Whether the next line is the last one, and the check sum of those above.
  bool ends_with_check_sum();

 private:
  std::ifstream stream_;
  CheckSum sum_;
};

/// Passes the rows of results to `see`. Returns whether there is one for each point, and the check
/// sum at the end. Throws std::runtime_error as the reader does.
bool read_results(const std::filesystem::path& file, std::string_view head, long points,
                  const std::function<void(std::string_view row)>& see);

/// What is wrong with results of which that is not so.
inline constexpr std::string_view damaged_in_words =
    "is damaged or cut: its last line is not the check sum of those above";

}  // namespace rotor
