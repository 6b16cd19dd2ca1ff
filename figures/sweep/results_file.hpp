/// The files of a sweep's results. Each has a head, then rows, and in the last line their check
/// sum: in the first a row for each point, in the other the rows of the points' sections, if they
/// have any.
#pragma once

#include <boost/crc.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "figures/data/files.hpp"
#include "figures/sweep/part.hpp"

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

/// NAME-sections.csv for NAME.csv.
std::filesystem::path sections_of(const std::filesystem::path& results);

/// The heads of both files; the other is empty if there are no sections.
struct ResultHeads {
  std::string results, sections{};
};

/// Results of a point in one line: its row, and after a tab each the rows of its section.
struct PointLine {
  std::string_view row;
  std::vector<std::string_view> section{};

  explicit PointLine(std::string_view line);
};

/// The start of each row of a point's section. Points are counted from 0 on, but shown from 1 on.
std::string start_of_section_row(long point);

/// Reads a file of results row after row. No row can be trusted before the end has been found as it
/// must be.
class ResultsReader {
 public:
  /// Throws std::runtime_error if the head is another, with advice on that, or the file cannot be
  /// read.
  ResultsReader(const std::filesystem::path& file, std::string_view head, std::string_view advice);

  /// The next row, without its line end, if it starts so; otherwise it remains the next.
  std::optional<std::string> next(std::string_view start = {});
  /// Whether the next line is the last one, and the check sum of those above.
  bool ends_with_check_sum();

 private:
  std::ifstream stream_;
  CheckSum sum_;
};

/// Reads both files of results point after point, like a ResultsReader. Without that of sections
/// there is no next point.
class PointsReader {
 public:
  PointsReader(const std::filesystem::path& file, const ResultHeads& heads,
               std::string_view advice);

  /// The line of the point that comes next; none at the end of the file.
  std::optional<std::string> next(long point);
  bool ends_with_check_sum();

 private:
  ResultsReader results_;
  bool has_sections_;
  std::optional<ResultsReader> sections_;
};

/// Writes both files of results.
class PointsWriter {
 public:
  PointsWriter(const std::filesystem::path& file, const ResultHeads& heads);

  void write(std::string_view line);
  /// Both are on the disk before they appear, the results last.
  void commit();

 private:
  struct File {
    File(const std::filesystem::path& path, std::string_view head) : file(path) { write(head); }

    void write(std::string_view text);
    void write_last_line();

    OutputFile file;
    CheckSum sum{};
  };
  File results_;
  std::optional<File> sections_;
};

/// Passes the lines of a part's points to `see`. Returns whether there is one for each point, and
/// the check sum at the end. Throws std::runtime_error as the reader does.
bool read_results(const std::filesystem::path& file, const ResultHeads& heads, const Part& part,
                  long points, const std::function<void(std::string_view line)>& see);

/// What is wrong with results of which that is not so.
std::string damage_in_words(const std::filesystem::path& file, const ResultHeads& heads);

}  // namespace rotor
