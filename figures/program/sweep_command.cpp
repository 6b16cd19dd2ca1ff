#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <regex>
#include <sstream>
#include <thread>

#include "figures/data/files.hpp"
#include "figures/program/commands.hpp"
#include "figures/program/progress.hpp"
#include "figures/results/estimated_result.hpp"
#include "figures/sweep/journal.hpp"
#include "figures/sweep/ranks.hpp"
#include "figures/sweep/sweep_row.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

struct Measured {
  long points;
  double each_ms;
  bool is_cut;  ///< it was one, which took longer

  std::string text() const {
    return fmt::format("{}{:.3g} ms each", is_cut ? "more than " : "", each_ms);
  }
};

/// Measures some points that are spread over the sweep irregularly.
Measured measure(Sweep sweep) {
  constexpr long most = 64;
  constexpr double patience_s = 3;
  const long points = sweep.points(), tries = std::min(points, most);
  const auto nth = [&](long n) {
    const double turns = static_cast<double>(n) * std::numbers::phi;
    const double spread = static_cast<double>(points) * (turns - std::floor(turns));
    return tries < points ? static_cast<long>(spread) : n;
  };
  SweepRows row(sweep);
  const auto start = std::chrono::steady_clock::now();
  double last_s = 0;
  for (long tried = 1;; ++tried) {
    sweep.budget_s = patience_s - last_s;
    static_cast<void>(row(nth(tried - 1)));
    const double now_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool is_cut = now_s >= patience_s, is_first = tried == 1;
    if (is_cut && !is_first)
      return {tried - 1, 1000 * last_s / static_cast<double>(tried - 1), false};
    if (is_cut || tried == tries) return {tried, 1000 * now_s / static_cast<double>(tried), is_cut};
    last_s = now_s;
  }
}

/// Prints how long the sweep takes, and how long at a looser tolerance if that is usual for maps.
void estimate(const Sweep& sweep, int jobs) {
  const Measured some = measure(sweep);
  fmt::print("{} points; {} of them took {}: {} {:.3g} s with {} jobs\n", sweep.points(),
             some.points, some.text(), some.is_cut ? "probably more than" : "about",
             some.each_ms / 1000 * static_cast<double>(sweep.points()) / jobs, jobs);
  constexpr double loose = 1e-8;
  Sweep looser = sweep;
  double& tolerance =
      looser.base.numbers.try_emplace("tolerance", Scenario{}.tolerance).first->second;
  if (sweep.base.digits || sweep.base.method == Method::rk4 || !(tolerance < loose) ||
      contains(sweep.quantities(), "tolerance"))
    return;
  tolerance = loose;
  fmt::print("with tolerance = 1e-8 they took {}\n", measure(looser).text());
}

/// The work of the first or only rank: to distribute the points and write their rows.
class Writer {
 public:
  Writer(const Sweep& sweep, const std::string& out)
      : sweep_(sweep),
        points_(sweep.points()),
        journal_(out, sweep_head(sweep), points_),
        written_(journal_.done().count()) {
    if (journal_.dropped() > 0)
      print_message(
          fmt::format("rotor: {}: the {} bytes after row {} are damaged or too many, and were "
                      "dropped",
                      journal_.path().string(), journal_.dropped(), journal_.done().count()));
    if (written_ > 0)
      print_message(fmt::format("rotor: {} of {} points are already in {}", written_.load(),
                                points_, journal_.path().string()));
  }

