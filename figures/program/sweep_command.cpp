#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "figures/data/files.hpp"
#include "figures/data/read_csv.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/sweep/compute_in_order.hpp"
#include "figures/sweep/join.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// Lines of points by their places in the results.
using Rows = std::map<long, std::string>;

/// Finished results: the rows that are no refusals, if the file is whole.
struct Finished {
  Rows rows{};
  bool is_whole;

  Finished(const Sweep& sweep, const Part& part, const std::string& file) {
    long place = 0;
    is_whole =
        read_results(file, heads_of(sweep, part), part, sweep.points(), [&](std::string_view line) {
          if (PointLine(line).row.ends_with(',')) rows.emplace(place, line);
          ++place;
        });
    if (!is_whole) rows.clear();
  }
};

/// What rows have as their outcome, and how many have remarks or are refused.
class Tally {
 public:
  explicit Tally(const Sweep& sweep) {
    const std::vector<std::string> varied = sweep.quantities();
    if (!contains(varied, "equations") && !contains(varied, "velocity_jump") &&
        !contains(varied, "gravity_moment"))
      equations_ = fmt::format(", {}", equations_in_words(name_of(equations_of(sweep.base))));
    outcome_ = place_of("outcome", sweep);
    remarks_ = place_of("remarks", sweep);
  }

  void add(std::string_view line) {
    const std::vector<std::string> cells = csv_cells(PointLine(line).row);
    ++points_;
    if (!cells.back().empty())
      ++refused_;
    else if (remarks_ && !cells[*remarks_].empty())
      ++remarked_;
    if (outcome_) ++outcomes_[cells[*outcome_]];
  }

  void print() const {
    say_how_many_have_remarks(remarked_, points_);
    if (refused_ > 0)
      print_message(
          fmt::format("rotor: {} of {} points are refused (column refusal)", refused_, points_));
    std::vector<std::string> counts;
    for (const auto& [name, count] : outcomes_)
      if (!name.empty()) counts.push_back(fmt::format("{} {}", count, name));
    if (!counts.empty())
      print_message(
          fmt::format("rotor: {} points{}: {}", points_, equations_, fmt::join(counts, ", ")));
  }

  bool has_results() const { return refused_ < points_; }

 private:
  std::optional<std::size_t> outcome_, remarks_;
  long points_ = 0, remarked_ = 0, refused_ = 0;
  std::map<std::string, long> outcomes_;  ///< of a refused point ""
  std::string equations_;                 ///< of all points
};

/// Computes a part of a sweep, but for the rows that are known. Resumes from its journal, if there
/// is one.
Tally compute(const Sweep& sweep, const Part& part, const std::string& out, int threads,
              const Rows& known = {}) {
  const long points = part.points(sweep.points());
  Journal journal(out, heads_of(sweep, part), points);
  const long before = journal.rows();
  const std::string name = journal.path().string();
  if (journal.dropped() > 0)
    print_message(fmt::format(
        "rotor: {}: the {} bytes after row {} are damaged or too many: they were dropped, and "
        "their points are computed anew",
        name, journal.dropped(), before));
  if (before > 0)
    print_message(fmt::format("rotor: {} of {} points are already in {}", before, points, name));
  std::atomic<long> written = before;
  ProgressLine progress;
  const auto text = [&](double elapsed_s) {
    const auto done = static_cast<double>(written - before),
               left = static_cast<double>(points - written);
    std::string so_far = fmt::format("{} of {} points, {:.0f} of them in {}", written.load(),
                                     points, done, duration(elapsed_s));
    if (done == 0) return so_far;
    return fmt::format("{}, {:.3g} per second; about {} to go", so_far, done / elapsed_s,
                       duration(elapsed_s * left / done));
  };
  const auto make_work = [&]() -> Work {
    return [&known, &part, rows = SweepRows(sweep)](long place) mutable {
      const auto found = known.find(place);
      return found == known.end() ? rows(part.point(place)) : found->second;
    };
  };
  const auto take = [&](const std::string& line) {
    journal.write(line);
    ++written;
  };
  try {
    compute_in_order(before, points, threads, make_work, take, [&] { progress.update(text); });
  } catch (...) {
    if (!is_interrupted()) throw;
    throw Interrupted(
        fmt::format("interrupted; {} of {} points are in {}; the same command resumes from there",
                    written.load(), points, name));
  }
  Tally tally(sweep);
  journal.write_results([&](std::string_view line) { tally.add(line); });
  return tally;
}

