#include "verification/paper/tally.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "figures/data/csv.hpp"
#include "figures/data/text.hpp"
#include "figures/input/words.hpp"
#include "verification/paper/words.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

/// The first section that a place names; figures and equations outside of one are in Sec. 3.
std::string section_of(const std::string& place) {
  const auto named = matches(place, "Secs?\\. ([0-9](\\.[0-9])?)");
  if (!named.empty()) return named[0][1];
  return place == "Nomenclature" ? "" : "3";
}

/// The first figure of a number in Sec. 3; 0 if there is none.
int figure_of(const Number& number) {
  int figure = 0;
  if (section_of(number.place) == "3") std::istringstream(number.figures) >> figure;
  return figure;
}

std::string heading_of(const Number& number) {
  const std::string section = section_of(number.place);
  if (section.empty()) return number.place;
  const int figure = figure_of(number);
  return fmt::format("Sec. {}{}", section, figure > 0 ? fmt::format(" and Fig. {}", figure) : "");
}

/// The distance of a value from the middle of what is allowed, in halves of its width, negative
/// below it.
std::optional<double> distance(const Allowed& allowed, const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return (*value - allowed.middle) / allowed.half;
}

/// The columns of a table, by their names, in a row.
using Fields = std::vector<std::pair<std::string_view, std::string>>;

/// Of a reading: the number by its rule, and the reading's values.
Fields fields_of(const Number& n, std::size_t set, std::size_t reading,
                 const std::vector<Number>& all) {
  const Judgement judgement = judgement_on(n, set);
  const Reading& r = n.readings[reading];
  Number by_reading = n;
  by_reading.decides[set] = reading;
  const Allowed allowed = n.allowed();
  const auto value = value_of(by_reading, set);
  const Spread& b = r.in[set].b.spread;
  const auto end = [&](double of) {
    return csv_number(n.is_drawn() && b.valued > 0 ? distance(allowed, of) : std::nullopt);
  };
  return {{"claim", n.claim},
          {"number", n.id},
          {"figures", n.figures},
          {"paper", printed(n)},
          {"printed", n.printed},
          {"unit", n.unit},
          {"rule", n.rule},
          {"least", csv_number(allowed.least())},
          {"greatest", csv_number(allowed.greatest())},
          {"equations", sets[set].name},
          {"verdict", words_of(judgement.verdict)},
          {"off_a", csv_number(judgement.off_a)},
          {"off_b", csv_number(judgement.off_b)},
          {"turned_by", std::to_string(other_verdicts(n, set, all).size())},
          {"reading", r.name},
          {"decides", reading == n.decides[set] ? "yes" : "no"},
          {"converged", csv_number(r.in[set].converged)},
          {"published_method", csv_number(r.in[set].by_rk4)},
          {"value", shown(value, n)},
          {"distance", csv_number(distance(allowed, value))},
          {"low", end(b.low)},
          {"high", end(b.high)},
          {"share", csv_number(share_with_value(by_reading, set))},
          {"reason", csv_field(n.reason)}};
}

}  // namespace

std::vector<JudgedClaim> judged_claims(const std::vector<Number>& numbers, std::size_t set) {
  const auto verdicts = verdicts_of_claims(numbers, set);
  std::vector<JudgedClaim> claims;
  for (const Number& number : numbers)
    if (std::ranges::find(claims, number.claim, &JudgedClaim::claim) == claims.end())
      claims.push_back({number.claim, verdicts.at(number.claim), {}});
  for (const Judging& rule : other_rules()) {
    const auto others = verdicts_of_claims(numbers, set, rule);
    for (JudgedClaim& claim : claims)
      if (others.at(claim.claim) != claim.verdict) claim.turned_by.emplace_back(rule.says);
  }
  return claims;
}

std::vector<JudgedClaim> shown_in(int figure, const std::vector<JudgedClaim>& claims,
                                  const std::vector<Number>& numbers) {
  std::set<std::string> shown;
  for (const Number& number : numbers) {
    std::istringstream figures(number.figures);
    for (int of = 0; figures >> of;)
      if (of == figure) shown.insert(number.claim);
  }
  std::vector<JudgedClaim> found;
  std::ranges::copy_if(claims, std::back_inserter(found),
                       [&](const JudgedClaim& of) { return shown.contains(of.claim); });
  return found;
}

std::vector<Count> tally(const std::vector<JudgedClaim>& claims) {
  std::vector<Count> counts;
  for (const Verdict verdict : all_verdicts) {
    Count& count = counts.emplace_back(Count{.verdict = verdict});
    for (const JudgedClaim& claim : claims)
      if (claim.verdict == verdict) {
        ++count.claims;
        count.unturned += claim.turned_by.empty();
      }
  }
  return counts;
}

