#include "verification/paper/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>

#include "figures/data/csv.hpp"

namespace rotor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double number_of(const std::string& printed) {
  std::size_t length = 0;
  const double value = std::stod(printed, &length);
  if (length != printed.size()) throw std::invalid_argument("is no number: " + printed);
  return value;
}

Allowed around(double number, double half_width) {
  return {number - half_width, number + half_width};
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> all;
  for (std::string word; stream >> word;) all.push_back(word);
  return all;
}

/// Whether what is allowed overlaps the range from 5 % to 95 %.
bool overlaps(const Allowed& allowed, const Spread& spread) {
  return spread.low <= allowed.greatest && spread.high >= allowed.least;
}

/// The stored ensembles, by number and reading.
using Ensembles = std::map<std::pair<std::string, std::string>, std::pair<Spread, Spread>>;

Ensembles read_ensembles(const std::filesystem::path& table) {
  Ensembles all;
  for (const CsvRow& row : read_csv(table)) {
    const auto spread_of = [&](const std::string& which) {
      const auto number = [&](const std::string& what) {
        const std::string& cell = row[what + '_' + which];
        return cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(cell);
      };
      return Spread{static_cast<long>(number("draws")), number("median"), number("p5"),
                    number("p95"), number("share")};
    };
    all[{row["number"], row["reading"]}] = {spread_of("times"), spread_of("all")};
  }
  return all;
}

std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }
std::string cell(const std::optional<double>& value) {
  return cell(value.value_or(std::numeric_limits<double>::quiet_NaN()));
}
std::string cells(const Spread& spread) {
  if (spread.draws == 0) return ",,,,";
  return fmt::format("{},{},{},{},{}", spread.draws, cell(spread.median), cell(spread.low),
                     cell(spread.high), cell(spread.share));
}

}  // namespace

std::string verdict_of(const Number& number) {
  const auto holds = [&](const std::optional<double>& value) {
    return value && number.allowed.holds(*value);
  };
  for (const Reading& reading : number.readings)
    if (holds(reading.converged) || holds(reading.by_rk4)) return "reproduced";
  if (number.kind != Kind::simulated) return "refuted";
  for (const Reading& reading : number.readings)
    if (overlaps(number.allowed, reading.times) || overlaps(number.allowed, reading.everything))
      return "within rounding";
  return "refuted";
}

std::map<std::string, std::string> verdicts_of_claims(const std::vector<Number>& numbers) {
  const std::vector<std::string> from_best = {"reproduced", "within rounding", "refuted"};
  std::map<std::string, std::string> worst;
  for (const Number& number : numbers) {
    std::string& verdict = worst.try_emplace(number.claim, number.verdict).first->second;
    if (std::ranges::find(from_best, number.verdict) > std::ranges::find(from_best, verdict))
      verdict = number.verdict;
  }
  return worst;
}

std::vector<std::string> readings_to_draw(const std::vector<Number>& numbers) {
  std::set<std::string> names;
  for (const Number& number : numbers)
    for (const Reading& reading : number.readings)
      if (number.kind == Kind::simulated) names.insert(reading.name);
  return {names.begin(), names.end()};
}

double half_digit(const std::string& printed) {
  const std::size_t exponent = printed.find('e');
  const std::string digits = printed.substr(0, exponent);
  const double scale =
      exponent == std::string::npos ? 1 : std::pow(10, number_of(printed.substr(exponent + 1)));
  const std::size_t point = digits.find('.');
  if (point != std::string::npos)
    return scale / 2 * std::pow(10, -static_cast<double>(digits.size() - point - 1));
  // Zeros behind the second digit of a whole number do not count.
  const std::size_t last = digits.find_last_not_of('0');
  const std::size_t first = digits.find_first_of("123456789");
  const std::size_t counts = std::min(digits.size() - 1, std::max(last, first + 1));
  return scale / 2 * std::pow(10, static_cast<double>(digits.size() - 1 - counts));
}

