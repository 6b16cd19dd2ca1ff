#include "verification/paper/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "figures/data/csv.hpp"
#include "verification/paper/readings.hpp"

namespace rotor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<std::string> from_best = {"reproduced", "within rounding", "refuted"};

/// How far a range is from the middle of what is allowed; infinite if there are too few values.
double off_range(const Allowed& allowed, const Spread& spread) {
  if (!(spread.valued >= 0.05)) return infinity;
  if (spread.is_in_range(allowed.middle)) return 0;
  return std::min(allowed.off(spread.low), allowed.off(spread.high));
}

double off_median(const Allowed& allowed, const Spread& spread) {
  return spread.valued >= 0.5 ? allowed.off(spread.median) : infinity;
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }
std::string cell(const std::optional<double>& value) { return cell(value.value_or(infinity)); }
std::string cells(const Stored& stored) {
  const Spread& s = stored.spread;
  if (s.draws == 0) return ",,,,,";
  return fmt::format("{},{},{},{},{},{}", s.draws, cell(s.valued), cell(s.median), cell(s.low),
                     cell(s.high), cell(stored.holds));
}

}  // namespace

Verdict verdict_of(const Number& number, std::size_t set, double words) {
  const Allowed allowed = number.allowed(words);
  Verdict verdict{{}, infinity, infinity};
  for (const Reading& reading : number.readings) {
    const Reading::InSet& in = reading.in[set];
    const auto note = [](double& off, double another) { off = std::min(off, another); };
    if (in.by_rk4) note(verdict.off_a, allowed.off(*in.by_rk4));
    if (number.kind == Kind::method) {
      if (in.converged) note(verdict.off_a, allowed.off(*in.converged));
      continue;
    }
    note(verdict.off_a, off_median(allowed, in.a.spread));
    note(verdict.off_b, off_range(allowed, in.a.spread));
    note(verdict.off_b, off_range(allowed, in.b.spread));
  }
  verdict.says = from_best[verdict.off_a <= 1 ? 0 : verdict.off_b <= 1 ? 1 : 2];
  return verdict;
}

std::map<std::string, std::string> verdicts_of_claims(const std::vector<Number>& numbers,
                                                      std::size_t set, double words) {
  std::map<std::string, std::string> worst;
  for (const Number& number : numbers) {
    const std::string its = verdict_of(number, set, words).says;
    std::string& verdict = worst.try_emplace(number.claim, its).first->second;
    if (std::ranges::find(from_best, its) > std::ranges::find(from_best, verdict)) verdict = its;
  }
  return worst;
}

std::vector<Counts> sensitivity(const std::vector<Number>& numbers) {
  std::vector<Counts> all;
  for (std::size_t set = 0; set < sets.size(); ++set)
    for (const double words : {0.5, 1., 2.}) {
      Counts counts{sets[set].name, words, {}};
      for (const std::string& verdict : from_best) counts.claims[verdict] = 0;
      for (const auto& [claim, verdict] : verdicts_of_claims(numbers, set, words))
        ++counts.claims[verdict];
      all.push_back(counts);
    }
  return all;
}

std::vector<std::string> readings_to_draw(const std::vector<Number>& numbers) {
  std::set<std::string> names;
  for (const Number& number : numbers)
    for (const Reading& reading : number.readings)
      if (number.kind != Kind::method) names.insert(reading.name);
  return {names.begin(), names.end()};
}

std::vector<Number> read_numbers(const std::filesystem::path& table) {
  static const std::map<std::string, Kind> kinds = {
      {"arithmetic", Kind::arithmetic}, {"method", Kind::method}, {"simulated", Kind::simulated}};
  const std::vector<std::string> known = all_readings();
  std::vector<Number> numbers;
  for (const CsvRow& row : read_csv(table)) {
    if (!kinds.contains(row["kind"])) row.fail("there is no kind " + row["kind"]);
    Number number{.claim = row["claim"],
                  .id = row["number"],
                  .figures = row["figures"],
                  .place = row["place"],
                  .says = row["says"],
                  .printed = row["printed"],
                  .rule = row["rule"],
                  .unit = row["unit"],
                  .kind = kinds.at(row["kind"]),
                  .conditions = row["conditions"] == "yes",
                  .readings = {},
                  .expected = {row["verdict"], row["corrected"]},
                  .reason = row["reason"]};
    try {
      number.allowed();
    } catch (const std::exception& error) {
      row.fail(error.what());
    }
    std::istringstream readings(row["readings"]);
    for (std::string name; readings >> name;) {
      if (std::ranges::find(known, name) == known.end()) row.fail("nothing computes " + name);
      number.readings.push_back({name});
    }
    if (number.readings.empty()) row.fail("there is no reading");
    numbers.push_back(std::move(number));
  }
  return numbers;
}

