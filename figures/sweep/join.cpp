#include "figures/sweep/join.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "figures/data/files.hpp"
#include "figures/data/text.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/results_file.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// The part whose results or journal a file next to the results is, if it is one.
std::optional<Part> part_of_file(const fs::path& file, const fs::path& results) {
  const std::string start = results.stem().string() + '.', name = file.filename().string();
  if (!name.starts_with(start)) return std::nullopt;
  const std::string_view rest = std::string_view(name).substr(start.size());
  const auto part = part_in(rest.substr(0, rest.find('.')), "-of-");
  if (!part) return std::nullopt;
  const fs::path wanted = file_of(*part, results).filename();
  return name == wanted || name == journal_of(wanted) ? part : std::nullopt;
}

/// How many parts there are: that of each file next to the results.
long count_parts(const fs::path& results) {
  std::optional<Part> first;
  for (const auto& entry : fs::directory_iterator(fs::absolute(results).parent_path())) {
    const auto part = part_of_file(entry.path(), results);
    if (!part) continue;
    if (!first) first = part;
    if (first->of != part->of)
      throw std::runtime_error(
          fmt::format("{} and {} are of sweeps in {} and {} parts: remove those that are not meant",
                      one_line(file_of(*first, results).string()),
                      one_line(file_of(*part, results).string()), first->of, part->of));
  }
  if (first) return first->of;
  throw std::runtime_error(
      fmt::format("--join: there is no part {}.K-of-N{}: --part K/N computes one",
                  one_line((results.parent_path() / results.stem()).string()),
                  one_line(results.extension().string())));
}

std::string damage_of(const Sweep& sweep, const Part& part, const fs::path& results) {
  return fmt::format("{}; --part {}/{} --retry computes it anew",
                     damage_in_words(file_of(part, results), heads_of(sweep)), part.number,
                     part.of);
}

/// Throws unless all parts are finished.
void require_finished(long parts, const fs::path& results) {
  std::vector<std::string> failures;
  for (Part part{1, parts}; part.number <= parts; ++part.number) {
    const fs::path file = file_of(part, results);
    const bool is_unfinished = fs::exists(journal_of(file));
    if (is_unfinished || !fs::exists(file))
      failures.push_back(fmt::format("{}: is {}: --part {}/{} {} it", one_line(file.string()),
                                     is_unfinished ? "unfinished" : "missing", part.number, part.of,
                                     is_unfinished ? "resumes" : "computes"));
  }
  report_failures(failures);
}

}  // namespace

std::optional<Part> part_in(std::string_view text, std::string_view separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string_view::npos) return std::nullopt;
  const auto whole = [](std::string_view digits, long& into) {
    const char* const end = digits.data() + digits.size();
    const auto read = std::from_chars(digits.data(), end, into);
    return read.ec == std::errc() && read.ptr == end;
  };
  Part part;
  const bool is_part = whole(text.substr(0, at), part.number) &&
                       whole(text.substr(at + separator.size()), part.of) && part.number >= 1 &&
                       part.number <= part.of && part.of <= Part::most;
  return is_part ? std::optional(part) : std::nullopt;
}

fs::path file_of(const Part& part, const fs::path& results) {
  const std::string name = fmt::format("{}.{}-of-{}{}", results.stem().string(), part.number,
                                       part.of, results.extension().string());
  return fs::path(results).replace_filename(name);
}

void join_parts(const Sweep& sweep, const fs::path& results) {
  const long parts = count_parts(results);
  require_finished(parts, results);
  std::vector<PointsReader> readers;
  for (Part part{1, parts}; part.number <= parts; ++part.number)
    readers.emplace_back(file_of(part, results), heads_of(sweep, part),
                         fmt::format("--part {}/{} --force replaces it", part.number, parts));
  PointsWriter joined(results, heads_of(sweep));
  const auto reader_of = [&](const Part& part) -> PointsReader& {
    return readers[static_cast<std::size_t>(part.number - 1)];
  };
  for (long point = 0; point < sweep.points(); ++point) {
    const Part part{Part::with(point, parts), parts};
    const std::optional<std::string> line = reader_of(part).next(point);
    if (!line) throw std::runtime_error(damage_of(sweep, part, results));
    joined.write(*line);
  }
  std::vector<std::string> failures;
  for (Part part{1, parts}; part.number <= parts; ++part.number)
    if (!reader_of(part).ends_with_check_sum()) failures.push_back(damage_of(sweep, part, results));
  report_failures(failures);
  joined.commit();
}

}  // namespace rotor
