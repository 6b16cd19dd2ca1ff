/// `digits-reference FILE` writes random runs in quadruple precision: inputs, summaries and ends.
/// `digits-reference stress COUNT SEED FOLDER` compares others with `rotor run --digits`, and the
/// errors of `--estimate-error` with the true ones.
#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "figures/input/names.hpp"
#include "figures/results/certified_result.hpp"
#include "figures/sweep/block_scheduler.hpp"
#include "model/certified/computation.hpp"
#include "model/certified/quad.hpp"
#include "model/integration/fehlberg.hpp"
#include "verification/support/certain_digits.hpp"
#include "verification/support/program.hpp"
#include "verification/support/random_runs.hpp"

namespace rotor {
namespace {

using Unknowns = std::array<Quad, 6>;
using Verner = Verner87<Unknowns, Quad>;
using Fehlberg = Fehlberg78<Unknowns, Quad>;
using Numbers = std::vector<std::pair<std::string, std::optional<Quad>>>;

const ShouldContinue always = [](double /*time_s*/) { return true; };
const Quad best_tolerance("1e-24");

/// All values, with the names of for_each_named; empty if the run has no such value.
template <class Stepper>
Numbers numbers(const Scenario& scenario, const Quad& tolerance) {
  const auto computed = compute<Quad, Stepper>(scenario, {tolerance}, always);
  Numbers all = {{"outcome", static_cast<int>(computed.summary.outcome)},
                 {"touch_downs", computed.summary.touch_downs},
                 {"events", computed.events.size()}};
  const auto add = [&](const std::string& where, const auto& values) {
    for (const NamedValue<Quad>& value : values)
      all.emplace_back(where + std::string(value.name), value.value);
  };
  add("", values_of(computed.summary, scenario.parameters));
  for (std::size_t i = 0; i < computed.events.size(); ++i)
    add(fmt::format("event{}.", i), values_of(computed.events[i], scenario));
  add("end.", values_of(computed.end, scenario));
  return all;
}

/// The columns of the table: all but the values of single events.
bool is_tabled(const std::string& name) { return !name.starts_with("event") || name == "events"; }

/// The largest relative difference of the tabulated values.
double distance(const Numbers& a, const Numbers& b) {
  if (a.size() != b.size()) return 1;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!is_tabled(a[i].first) || a[i].second == b[i].second) continue;
    if (!a[i].second || !b[i].second) return 1;
    largest = std::max(largest, static_cast<double>(Quad(abs(*b[i].second / *a[i].second - 1))));
  }
  return largest;
}

/// Runs that take about a second in quadruple precision.
RandomRuns cheap_runs(unsigned seed) {
  ScenarioSpec fixed;
  fixed.method = Method::event;
  fixed.digits = 1;  // refuses what has no guaranteed digits
  fixed.loses_mass = true;
  return RandomRuns(seed, fixed, 300, 16);
}

/// Thirty runs on which the steppers agree to more than twelve digits, and the hard ones of the
/// file.
void write(const std::string& file) {
  constexpr double enough = 1e-13;
  std::vector<std::string> names;
  std::vector<std::map<std::string, std::string>> rows;
  const auto put = [&](const std::string& name, const std::string& text) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    rows.back()[name] = text;
  };
  const auto add = [&](const Scenario& scenario) {
    const Numbers best = numbers<Verner>(scenario, best_tolerance);
    if (distance(best, numbers<Fehlberg>(scenario, best_tolerance)) > enough) return;
    rows.emplace_back();
    fmt::print(stderr, "{}\n", rows.size());
    for (const Quantity& quantity : quantities())
      put(std::string(quantity.name), fmt::format("{}", quantity.of(scenario)));
    put("velocity_jump", std::string(name_of(scenario.equations.velocity_jump)));
    put("gravity_moment", std::string(name_of(scenario.equations.gravity_moment)));
    for (const auto& [name, value] : best)
      if (is_tabled(name)) put(name, value ? value->str(20, std::ios_base::fmtflags{}) : "");
  };
  RandomRuns runs = cheap_runs(17);
  while (rows.size() < count_of_random_runs) {
    Scenario scenario = runs.scenario();
    scenario.parameters.clearance = scenario.parameters.lost_mass = scenario.mass_loss_speed_Hz = 0;
    add(scenario);  // by the numbers of the table alone
  }
  const std::vector<KnownRun> known = known_runs(file);
  for (std::size_t n = count_of_random_runs; n < known.size(); ++n) add(known[n].scenario);
  std::string table = fmt::format(
      "# Random runs, one row each, from `make reference`: inputs and results.\n"
      "# rotor " ROTOR_VERSION
      ", method event in quadruple precision (113 bits), Verner 8(7) at tolerance 1e-24\n"
      "# All values agree with those of Fehlberg 7(8) to {:.0e}, relative.\n",
      enough);
  for (const std::string& name : names) table += name + (name == names.back() ? '\n' : ',');
  for (auto& row : rows)
    for (const std::string& name : names) table += row[name] + (name == names.back() ? '\n' : ',');
  FileTransaction files;
  files.write(file, table);
  files.commit();
}

