#include "figures/sweep/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::filesystem::path sections_of(const std::filesystem::path& results) {
  return std::filesystem::path(results).replace_filename(results.stem().string() + "-sections" +
                                                         results.extension().string());
}

PointLine::PointLine(std::string_view line) : row(line.substr(0, line.find('\t'))) {
  for (std::size_t at = row.size(); at < line.size();) {
    const std::size_t from = at + 1;
    at = std::min(line.find('\t', from), line.size());
    section.push_back(line.substr(from, at - from));
  }
}

std::string start_of_section_row(long point) { return fmt::format("{},", point + 1); }

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

std::optional<std::string> ResultsReader::next(std::string_view start) {
  const auto here = start.empty() ? std::streampos() : stream_.tellg();
  std::string row;
  if (!std::getline(stream_, row)) return std::nullopt;
  if (!row.starts_with(start)) {
    stream_.seekg(here);
    return std::nullopt;
  }
  sum_.add(row);
  sum_.add("\n");
  return row;
}

bool ResultsReader::ends_with_check_sum() {
  std::string line;
  return std::getline(stream_, line) && !stream_.eof() && line + '\n' == last_line(sum_) &&
         stream_.peek() == std::ifstream::traits_type::eof();
}

PointsReader::PointsReader(const std::filesystem::path& file, const ResultHeads& heads,
                           std::string_view advice)
    : results_(file, heads.results, advice), has_sections_(!heads.sections.empty()) {
  if (has_sections_ && std::filesystem::exists(sections_of(file)))
    sections_.emplace(sections_of(file), heads.sections, advice);
}

std::optional<std::string> PointsReader::next(long point) {
  if (has_sections_ && !sections_) return std::nullopt;
  std::optional<std::string> line = results_.next();
  if (!line || !sections_) return line;
  while (const auto row = sections_->next(start_of_section_row(point))) *line += '\t' + *row;
  return line;
}

bool PointsReader::ends_with_check_sum() {
  return results_.ends_with_check_sum() && (!sections_ || sections_->ends_with_check_sum());
}

PointsWriter::PointsWriter(const std::filesystem::path& file, const ResultHeads& heads)
    : results_(file, heads.results) {
  if (!heads.sections.empty()) sections_.emplace(sections_of(file), heads.sections);
}

void PointsWriter::write(std::string_view line) {
  const PointLine of_point(line);
  const auto write = [](File& file, std::string_view row) {
    file.write(row);
    file.write("\n");
  };
  write(results_, of_point.row);
  for (const std::string_view row : of_point.section) write(sections_.value(), row);
}

void PointsWriter::commit() {
  if (sections_) sections_->write_last_line();
  results_.write_last_line();
  if (sections_) sections_->file.commit();
  results_.file.commit();
}

void PointsWriter::File::write(std::string_view text) {
  file.write(text);
  sum.add(text);
}

void PointsWriter::File::write_last_line() {
  file.write(last_line(sum));
  file.sync();
}

std::string damage_in_words(const std::filesystem::path& file, const ResultHeads& heads) {
  constexpr std::string_view damaged =
      "is damaged or cut: its last line is not the check sum of those above";
  const std::string name = one_line(file.string());
  if (heads.sections.empty()) return fmt::format("{}: {}", name, damaged);
  const std::string sections = one_line(sections_of(file).string());
  if (!std::filesystem::exists(sections_of(file))) return fmt::format("{}: is missing", sections);
  return fmt::format("{} or {}: {}", name, sections, damaged);
}

bool read_results(const std::filesystem::path& file, const ResultHeads& heads, const Part& part,
                  long points, const std::function<void(std::string_view line)>& see) {
  PointsReader reader(file, heads, "--force replaces it");
  for (long row = 0; row < part.points(points); ++row) {
    const std::optional<std::string> line = reader.next(part.point(row));
    if (!line) return false;
    see(*line);
  }
  return reader.ends_with_check_sum();
}

}  // namespace rotor
