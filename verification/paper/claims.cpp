#include "verification/paper/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "figures/data/csv.hpp"
#include "figures/data/text.hpp"
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

Verdict verdict_of(const Number& number, const Reading::InSet& in, const Judging& judging) {
  const Allowed allowed = number.allowed(judging);
  Verdict verdict{{}, infinity, infinity};
  const auto note = [](double& off, double another) { off = std::min(off, another); };
  if (in.by_rk4 && judging.own_method) note(verdict.off_a, allowed.off(*in.by_rk4));
  if (!number.is_drawn()) {
    if (in.converged) note(verdict.off_a, allowed.off(*in.converged));
  } else {
    note(verdict.off_a, off_median(allowed, in.a.spread));
    const auto off_b = judging.medians && bounds_a_change(number.rule) ? off_median : off_range;
    note(verdict.off_b, off_b(allowed, in.a.spread));
    note(verdict.off_b, off_b(allowed, in.b.spread));
  }
  verdict.verdict = from_best[verdict.off_a <= 1 ? 0 : verdict.off_b <= 1 ? 1 : 2];
  return verdict;
}

bool is_worse(const std::string& one, const std::string& other) {
  return std::ranges::find(from_best, one) > std::ranges::find(from_best, other);
}

/// Whether a number counts: those that have `instead` in the place of another one, or not at all.
bool counts(const Number& number, const std::vector<Number>& all, const Judging& judging) {
  return judging.instead ? std::ranges::find(all, number.id, &Number::instead) == all.end()
                         : number.instead.empty();
}

}  // namespace

Allowed Number::allowed(const Judging& judging) const {
  Allowed result = rotor::allowed(printed, rule, judging.word_width_factor, judging.zeros_count);
  result.half *= judging.limits;
  return result;
}

const std::vector<Judging>& other_rules() {
  using By = Judging::By;
  static const std::vector<Judging> rules = {
      {.says = "half the widths of words", .word_width_factor = 0.5},
      {.says = "twice the widths of words", .word_width_factor = 2},
      {.says = "limits 5 % narrower", .limits = 0.95},
      {.says = "limits 5 % wider", .limits = 1.05},
      {.says = "every reading must hold", .by = By::every},
      {.says = "the first reading for the whole text", .by = By::first},
      {.says = "the second reading for the whole text", .by = By::second},
      {.says = "no result of the paper's method", .own_method = false},
      {.says = "zeros of whole numbers count", .zeros_count = true},
      {.says = "the medians of changes", .medians = true},
      {.says = "another number for the same words", .instead = true}};
  return rules;
}

Verdict verdict_of(const Number& number, std::size_t set, const Judging& judging) {
  const auto by = [&](std::size_t reading) {
    return verdict_of(
        number, number.readings[std::min(reading, number.readings.size() - 1)].in[set], judging);
  };
  if (judging.by == Judging::By::first) return by(0);
  if (judging.by == Judging::By::second) return by(1);
  if (judging.by != Judging::By::every) return by(number.decides[set]);
  Verdict worst = by(0);
  for (std::size_t n = 1; n < number.readings.size(); ++n)
    if (const Verdict one = by(n); is_worse(one.verdict, worst.verdict)) worst = one;
  return worst;
}

void choose_readings(std::vector<Number>& numbers) {
  std::map<std::string, std::vector<Number*>> sentences;
  for (Number& number : numbers) sentences[number.sentence].push_back(&number);
  for (const auto& [sentence, of_sentence] : sentences)
    for (std::size_t set = 0; set < sets.size(); ++set) {
      std::size_t readings = 1, best = 0;
      for (const Number* number : of_sentence)
        readings = std::max(readings, number->readings.size());
      std::optional<std::pair<long, long>> fewest;  // refuted, and within rounding
      for (std::size_t n = 0; n < readings; ++n) {
        std::pair<long, long> count;
        for (Number* number : of_sentence) {
          number->decides[set] = n;
          const std::string verdict = verdict_of(*number, set).verdict;
          count.first += verdict == "refuted";
          count.second += verdict == "within rounding";
        }
        if (!fewest || count < *fewest) fewest = count, best = n;
      }
      for (Number* number : of_sentence)
        number->decides[set] = std::min(best, number->readings.size() - 1);
    }
}

