#include "verification/paper/claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "verification/paper/readings.hpp"

namespace rotor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far a range is from the middle of what is allowed; infinite if there are too few values.
double off_range(const Allowed& allowed, const Spread& spread) {
  if (!(spread.valued >= 0.05)) return infinity;
  if (spread.is_in_range(allowed.middle)) return 0;
  return std::min(allowed.off(spread.low), allowed.off(spread.high));
}

double off_median(const Allowed& allowed, const Spread& spread) {
  return spread.valued >= 0.5 ? allowed.off(spread.median) : infinity;
}

std::string cells(const Stored& stored) {
  const Spread& s = stored.spread;
  if (s.draws == 0) return ",,,,,";
  return fmt::format("{},{},{},{},{},{}", s.draws, csv_number(s.valued), csv_number(s.median),
                     csv_number(s.low), csv_number(s.high), csv_number(stored.holds));
}

Judgement judgement_on(const Number& number, const Reading::InSet& in, const Judging& judging) {
  const Allowed allowed = number.allowed(judging);
  double off_a = infinity, off_b = infinity;
  const auto note = [](double& off, double another) { off = std::min(off, another); };
  if (in.by_rk4 && judging.own_method) note(off_a, allowed.off(*in.by_rk4));
  if (!number.is_drawn()) {
    if (in.converged) note(off_a, allowed.off(*in.converged));
  } else {
    note(off_a, off_median(allowed, in.a.spread));
    const auto off = judging.medians && bounds_a_change(number.rule) ? off_median : off_range;
    note(off_b, off(allowed, in.a.spread));
    note(off_b, off(allowed, in.b.spread));
  }
  const Verdict verdict = off_a <= 1   ? Verdict::reproduced
                          : off_b <= 1 ? Verdict::within_rounding
                                       : Verdict::refuted;
  return {verdict, off_a, off_b};
}

/// The verdict that a row of the table states.
Verdict verdict_in(const CsvRow& row, const char* column) {
  for (const Verdict verdict : all_verdicts)
    if (words_of(verdict) == row[column]) return verdict;
  row.fail(fmt::format("{}: there is no verdict {}", column, row[column]));
}

/// Whether a number counts: those that have `instead` in the place of another one, or not at all.
bool counts(const Number& number, const std::vector<Number>& all, const Judging& judging) {
  return judging.takes_alternatives
             ? std::ranges::find(all, number.id, &Number::alternative_to) == all.end()
             : number.alternative_to.empty();
}

}  // namespace

std::string csv_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : "";
}

Allowed Number::allowed(const Judging& judging) const {
  Allowed result = rotor::allowed(printed, rule, judging.word_width_factor, judging.zeros_count);
  result.half *= judging.limits;
  return result;
}

std::string words_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::within_rounding:
      return "within rounding";
    case Verdict::refuted:
      return "refuted";
  }
  throw std::logic_error("no such verdict");
}

std::string key_of(Verdict verdict) {
  std::string key = words_of(verdict);
  std::ranges::replace(key, ' ', '_');
  return key;
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
      {.says = "another number for the same words", .takes_alternatives = true}};
  return rules;
}

Judgement judgement_on(const Number& number, std::size_t set, const Judging& judging) {
  const auto by = [&](std::size_t reading) {
    return judgement_on(
        number, number.readings[std::min(reading, number.readings.size() - 1)].in[set], judging);
  };
  if (judging.by == Judging::By::first) return by(0);
  if (judging.by == Judging::By::second) return by(1);
  if (judging.by != Judging::By::every) return by(number.decides[set]);
  Judgement worst = by(0);
  for (std::size_t n = 1; n < number.readings.size(); ++n)
    if (const Judgement one = by(n); one.verdict > worst.verdict) worst = one;
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
          const Verdict verdict = verdict_of(*number, set);
          count.first += verdict == Verdict::refuted;
          count.second += verdict == Verdict::within_rounding;
        }
        if (!fewest || count < *fewest) {
          fewest = count;
          best = n;
        }
      }
      for (Number* number : of_sentence)
        number->decides[set] = std::min(best, number->readings.size() - 1);
    }
}

std::map<std::string, Verdict> verdicts_of_claims(const std::vector<Number>& numbers,
                                                  std::size_t set, const Judging& judging) {
  std::map<std::string, Verdict> worst;
  for (const Number& number : numbers) {
    if (!counts(number, numbers, judging)) continue;
    const Verdict of_number = verdict_of(number, set, judging);
    Verdict& verdict = worst.try_emplace(number.claim, of_number).first->second;
    verdict = std::max(verdict, of_number);
  }
  return worst;
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
                  .alternative_to = row["instead"],
                  .kind = kinds.at(row["kind"]),
                  .conditions = row["conditions"] == "yes",
                  .readings = {},
                  .expected = {verdict_in(row, "verdict"), verdict_in(row, "corrected")},
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

std::vector<Number> of_claim(const std::vector<Number>& numbers, const std::string& id) {
  std::vector<Number> found;
  const auto copy_numbers_of = [&](const std::string& claim) {
    std::ranges::copy_if(numbers, std::back_inserter(found),
                         [&](const Number& number) { return number.claim == claim; });
  };
  copy_numbers_of(id);
  if (const auto number = std::ranges::find(numbers, id, &Number::id);
      found.empty() && number != numbers.end())
    copy_numbers_of(number->claim);
  if (!found.empty()) return found;
  std::set<std::string> claims;
  for (const Number& number : numbers) claims.insert(number.claim);
  throw std::runtime_error(
      fmt::format("there is no claim \"{}\"; there are: {}", id, fmt::join(claims, ", ")));
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

}  // namespace rotor