Allowed allowed(const std::string& printed, const std::string& rule) {
  constexpr double about = 0.05;
  if (rule == "digits") return around(number_of(printed), half_digit(printed));
  if (rule == "about")
    return around(number_of(printed),
                  std::max(half_digit(printed), about * std::abs(number_of(printed))));
  if (rule == "range") {
    const std::size_t dash = printed.find('-', 1);
    if (dash == std::string::npos) throw std::invalid_argument("is no range: " + printed);
    const std::string from = printed.substr(0, dash), until = printed.substr(dash + 1);
    return {number_of(from) - half_digit(from), number_of(until) + half_digit(until)};
  }
  if (rule == "is") return around(number_of(printed), 0);
  if (rule == "few") return {2, 10};
  if (rule == "minor") return {-10, 10};
  if (rule == "slight" || rule == "agrees") return {-5, 5};
  if (rule == "negligible") return {-1, 1};
  if (rule == "major") return {50, infinity};
  if (rule == "unchanged") return {-1e-6, 1e-6};
  throw std::invalid_argument("there is no rule " + rule);
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
                  .readings = {},
                  .expected_verdict = row["verdict"],
                  .reason = row["reason"],
                  .verdict = {}};
    try {
      number.allowed = allowed(number.printed, number.rule);
    } catch (const std::exception& error) {
      row.fail(error.what());
    }
    for (const std::string& name : words(row["readings"])) {
      if (std::ranges::find(known, name) == known.end()) row.fail("nothing computes " + name);
      number.readings.push_back({name, {}, {}, {}, {}});
    }
    if (number.readings.empty()) row.fail("there is no reading");
    numbers.push_back(std::move(number));
  }
  return numbers;
}

std::vector<Number> judged_numbers(const std::filesystem::path& folder) {
  std::vector<Number> numbers = read_numbers(folder / "claims.csv");
  const Ensembles ensembles = read_ensembles(folder / "ensembles.csv");
  PaperInputs own_method;
  own_method.statement.method = Method::rk4;
  PaperRuns converged{PaperInputs{}}, by_rk4(own_method);
  for (Number& number : numbers) {
    for (Reading& reading : number.readings) {
      reading.converged = read_off(reading.name, converged);
      reading.by_rk4 = read_off(reading.name, by_rk4);
      if (number.kind == Kind::simulated)
        std::tie(reading.times, reading.everything) = ensembles.at({number.id, reading.name});
    }
    number.verdict = verdict_of(number);
  }
  return numbers;
}

std::string ensembles_csv(const std::vector<Number>& numbers, const Draws& times,
                          const Draws& everything) {
  std::string csv =
      "number,reading,draws_times,median_times,p5_times,p95_times,share_times,draws_all,median_all,"
      "p5_all,p95_all,share_all\n";
  for (const Number& number : numbers)
    for (const Reading& reading : number.readings) {
      if (number.kind != Kind::simulated) continue;
      const auto holds = [&](double value) { return number.allowed.holds(value); };
      csv += fmt::format("{},{},{},{}\n", number.id, reading.name,
                         cells(spread(times.at(reading.name), holds)),
                         cells(spread(everything.at(reading.name), holds)));
    }
  return csv;
}

std::string to_csv(const std::vector<Number>& numbers) {
  std::string csv =
      "claim,number,figures,printed,unit,rule,least,greatest,verdict,reading,converged,published_"
      "method,"
      "draws_times,median_times,p5_times,p95_times,share_times,draws_all,median_all,p5_all,p95_all,"
      "share_all,reason\n";
  for (const Number& n : numbers)
    for (const Reading& r : n.readings)
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", n.claim, n.id, n.figures,
                         n.printed, n.unit, n.rule, n.allowed.least, n.allowed.greatest, n.verdict,
                         r.name, cell(r.converged), cell(r.by_rk4), cells(r.times),
                         cells(r.everything), csv_field(n.reason));
  return csv;
}

}  // namespace rotor
