/// The claims and their verdicts.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "figures/input/words.hpp"
#include "verification/paper/tally.hpp"
#include "verification/paper/words.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

/// As keys of the document.
constexpr std::array set_keys = {"as_printed", "corrected"};

/// With its class of the page's style.
Json verdict_json(Verdict verdict) {
  return {{"verdict", words_of(verdict)}, {"mark", key_of(verdict)}};
}

/// A number in a set of equations, by the reading that decides.
Json in_set_json(const Number& number, std::size_t set, const std::vector<Number>& numbers) {
  const auto value = value_of(number, set), share = share_with_value(number, set);
  Json all = verdict_json(verdict_of(number, set));
  all["equations"] = sets_in_words[set].words;
  all["value"] = shown(value, number);
  all["deviation"] = deviation(value, number);
  all["others"] = other_verdicts(number, set, numbers);
  if (number.rule != "is" && number.is_drawn())
    all["range"] = range_of(number.readings[number.decides[set]].in[set].b);
  if (share && *share < 1) all["share"] = fmt::format("{:.0f} %", 100 * *share);
  return all;
}

std::vector<int> figures_of(const Number& number) {
  std::vector<int> figures;
  std::istringstream all(number.figures);
  for (int figure = 0; all >> figure;) figures.push_back(figure);
  return figures;
}

/// By the worst verdict.
std::string mark_of(const std::vector<Count>& tally) {
  std::string mark = "none";
  for (const Count& count : tally)
    if (count.claims > 0) mark = key_of(count.verdict);
  return mark;
}

/// A value, its verdict, and the rules that turn it.
std::string in_a_cell(const Number& number, std::size_t set, const std::vector<Number>& numbers) {
  const std::size_t turned = other_verdicts(number, set, numbers).size();
  return fmt::format(
      "{}: {}, {}", shown(value_of(number, set), number), words_of(verdict_of(number, set)),
      turned == 0 ? "by every rule"
                  : fmt::format("{} of {} other rules turn it", turned, other_rules().size()));
}

/// The other numbers of a claim that are reproduced as printed.
std::vector<std::string> others_that_hold(const Number& of, const std::vector<Number>& numbers) {
  std::vector<std::string> hold;
  for (const Number& number : of_claim(numbers, of.claim))
    if (number.id != of.id && number.alternative_to.empty() &&
        verdict_of(number, 0) == Verdict::reproduced)
      hold.push_back(fmt::format("{} ({})", words_of(number), shown(value_of(number, 0), number)));
  return hold;
}

}  // namespace

Json claims_json(const std::vector<Number>& numbers) {
  Json all = Json::array();
  std::set<std::string> seen;
  for (const Passage& passage : in_the_papers_order(numbers)) {
    Json rows = Json::array();
    for (const Number& number : passage.numbers) {
      Json row = {{"id", number.id},
                  {"claim", number.claim},
                  {"says", words_of(number)},
                  {"place", number.place},
                  {"paper", printed(number)},
                  {"rule", rule_of(number)},
                  {"reason", number.reason},
                  {"figures", Json::array()},
                  {"first_of", seen.insert(number.claim).second ? Json(number.claim) : Json()}};
      for (const int figure : figures_of(number))
        row["figures"].push_back({{"name", fmt::format("fig{:02}", figure)}, {"number", figure}});
      for (std::size_t set = 0; set < sets.size(); ++set)
        row["sets"].push_back(in_set_json(number, set, numbers));
      rows.push_back(row);
    }
    all.push_back({{"heading", passage.heading}, {"rows", rows}});
  }
  return all;
}

Json tally_json(const std::vector<Number>& numbers) {
  Json all;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto claims = judged_claims(numbers, set);
    Json& of = all[set_keys[set]] = {{"claims", claims.size()}, {"words", in_words(tally(claims))}};
    for (const Count& count : tally(claims)) {
      of["counts"].push_back({{"mark", key_of(count.verdict)}, {"claims", count.claims}});
      of[key_of(count.verdict)] = fmt::format("{} ({})", count.claims, count.unturned);
    }
    for (const auto& [rule, count] : turned_by_rule(claims))
      all["turned_by"][rule][set_keys[set]] = count;
  }
  return all;
}

Json tally_of_figure(int figure, const std::vector<Number>& numbers) {
  Json all;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto claims = shown_in(figure, judged_claims(numbers, set), numbers);
    all[set_keys[set]] = {{"words", in_words(tally(claims))}, {"mark", mark_of(tally(claims))}};
    if (set > 0) continue;
    all["claims"] = Json::array();
    for (const JudgedClaim& of : claims)
      all["claims"].push_back(
          {{"claim", of.claim}, {"says", words_of(of_claim(numbers, of.claim).front())}});
    all["claims_something"] = !claims.empty();
  }
  return all;
}

Json causes_json(const std::vector<Number>& numbers, const Json& causes) {
  const auto corrected = verdicts_of_claims(numbers, 1);
  Json all = causes;
  for (Json& cause : all) cause["claims"] = Json::array();
  for (const JudgedClaim& claim : judged_claims(numbers, 0)) {
    if (claim.verdict != Verdict::refuted) continue;
    const auto its_numbers = of_claim(numbers, claim.claim);
    const bool has_a_number = std::ranges::any_of(its_numbers, [](const Number& number) {
      return !number.printed.empty() && verdict_of(number, 0) == Verdict::refuted;
    });
    const char* cause = corrected.at(claim.claim) == Verdict::reproduced ? "equations"
                        : has_a_number                                   ? "numbers"
                                                                         : "words";
    all[cause]["claims"].push_back({{"claim", claim.claim}});
    all[cause]["count"] = all[cause]["claims"].size();
  }
  Json list = Json::array();
  for (const Json& cause : all) list.push_back(cause);
  return list;
}

std::string claim_rows(const std::vector<Number>& numbers) {
  std::vector<std::string> rows;
  for (const Passage& passage : in_the_papers_order(numbers))
    for (const Number& number : passage.numbers)
      rows.push_back(fmt::format("| {}: {} | {} | {} | {} | `make claim ID={}` |", number.id,
                                 words_of(number), words_of(verdict_of(number, 0)),
                                 words_of(verdict_of(number, 1)),
                                 fmt::join(figures_of(number), ", "), number.claim));
  return fmt::format("{}", fmt::join(rows, "\n"));
}

std::string refuted_rows(const std::vector<Number>& numbers) {
  std::vector<std::string> rows;
  for (const Passage& passage : in_the_papers_order(numbers))
    for (const Number& number : passage.numbers) {
      if (verdict_of(number, 0) != Verdict::refuted && verdict_of(number, 1) != Verdict::refuted)
        continue;
      rows.push_back(fmt::format("| {}: {} | {} | {} | {} | {} |", number.claim, words_of(number),
                                 rule_of(number), in_a_cell(number, 0, numbers),
                                 in_a_cell(number, 1, numbers),
                                 fmt::join(others_that_hold(number, numbers), "; ")));
    }
  return fmt::format("{}", fmt::join(rows, "\n"));
}

}  // namespace rotor