  void run(int threads, const std::function<Work()>& make_worker, Ranks& ranks) {
    ProgressLine line;
    const long before = written_;
    const auto text = [&](double elapsed_s) {
      const auto done = static_cast<double>(written_ - before),
                 left = static_cast<double>(points_ - written_);
      std::string so_far =
          fmt::format("{} of {} points in {}", written_.load(), points_, duration(elapsed_s));
      if (done == 0) return so_far;
      return fmt::format("{}, {:.3g} per second; about {} to go", so_far, done / elapsed_s,
                         duration(elapsed_s * left / done));
    };
    PointScheduler scheduler(journal_.done(), points_, [&](long point, std::string_view row) {
      journal_.write(point, row);
      ++written_;
    });
    std::exception_ptr reason;
    try {
      work(scheduler, threads, make_worker, [&] {
        ranks.serve(scheduler);
        line.update(text);
      });
    } catch (...) {
      reason = std::current_exception();
    }
    ranks.shut_down_workers();
    if (is_interrupted())
      throw Interrupted(
          fmt::format("interrupted; {} of {} points are in {}; the same command resumes from there",
                      written_.load(), points_, journal_.path().string()));
    if (reason) std::rethrow_exception(reason);
    long remarked = 0, refused = 0;  // from the last two fields of their rows
    std::map<std::string, long> outcomes;
    const std::vector<std::string>& columns = result_columns(sweep_);
    const auto outcome = std::find(columns.begin(), columns.end(), "outcome");
    const long column = outcome - columns.begin() + static_cast<long>(sweep_.quantities().size());
    journal_.finish([&](std::string_view row) {
      if (!row.ends_with(','))
        ++refused;
      else if (!row.ends_with(",,"))
        ++remarked;
      if (outcome != columns.end()) ++outcomes[field(row, column)];
    });
    for (const auto& [name, count] : outcomes)
      if (!name.empty())
        counts_ += fmt::format("{}{} {}", counts_.empty() ? "" : ", ", count, name);
    if (remarked + refused > 0)
      print_message(
          fmt::format("rotor: of {} points {} exceed a limit (column remarks), and {} have no "
                      "result or too few digits (column refusal)",
                      points_, remarked, refused));
    has_results_ = refused < points_;
  }

  /// How many points have which outcome; a refused one has none.
  const std::string& counts() const { return counts_; }
  bool has_results() const { return has_results_; }

 private:
  /// Fields before the outcome are numbers or names, without quotes.
  static std::string field(std::string_view row, long column) {
    for (; column > 0; --column) row.remove_prefix(row.find(',') + 1);
    return std::string(row.substr(0, row.find(',')));
  }

  const Sweep& sweep_;
  long points_;
  std::string counts_;
  bool has_results_ = false;
  Journal journal_;
  std::atomic<long> written_;
};

int cores() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

/// Rows by the numbers of their points.
using KnownRows = std::map<long, std::string>;

/// What is above the results, without what may differ: how many draws there are.
std::string fixed_head(std::istream& results) {
  std::string text, line;
  while (results.peek() == '#' && std::getline(results, line))
    if (!std::regex_match(line, std::regex(R"(#\s+count\s*=.*)")) &&
        line.find(" points, as this file has them") == std::string::npos)
      text += line + '\n';
  std::getline(results, line);  // the header row
  return text + line;
}

/// The rows of earlier results that are neither refusals nor damaged. Throws InputError if another
/// sweep or version has written them, and std::runtime_error if the first one, computed anew,
/// differs.
KnownRows known_rows(const Sweep& sweep, const std::string& results) {
  std::ifstream file(results, std::ios::binary);
  std::istringstream wanted(sweep_head(sweep));
  if (!file) throw InputError("--retry: {}: there are no results yet", shown(results));
  const std::string head = fixed_head(file), own = fixed_head(wanted);
  if (head != own)
    throw InputError("--retry: {}: {}", shown(results),
                     difference(head, own,
                                "only the count of draws may differ; without --retry all points "
                                "are computed anew"));
  // By the values of what varies, with which they begin; those have no quotes.
  std::map<std::string, std::string> rows;
  for (std::string row; std::getline(file, row);) {
    std::size_t end = 0;
    for (std::size_t n = sweep.quantities().size(); n > 0; --n) end = row.find(',', end) + 1;
    if (row.ends_with(',')) rows.emplace(row.substr(0, end), row);
  }
  const auto headings = std::make_shared<std::vector<std::string>>();
  std::istringstream names(own.substr(own.rfind('\n') + 1));
  for (std::string name; std::getline(names, name, ',');) headings->push_back(name);
  const SweepPoints points(sweep);
  SweepRows compute(sweep);
  KnownRows known;
  std::string damage;
  long damaged = 0;
  for (long n = 0; n < sweep.points(); ++n) {
    const std::string values = fmt::format("{}", fmt::join(points(n).values, ","));
    const auto found = rows.find(values + ',');
    if (found == rows.end()) continue;
    const std::string row = found->second + '\n', place = fmt::format("row {}", shown(values));
    try {
      compute.check(n, read_row(found->second, place, headings));
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      if (++damaged == 1) damage = error.what();
      continue;
    }
    if (known.empty() && !sweep.base.digits && compute(n) != row)
      throw InputError(
          "--retry: {}: {}: differs from what is computed now; without --retry all "
          "points are computed anew",
          shown(results), place);
    known.emplace(n, row);
  }
  print_message(fmt::format("rotor: {} rows of {} are kept", known.size(), one_line(results)));
  if (damaged > 0)
    print_message(
        fmt::format("rotor: {} rows of {} are damaged and computed anew, the first one: {}",
                    damaged, one_line(results), damage));
  return known;
}

