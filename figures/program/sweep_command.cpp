#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <map>
#include <thread>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/sweep/compute_in_order.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// Rows by the numbers of their points.
using Rows = std::map<long, std::string>;

/// Finished results: their rows, or how their head differs from that of this sweep.
struct Finished {
  Rows rows{};
  std::string difference{};

  Finished(const Sweep& sweep, const std::string& results) {
    const std::string wanted = sweep_head(sweep);
    std::ifstream file(results, std::ios::binary);
    std::string head(wanted.size(), '\0'), row;
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    if (head != wanted) {
      difference = rotor::difference(head, wanted, "--force replaces it");
      return;
    }
    const SweepRows points(sweep);
    for (long n = 0; n < sweep.points() && std::getline(file, row); ++n)
      if (points.is_row_of(n, row)) rows.emplace(n, row + '\n');
  }
};

/// What rows have as their outcome, and how many refusals and exceeded limits there are.
class Tally {
 public:
  explicit Tally(const Sweep& sweep) {
    const std::vector<std::string>& columns = result_columns(sweep);
    const auto outcome = std::find(columns.begin(), columns.end(), "outcome");
    if (outcome != columns.end())
      column_ = outcome - columns.begin() + static_cast<long>(sweep.quantities().size());
  }

  void add(std::string_view row) {  // the last two fields are the exceeded limits and the refusal
    ++points_;
    if (!row.ends_with(','))
      ++refused_;
    else if (!row.ends_with(",,"))
      ++remarked_;
    for (long n = 0; column_ && n < *column_; ++n)  // these have no quotes
      row.remove_prefix(row.find(',') + 1);
    if (column_) ++outcomes_[std::string(row.substr(0, row.find(',')))];
  }

  void print() const {
    if (remarked_ > 0)
      print_message(
          fmt::format("rotor: {} of {} points have remarks (column remarks)", remarked_, points_));
    if (refused_ > 0)
      print_message(
          fmt::format("rotor: {} of {} points have no result or too few digits (column refusal)",
                      refused_, points_));
    std::vector<std::string> counts;
    for (const auto& [name, count] : outcomes_)
      if (!name.empty()) counts.push_back(fmt::format("{} {}", count, name));
    if (!counts.empty())
      print_message(fmt::format("rotor: {} points: {}", points_, fmt::join(counts, ", ")));
  }

  bool has_results() const { return refused_ < points_; }

 private:
  std::optional<long> column_;
  long points_ = 0, remarked_ = 0, refused_ = 0;
  std::map<std::string, long> outcomes_;  ///< of a refused point ""
};

/// Computes a sweep, but for the rows that are known. Resumes from its journal, if there is one.
Tally compute(const Sweep& sweep, const std::string& out, int threads, const Rows& known = {}) {
  Journal journal(out, sweep_head(sweep), sweep.points(),
                  [points = SweepRows(sweep)](long n, std::string_view row) {
                    return points.is_row_of(n, row);
                  });
  const long before = journal.rows(), points = sweep.points();
  const std::string name = journal.path().string();
  if (journal.dropped() > 0)
    print_message(fmt::format(
        "rotor: {}: the {} bytes after row {} are damaged or too many, and were dropped", name,
        journal.dropped(), before));
  if (before > 0)
    print_message(fmt::format("rotor: {} of {} points are already in {}", before, points, name));
  std::atomic<long> written = before;
  ProgressLine line;
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
    return [&known, rows = SweepRows(sweep)](long n) mutable {
      const auto found = known.find(n);
      return found == known.end() ? rows(n) : found->second;
    };
  };
  const auto take = [&](const std::string& row) {
    journal.write(row);
    ++written;
  };
  try {
    compute_in_order(before, points, threads, make_work, take, [&] { line.update(text); });
  } catch (...) {
    if (!is_interrupted()) throw;
    throw Interrupted(
        fmt::format("interrupted; {} of {} points are in {}; the same command resumes from there",
                    written.load(), points, name));
  }
  Tally tally(sweep);
  journal.finish([&](std::string_view row) { tally.add(row); });
  return tally;
}

/// Rows without any result are not what a sweep is for.
void require_results(bool has_any, const std::string& name) {
  if (!has_any)
    throw std::runtime_error(
        fmt::format("{}: no point has a result; column refusal says why", name));
}

void require_file(const SweepOptions& options) {
  std::error_code error;  // reported as it is opened
  const fs::file_status status = fs::status(options.out, error);
  if (options.out == "-" || (fs::exists(status) && !fs::is_regular_file(status)))
    throw InputError(
        "--out {}: must be a regular file: a sweep resumes from the journal next to it",
        shown(options.out));
  FileTransaction(options.file).open(options.out);  // errors are reported before any work
}

}  // namespace

void run_sweep(const SweepOptions& stated) {
  SweepOptions options = stated;
  if (options.out.empty())
    options.out = fs::path(options.file).filename().replace_extension(".csv");
  Sweep sweep = read_sweep(options.file);
  if (options.budget_s) {
    require_budget("--budget", *options.budget_s);
    sweep.budget_s = options.budget_s;
  }
  require_file(options);
  const std::string name = one_line(options.out);
  Rows known;
  if (options.retry && !fs::exists(options.out))
    throw InputError("--retry: {}: there are no results yet{}", name,
                     fs::exists(options.out + ".journal") ? "; without it the sweep resumes" : "");
  if (fs::exists(options.out) && !options.force) {
    Finished finished(sweep, options.out);
    if (!finished.difference.empty()) throw InputError("{}: {}", name, finished.difference);
    const auto refused =
        std::erase_if(finished.rows, [](const auto& row) { return !row.second.ends_with(",\n"); });
    if (options.retry) {
      print_message(fmt::format("rotor: {} rows of {} are kept", finished.rows.size(), name));
      known = std::move(finished.rows);
    } else if (static_cast<long>(finished.rows.size() + refused) == sweep.points() &&
               !fs::exists(options.out + ".journal")) {
      print_message(
          fmt::format("rotor: {} has all points of this sweep, {} of them refused; {}"
                      "--force computes all again",
                      name, refused, refused > 0 ? "--retry computes those, " : ""));
      return require_results(!finished.rows.empty(), name);
    }
  }
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const Tally tally = compute(sweep, options.out, options.jobs > 0 ? options.jobs : cores, known);
  tally.print();
  say_what_is_assumed(sweep);
  fmt::print("{}\n", name);
  require_results(tally.has_results(), name);
}

}  // namespace rotor