/// Writes the results of a sweep from those of its parts.
Tally join(const Sweep& sweep, const std::string& out) {
  if (const fs::path journal = journal_of(out); fs::exists(journal))
    throw InputError(
        "{}: is of an unfinished sweep without --part: finish it, or remove it to join",
        one_line(journal.string()));
  join_parts(sweep, out);
  Tally tally(sweep);
  read_results(out, heads_of(sweep), Part(), sweep.points(),
               [&](std::string_view line) { tally.add(line); });
  return tally;
}

/// Rows without any result are not what a sweep is for; a part may have no others.
void require_results(const SweepOptions& options, bool has_any) {
  if (!has_any && !options.part)
    throw std::runtime_error(
        fmt::format("{}: no point has a result; column refusal says why", one_line(options.out)));
}

void require_files(const Sweep& sweep, const SweepOptions& options) {
  const auto is_special = [](const fs::path& file) {
    std::error_code error;  // reported as it is opened
    const fs::file_status status = fs::status(file, error);
    return fs::exists(status) && !fs::is_regular_file(status);
  };
  if (options.out == "-" || is_special(options.out))
    throw InputError(
        "--out {}: must be a regular file: a sweep resumes from the journal next to it",
        shown(options.out));
  FileTransaction files(options.file);  // errors are reported before any work
  files.open(options.out);
  if (!sweep.section_turns) return;
  const fs::path sections = sections_of(options.out);
  if (is_special(sections))
    throw InputError("{}: must be a regular file", one_line(sections.string()));
  files.open(sections);
  const std::string wanted = heads_of(sweep, options.part.value_or(Part())).sections;
  if (!fs::exists(sections) || options.force) return;
  if (const std::string has = read_file(sections, wanted.size()); has != wanted)
    throw InputError("{}: {}", one_line(sections.string()),
                     difference(has, wanted, "--force replaces it"));
}

}  // namespace

void run_sweep(const SweepOptions& stated) {
  SweepOptions options = stated;
  const Part part = options.part.value_or(Part());
  if (options.out.empty()) {
    options.out = name_made_from(options.file, ".csv");
    if (options.part) options.out = file_of(part, options.out);
  }
  Sweep sweep = read_sweep(options.file);
  if (part.of > sweep.points())
    throw InputError("--part {}/{}: there are more parts than the {} points of {}", part.number,
                     part.of, sweep.points(), shown(options.file));
  if (options.budget_s) {
    require_budget("--budget", *options.budget_s);
    sweep.budget_s = options.budget_s;
  }
  require_files(sweep, options);
  const std::string name = one_line(options.out);
  Rows known;
  if (options.retry && !fs::exists(options.out))
    throw InputError("--retry: {}: there are no results yet{}", name,
                     fs::exists(journal_of(options.out)) ? "; without it the sweep resumes" : "");
  if (fs::exists(options.out) && !options.force) {
    Finished finished(sweep, part, options.out);
    const std::string fault = damage_in_words(options.out, heads_of(sweep));
    if (options.retry) {
      print_message(finished.is_whole
                        ? fmt::format("rotor: {} rows of {} are kept", finished.rows.size(), name)
                        : fmt::format("rotor: {}; all its points are computed anew", fault));
      known = std::move(finished.rows);
    } else if (!fs::exists(journal_of(options.out))) {
      if (!finished.is_whole) throw InputError("{}; --force computes all again", fault);
      const long refused = part.points(sweep.points()) - static_cast<long>(finished.rows.size());
      print_message(
          fmt::format("rotor: {} has all points of this {}, {} of them refused; {}"
                      "--force computes all again",
                      name, options.part ? "part" : "sweep", refused,
                      refused > 0 ? "--retry computes those, " : ""));
      return require_results(options, !finished.rows.empty());
    }
  }
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = options.jobs > 0 ? options.jobs : cores;
  const Tally tally =
      options.join ? join(sweep, options.out) : compute(sweep, part, options.out, threads, known);
  tally.print();
  say_what_is_assumed(sweep);
  fmt::print("{}\n", name);
  require_results(options, tally.has_results());
}

}  // namespace rotor