std::vector<Number> judged_numbers(const std::filesystem::path& folder) {
  std::vector<Number> numbers = read_numbers(folder / "claims.csv");
  const Ensembles ensembles = read_ensembles(folder / "ensembles.csv");
  for (std::size_t set = 0; set < sets.size(); ++set) {
    PaperInputs inputs;
    inputs.spec.equations = sets[set].equations;
    PaperRuns converged(inputs);
    inputs.spec.method = Method::rk4;
    PaperRuns by_rk4(inputs);
    for (Number& number : numbers)
      for (Reading& reading : number.readings) {
        Reading::InSet& in = reading.in[set];
        in.converged = read_off(reading.name, converged);
        if (set == 0) in.by_rk4 = read_off(reading.name, by_rk4);
        if (number.kind == Kind::method) continue;
        const auto stored = [&](const char* population) {
          return ensembles.at({sets[set].name, population, number.id, reading.name});
        };
        in.a = stored("a");
        in.b = stored("b");
      }
  }
  return numbers;
}

const std::vector<Number>& judged() {
  static const auto all = judged_numbers(ROTOR_REFERENCE_DATA);
  return all;
}

std::string ensembles_rows(const std::vector<Number>& numbers, const char* set,
                           const char* population, const Draws& draws) {
  std::string rows;
  for (const Number& number : numbers)
    for (const Reading& reading : number.readings) {
      if (number.kind == Kind::method) continue;
      const auto& values = draws.at(reading.name);
      const Allowed allowed = number.allowed();
      const auto hold =
          std::ranges::count_if(values, [&](double value) { return allowed.holds(value); });
      rows += fmt::format(
          "{},{},{},{},{}\n", set, population, number.id, reading.name,
          cells({spread(values), static_cast<double>(hold) / static_cast<double>(values.size())}));
    }
  return rows;
}

std::string to_csv(const std::vector<Number>& numbers) {
  std::string csv =
      "claim,number,figures,printed,unit,rule,least,greatest,equations,verdict,off_a,off_b,reading,"
      "converged,published_method,reason\n";
  for (const Number& n : numbers)
    for (std::size_t set = 0; set < sets.size(); ++set) {
      const Verdict verdict = verdict_of(n, set);
      for (const Reading& r : n.readings)
        csv += fmt::format("{},{},{},{},{},{},{:.6g},{:.6g},{},{},{},{},{},{},{},{}\n", n.claim,
                           n.id, n.figures, n.printed, n.unit, n.rule, n.allowed().least(),
                           n.allowed().greatest(), sets[set].name, verdict.says,
                           cell(verdict.off_a), cell(verdict.off_b), r.name,
                           cell(r.in[set].converged), cell(r.in[set].by_rk4), csv_field(n.reason));
    }
  return csv;
}

std::vector<int> figures_without_claim(const std::vector<Number>& numbers) {
  std::set<int> claimed;
  for (const Number& number : numbers) {
    std::istringstream figures(number.figures);
    for (int figure = 0; figures >> figure;) claimed.insert(figure);
  }
  std::vector<int> without;
  for (int figure = 2; figure <= 17; ++figure)
    if (!claimed.contains(figure)) without.push_back(figure);
  return without;
}

std::string claims_table(const std::vector<Number>& numbers) {
  std::string table =
      fmt::format("  {:<16}{:>8}{:>8}  {:<16}{:>12}{:>12} {:<7} {}\n", "as printed", "off (a)",
                  "off (b)", "corrected", "printed", "converged", "", "claim");
  for (const Number& n : numbers) {
    const Verdict as_printed = verdict_of(n, 0);
    const auto converged = n.readings.front().in[0].converged;
    table += fmt::format("  {:<16}{:>8.3g}{:>8.3g}  {:<16}{:>12}{:>12} {:<7} {}{}\n",
                         as_printed.says, as_printed.off_a, as_printed.off_b, verdict_of(n, 1).says,
                         n.printed.empty() ? n.rule : n.printed,
                         converged ? fmt::format("{:.5g}", *converged) : "-", n.unit, n.says,
                         n.reason.empty() ? "" : " (" + n.reason + ')');
  }
  return table +
         fmt::format("nothing is claimed about Figs. {}, which does not count as a success.\n",
                     fmt::join(figures_without_claim(numbers), ", "));
}

}  // namespace rotor