std::map<std::string, std::string> verdicts_of_claims(const std::vector<Number>& numbers,
                                                      std::size_t set, const Judging& judging) {
  std::map<std::string, std::string> worst;
  for (const Number& number : numbers) {
    if (!counts(number, numbers, judging)) continue;
    const std::string of_number = verdict_of(number, set, judging).verdict;
    std::string& verdict = worst.try_emplace(number.claim, of_number).first->second;
    if (is_worse(of_number, verdict)) verdict = of_number;
  }
  return worst;
}

std::map<std::string, std::string> settled_verdicts(const std::vector<Number>& numbers,
                                                    std::size_t set) {
  auto settled = verdicts_of_claims(numbers, set);
  for (const Judging& rule : other_rules())
    for (const auto& [claim, verdict] : verdicts_of_claims(numbers, set, rule))
      if (settled.at(claim) != verdict) settled.at(claim) = "depends";
  return settled;
}

std::vector<Turned> turned_by_other_rules(const std::vector<Number>& numbers) {
  std::vector<Turned> turned;
  for (std::size_t set = 0; set < sets.size(); ++set)
    for (const Number& number : numbers) {
      if (!number.instead.empty()) continue;
      const std::string verdict = verdict_of(number, set).verdict;
      Turned one{number, set, verdict, {}};
      const auto other = std::ranges::find(numbers, number.id, &Number::instead);
      for (const Judging& rule : other_rules()) {
        const bool is_other = rule.instead && other != numbers.end();
        const std::string by_rule = verdict_of(is_other ? *other : number, set, rule).verdict;
        if (by_rule != verdict)
          one.others.push_back(fmt::format("{}: {}", by_rule, is_other ? other->says : rule.says));
      }
      if (!one.others.empty()) turned.push_back(one);
    }
  return turned;
}

std::vector<std::string> readings_to_draw(const std::vector<Number>& numbers) {
  std::set<std::string> names;
  for (const Number& number : numbers)
    for (const Reading& reading : number.readings)
      if (number.is_drawn()) names.insert(reading.name);
  return {names.begin(), names.end()};
}

std::vector<Number> read_numbers(const std::filesystem::path& table) {
  static const std::map<std::string, Kind> kinds = {{"arithmetic", Kind::arithmetic},
                                                    {"method", Kind::method},
                                                    {"simulated", Kind::simulated},
                                                    {"extreme", Kind::extreme}};
  const std::vector<std::string> known = all_readings();
  std::vector<Number> numbers;
  for (const CsvRow& row : read_csv(table)) {
    if (!kinds.contains(row["kind"])) row.fail("there is no kind " + row["kind"]);
    Number number{.claim = row["claim"],
                  .id = row["number"],
                  .sentence = !row["instead"].empty()   ? row["number"]
                              : row["sentence"].empty() ? row["claim"]
                                                        : row["sentence"],
                  .figures = row["figures"],
                  .place = row["place"],
                  .says = row["says"],
                  .printed = row["printed"],
                  .rule = row["rule"],
                  .unit = row["unit"],
                  .instead = row["instead"],
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

bool is_arithmetic(const std::vector<Number>& numbers, const std::string& claim) {
  return std::ranges::all_of(numbers, [&](const Number& number) {
    return number.claim != claim || number.kind == Kind::arithmetic;
  });
}

std::vector<Number> of_claim(const std::vector<Number>& numbers, const std::string& claim) {
  std::vector<Number> found;
  std::ranges::copy_if(numbers, std::back_inserter(found),
                       [&](const Number& number) { return number.claim == claim; });
  if (!found.empty()) return found;
  std::set<std::string> claims;
  for (const Number& number : numbers) claims.insert(number.claim);
  throw std::runtime_error(
      fmt::format("there is no claim \"{}\"; there are: {}", claim, fmt::join(claims, ", ")));
}

std::vector<Number> judged_numbers(const std::filesystem::path& folder) {
  return judged_numbers(folder, folder / "ensembles.csv");
}

std::vector<Number> judged_numbers(const std::filesystem::path& folder,
                                   const std::filesystem::path& table) {
  std::vector<Number> numbers = read_numbers(folder / "claims.csv");
  const Ensembles ensembles = read_ensembles(table);
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
        if (set == 0 && number.kind != Kind::extreme) in.by_rk4 = read_off(reading.name, by_rk4);
        if (!number.is_drawn()) continue;
        const auto stored = [&](const char* population) {
          const auto found = ensembles.find({sets[set].name, population, number.id, reading.name});
          if (found == ensembles.end())
            throw std::runtime_error(fmt::format(
                "ensembles.csv has no row for {} of {} in population ({}), {} equations: make "
                "ensembles ID={} computes it",
                reading.name, number.id, population, sets[set].name, number.claim));
          return found->second;
        };
        in.a = stored("a");
        in.b = stored("b");
      }
  }
  choose_readings(numbers);
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
      if (!number.is_drawn()) continue;
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
        csv += fmt::format("{},{},{},{},{},{},{:.6g},{},{},{},{},{},{},{},{},{}\n", n.claim, n.id,
                           n.figures, n.printed, n.unit, n.rule, n.allowed().least(),
                           cell(n.allowed().greatest()), sets[set].name, verdict.verdict,
                           cell(verdict.off_a), cell(verdict.off_b), r.name,
                           cell(r.in[set].converged), cell(r.in[set].by_rk4), csv_field(n.reason));
    }
  return csv;
}

