#include "figures/sweep/results_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "figures/data/files.hpp"
#include "figures/data/text.hpp"

namespace rotor {

std::string last_line(const CheckSum& above) {
  return fmt::format("# crc32 of the lines above: {}\n", above.text());
}

std::string difference(std::string_view head, std::string_view wanted, std::string_view advice) {
  if (head.starts_with("\xef\xbb\xbf"))
    return "starts with a byte-order mark, which another program has added: remove the mark";
  std::istringstream has{std::string(head)}, needs{std::string(wanted)};
  std::string line, other;
  do {
    std::getline(has, line);
    std::getline(needs, other);
  } while (line == other && has && needs);
  if (line == other + '\r')
    return "has lines that end in CR LF, as another program has written them: change them to LF";
  return fmt::format(
      R"(is of another sweep file, part or version of rotor: has "{}" instead of "{}"; {})",
      shown(line), shown(other), advice);
}

ResultsReader::ResultsReader(const std::filesystem::path& file, std::string_view head,
                             std::string_view advice)
    : stream_(file, std::ios::binary) {
  if (const std::string has = read_file(file, head.size()); has != head)
    throw std::runtime_error(
        fmt::format("{}: {}", one_line(file.string()), difference(has, head, advice)));
  if (!stream_)
    throw std::runtime_error(
        fmt::format("{}: cannot be read: {}", one_line(file.string()), std::strerror(errno)));
  stream_.seekg(static_cast<std::streamoff>(head.size()));
  sum_.add(head);
}

std::optional<std::string> ResultsReader::next() {
  std::string row;
  if (!std::getline(stream_, row)) return std::nullopt;
  sum_.add(row);
  sum_.add("\n");
  return row;
}

bool ResultsReader::ends_with_check_sum() {
  std::string line;
  return std::getline(stream_, line) && !stream_.eof() && line + '\n' == last_line(sum_) &&
         stream_.peek() == std::ifstream::traits_type::eof();
}

bool read_results(const std::filesystem::path& file, std::string_view head, long points,
                  const std::function<void(std::string_view row)>& see) {
  ResultsReader reader(file, head, "--force replaces it");
  for (long n = 0; n < points; ++n) {
    const std::optional<std::string> row = reader.next();
    if (!row) return false;
    see(*row);
  }
  return reader.ends_with_check_sum();
}

}  // namespace rotor