std::string in_words(const std::vector<Count>& tally) {
  std::string words;
  for (const auto& [verdict, claims, unturned] : tally)
    if (claims > 0)
      words += fmt::format("{}{} {} ({}{})", words.empty() ? "" : ", ", claims, words_of(verdict),
                           unturned, words.empty() ? " turned by no other rule" : "");
  return words.empty() ? "nothing is claimed" : words;
}

std::string tally_lines(const std::vector<Number>& numbers) {
  std::string lines;
  for (std::size_t set = 0; set < sets.size(); ++set)
    lines += fmt::format("{}: {}\n", sets_in_words[set].words,
                         in_words(tally(judged_claims(numbers, set))));
  return lines;
}

std::map<std::string, long> turned_by_rule(const std::vector<JudgedClaim>& claims) {
  std::map<std::string, long> counts;
  for (const Judging& rule : other_rules()) counts[rule.says] = 0;
  for (const JudgedClaim& claim : claims)
    for (const std::string& rule : claim.turned_by) ++counts.at(rule);
  return counts;
}

std::vector<std::string> other_verdicts(const Number& number, std::size_t set,
                                        const std::vector<Number>& numbers) {
  const Verdict verdict = verdict_of(number, set);
  const auto other = std::ranges::find(numbers, number.id, &Number::alternative_to);
  std::vector<std::string> others;
  for (const Judging& rule : other_rules()) {
    const bool is_other = rule.takes_alternatives && other != numbers.end();
    const Verdict by_rule = verdict_of(is_other ? *other : number, set, rule);
    if (by_rule != verdict)
      others.push_back(
          fmt::format("{}: {}", words_of(by_rule), is_other ? other->says : rule.says));
  }
  return others;
}

std::vector<Passage> in_the_papers_order(const std::vector<Number>& numbers) {
  std::vector<Number> ordered;
  std::ranges::copy_if(numbers, std::back_inserter(ordered),
                       [](const Number& number) { return number.alternative_to.empty(); });
  std::ranges::stable_sort(ordered, {}, [](const Number& number) {
    return std::pair(section_of(number.place), figure_of(number));
  });
  std::vector<Passage> passages;
  for (const Number& number : ordered) {
    const std::string heading = heading_of(number);
    if (passages.empty() || passages.back().heading != heading) passages.push_back({heading, {}});
    passages.back().numbers.push_back(number);
  }
  return passages;
}

std::string to_csv(const std::vector<Number>& numbers) {
  std::string header = "row,heading", rows;
  for (const auto& [column, field] : fields_of(numbers.front(), 0, 0, numbers))
    header += fmt::format(",{}", column);
  int row = 0;
  for (const Passage& passage : in_the_papers_order(numbers)) {
    ++row;  // of the heading
    for (const Number& number : passage.numbers) {
      ++row;
      for (std::size_t set = 0; set < sets.size(); ++set)
        for (std::size_t n = 0; n < number.readings.size(); ++n) {
          rows += fmt::format("{},{}", row, csv_field(passage.heading));
          for (const auto& [column, field] : fields_of(number, set, n, numbers))
            rows += ',' + field;
          rows += '\n';
        }
    }
  }
  return header + '\n' + rows;
}

std::string claims_table(const std::vector<Number>& numbers) {
  std::string table = tally_lines(numbers);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::vector<std::string> refuted;
    for (const JudgedClaim& claim : judged_claims(numbers, set))
      if (claim.verdict == Verdict::refuted) refuted.push_back(claim.claim);
    table +=
        fmt::format("refuted, {}: {}\n", sets_in_words[set].short_words, fmt::join(refuted, " "));
  }
  table += fmt::format("\n{:<16}{:<16}{:<17}{:<17}{:<17}{}\n", "as printed", "corrected", "paper",
                       "as printed", "corrected", "claim");
  for (const Passage& passage : in_the_papers_order(numbers)) {
    table += fmt::format("\n{}\n", passage.heading);
    for (const Number& n : passage.numbers)
      table += wrapped(fmt::format("{:<15} {:<15} {:<16} {:<16} {:<16}", words_of(verdict_of(n, 0)),
                                   words_of(verdict_of(n, 1)), printed(n), shown(value_of(n, 0), n),
                                   shown(value_of(n, 1), n)),
                       fmt::format("{}: {}{}", n.claim, words_of(n),
                                   n.reason.empty() ? "" : " (" + n.reason + ')'),
                       132);
  }
  return table;
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
      "{}\n{} claims about runs:\n{}\n{} claims that are arithmetic:\n{}\n{} trends, which make "
      "reasons tries:\n{}",
      tally_lines(numbers), groups[0].size(), fmt::join(groups[0], ""), groups[1].size(),
      fmt::join(groups[1], ""), groups[2].size(), fmt::join(groups[2], ""));
}

}  // namespace rotor