std::string claims_list(const std::vector<Number>& numbers, const std::vector<CsvRow>& trends) {
  std::array<std::vector<std::string>, 3> groups;
  std::set<std::string> seen;
  for (const Number& number : numbers)
    if (seen.insert(number.claim).second)
      groups[is_arithmetic(numbers, number.claim)].push_back(
          fmt::format("  {:<22} {} ({})\n", number.claim, number.says, number.place));
  for (const CsvRow& row : trends)
    groups[2].push_back(
        fmt::format("  {:<22} {} ({})\n", row["reason"], row["says"], row["place"]));
  return fmt::format(
      "{} claims about runs:\n{}\n{} claims that are arithmetic:\n{}\n{} trends, which make "
      "reasons tries:\n{}",
      groups[0].size(), fmt::join(groups[0], ""), groups[1].size(), fmt::join(groups[1], ""),
      groups[2].size(), fmt::join(groups[2], ""));
}

std::string claims_table(const std::vector<Number>& numbers) {
  std::string table;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::map<std::string, int> how_many;
    for (const auto& [claim, verdict] : settled_verdicts(numbers, set)) ++how_many[verdict];
    table += fmt::format("{:<22}", set == 0 ? "equations as printed" : "corrected equations");
    for (const std::string& verdict : from_best)
      table += fmt::format("{:>5} {}", how_many[verdict], verdict);
    table += fmt::format(" by every rule, {} depend on it\n", how_many["depends"]);
  }
  table += fmt::format("\n{:<16}{:<16}{:<13}{:<11}{}\n", "as printed", "corrected", "printed",
                       "converged", "claim");
  for (auto verdict = from_best.rbegin(); verdict != from_best.rend(); ++verdict)
    for (const Number& n : numbers) {
      if (verdict_of(n, 0).verdict != *verdict || !n.instead.empty()) continue;
      const auto converged = n.readings[n.decides[0]].in[0].converged;
      table += wrapped(fmt::format("{:<15} {:<15} {:<12} {:<10}", *verdict,
                                   verdict_of(n, 1).verdict, n.printed.empty() ? n.rule : n.printed,
                                   converged ? fmt::format("{:.5g}", *converged) : "-"),
                       fmt::format("{}{}: {}{}", n.claim, n.unit.empty() ? "" : ", " + n.unit,
                                   n.says, n.reason.empty() ? "" : " (" + n.reason + ')'),
                       100);
    }
  return table;
}

}  // namespace rotor