std::function<Work()> workers(const Sweep& sweep, KnownRows known = {}) {
  return [&sweep, known = std::move(known)]() -> Work {
    return [&known, rows = SweepRows(sweep)](long n) mutable {
      const auto found = known.find(n);
      return found == known.end() ? rows(n) : found->second;
    };
  };
}

void require_sense(const SweepOptions& options, const Ranks& ranks) {
  std::error_code error;  // reported as it is opened
  const fs::file_status status = fs::status(options.out, error);
  if (options.out == "-" || (fs::exists(status) && !fs::is_regular_file(status)))
    throw InputError(
        "--out {}: must be a regular file: a sweep resumes from the journal next to it",
        shown(options.out));
  if (ranks.count() > 1 && options.jobs > 1)
    throw InputError("--jobs: under mpirun each rank works on one core");
  if (ranks.count() > 1 && options.retry) throw InputError("--retry: is not for mpirun");
}

void lead(const SweepOptions& options, const Sweep& sweep, Ranks& ranks) {
  std::optional<Writer> writer;
  KnownRows known;
  try {
    require_sense(options, ranks);
    if (options.retry) known = known_rows(sweep, options.out);
    FileTransaction(options.file).open(options.out);  // errors are reported before any work
    writer.emplace(sweep, options.out);
  } catch (...) {
    ranks.broadcast(false);
    throw;
  }
  ranks.broadcast(true);
  const int threads = ranks.count() > 1 ? 1 : options.jobs > 0 ? options.jobs : cores();
  writer->run(threads, workers(sweep, std::move(known)), ranks);
  if (!writer->counts().empty())
    print_message(fmt::format("rotor: {} points: {}", sweep.points(), writer->counts()));
  say_what_is_assumed(sweep);
  fmt::print("{}\n", one_line(options.out));
  if (!writer->has_results())
    throw std::runtime_error(
        fmt::format("{}: no point has a result; column refusal says why", one_line(options.out)));
}

}  // namespace

void write_sweep(const Sweep& sweep, const std::string& out) {
  Ranks ranks;
  Writer(sweep, out).run(cores(), workers(sweep), ranks);
}

void run_sweep(const SweepOptions& options) {
  Ranks ranks;
  std::optional<Sweep> sweep;
  try {
    sweep = read_sweep(options.file);
  } catch (const std::exception&) {
    if (ranks.is_first()) throw;
    return;  // the first rank reports the error
  }
  if (options.budget_s) {
    require_budget("--budget", *options.budget_s);
    sweep->budget_s = options.budget_s;
  }
  if (options.dry_run) {
    if (ranks.is_first()) estimate(*sweep, options.jobs > 0 ? options.jobs : cores());
  } else if (ranks.is_first()) {
    SweepOptions its = options;
    if (its.out.empty()) its.out = fs::path(its.file).filename().replace_extension(".csv");
    lead(its, *sweep, ranks);
  } else if (ranks.broadcast(true)) {
    work_for_first(workers(*sweep)());
  }
}

}  // namespace rotor