/// A run to 3, 6, 9 and 12 digits against quadruple precision, as a row of a table.
std::string row_of(long n, const Scenario& scenario) {
  constexpr std::chrono::seconds cancellation(10);
  KnownValues exact;
  for (const auto& [name, value] : numbers<Verner>(scenario, best_tolerance))
    exact[name] = value ? std::optional(static_cast<double>(*value)) : std::nullopt;
  std::string precisions, short_of, falsehoods;
  double worst = 0;
  for (const int digits : {3, 6, 9, 12}) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    const auto found = run_to_digits(
        scenario, digits, [&](double /*time_s*/) { return Clock::now() - start < cancellation; });
    if (!found) {
      short_of += fmt::format("{} digits: no time; ", digits);
      continue;
    }
    precisions += name_of(found->precision).front();
    if (!has_digits(*found, digits))
      short_of += fmt::format("{} digits: {}; ", digits, complaint(*found, digits));
    if (const std::string what = falsehood(*found, digits, exact, worst); !what.empty())
      falsehoods += fmt::format("{} digits: {}", digits, what);
  }
  const Summary summary = summary_of(scenario);
  const bool is_less = estimated_relative_error(scenario, summary, always) <
                       true_error(summary, scenario.parameters, exact);
  return fmt::format("{},{},{:.3g},{},{},{}\n", n, precisions, worst, is_less ? 1 : 0,
                     csv_field(short_of), csv_field(falsehoods));
}

int stress(long count, unsigned seed, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "digits.csv";
  RandomRuns runs = cheap_runs(seed);
  std::vector<Scenario> scenarios;
  for (long n = 0; n < count; ++n) scenarios.push_back(runs.scenario());
  std::string csv =
      csv_head({fmt::format("{} random runs of seed {} to 3, 6, 9 and 12 digits, against quadruple "
                            "precision.",
                            count, seed),
                "rotor " ROTOR_VERSION
                "; precisions: double, extended, quadruple; worst: the largest error relative to "
                "the stated one;",
                "estimate_is_less: whether --estimate-error is below the largest error"},
               {"run", "precisions", "worst", "estimate_is_less", "short", "false"});
  BlockScheduler scheduler(0, count, [&](std::string_view rows, long done) {
    csv += rows;
    fmt::print(stderr, "\r{} of {} runs", done, count);
  });
  const auto make = [&]() -> Work {
    return [&](long n) { return row_of(n, scenarios[static_cast<std::size_t>(n)]); };
  };
  work(scheduler, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())), make, [] {});
  fmt::print(stderr, "\n");
  FileTransaction files;
  files.write(file, csv);
  files.commit();

  long false_runs = 0, short_runs = 0, underestimated = 0;
  std::map<char, long> precisions;
  double worst = 0;
  for (const CsvRow& row : read_csv(file)) {
    for (const char precision : row["precisions"]) ++precisions[precision];
    worst = std::max(worst, static_cast<double>(row.number("worst")));
    underestimated += row["estimate_is_less"] == "1";
    short_runs += !row["short"].empty();
    if (row["false"].empty()) continue;
    ++false_runs;
    fmt::print("run {}: FALSE: {}\n", row["run"], row["false"]);
  }
  fmt::print(
      "{} random runs of seed {} to 3, 6, 9 and 12 digits: {} false, {} short of digits; in "
      "double, extended, quadruple precision: {}, {}, {}\n"
      "largest error relative to the stated one: {:.2f}\n"
      "--estimate-error was below the largest error in {} of {}; {}\n",
      count, seed, false_runs, short_runs, precisions['d'], precisions['e'], precisions['q'], worst,
      underestimated, count, file.string());
  return false_runs > 0 || underestimated * 20 > count;  // which is one in twenty at most
}

int main(const Arguments& arguments) {
  if (arguments.size() == 4 && arguments[0] == "stress")
    return stress(std::stol(arguments[1]), static_cast<unsigned>(std::stoul(arguments[2])),
                  arguments[3]);
  if (arguments.size() != 1) throw std::runtime_error("needs: FILE, or: stress COUNT SEED FOLDER");
  write(arguments[0]);
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("digits-reference", rotor::main, argc, argv);
}
