/// The claims and their verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <tuple>

#include "verification/report/document.hpp"
#include "verification/support/pattern.hpp"

namespace rotor {
namespace {

/// As keys of the document.
constexpr std::array set_keys = {"as_printed", "corrected"};

/// A statement, 1 if it is true and 0 if not, as its words explain in brackets.
std::string words_of(const Number& number) {
  return replaced(number.says, " \\((1: yes|0: no)\\)", "");
}
bool is_statement(const Number& number) { return words_of(number) != number.says; }

bool is_tiny(double size) { return size != 0 && size < 1e-6; }

/// In a unit, without superfluous digits; in powers of ten if the paper has them.
std::string shown(const std::optional<double>& value, const Number& number) {
  if (!value || !std::isfinite(*value)) return "–";
  if (is_statement(number)) return *value == 1 ? "yes" : "no";
  const double size = std::abs(*value);
  const bool in_powers = number.printed.find('e') != std::string::npos;
  return (is_tiny(size) && !in_powers              ? "below 1e-06"
          : size != 0 && size < 1e-3 && !in_powers ? "below 0.001"
          : size >= 1e4                            ? fmt::format("{:.0f}", *value)
          : in_powers && size < 1e-2
              ? fmt::format("{:.2e}", *value)
              : fmt::format("{:.{}g}", *value, number.printed.empty() ? 3 : 4)) +
         ' ' + number.unit;
}

/// What the paper states: a number or a word.
std::string printed(const Number& number) {
  if (is_statement(number)) return shown(std::stod(number.printed), number);
  return number.printed.empty() ? number.rule : number.printed + ' ' + number.unit;
}

/// The number's rule, with what it allows.
std::string rule_of(const Number& number) {
  const Allowed allowed = number.allowed();
  const std::string_view judged = number.is_drawn() ? "" : ", at the inputs as printed";
  const std::string limits =
      number.rule == "is"      ? printed(number)
      : number.rule == "major" ? fmt::format("at least {:g} {}", allowed.least(), number.unit)
      : number.printed.empty() && number.rule != "few"
          ? fmt::format("at most {:g} {}", allowed.greatest(), number.unit)
          : fmt::format("{:.6g} to {:.6g} {}", allowed.least(), allowed.greatest(), number.unit);
  return fmt::format("{}: {}{}", number.rule, limits, judged);
}

/// The range of population (b).
std::string range_of(const Stored& stored) {
  const Spread& spread = stored.spread;
  if (!std::isfinite(spread.low) || spread.draws == 0) return "";
  return is_tiny(std::max(-spread.low, spread.high))
             ? "below 1e-06"
             : fmt::format("{:.4g} to {:.4g}", spread.low, spread.high);
}

/// How far a value is from the number as printed, which needs no rule.
std::string deviation(const std::optional<double>& value, const Number& number) {
  const bool is_number = !number.printed.empty() && !is_statement(number) && number.rule != "range";
  if (!is_number || !value || !std::isfinite(*value) || std::stod(number.printed) == 0) return "";
  return fmt::format("({:+.2g} %)", 100 * (*value / std::stod(number.printed) - 1));
}

/// With its class of the page's style.
Json verdict_json(const std::string& verdict) {
  return {{"verdict", verdict}, {"mark", verdict == "within rounding" ? "rounding" : verdict}};
}

/// A number by the reading that decides.
Json number_json(const Number& number) {
  const Reading::InSet &reading = number.readings[number.decides[0]].in[0],
                       &corrected = number.readings[number.decides[1]].in[1];
  const auto here = number.kind == Kind::method ? reading.by_rk4 : reading.converged;
  Json all = {{"says", words_of(number)},
              {"place", number.place},
              {"printed", printed(number)},
              {"rule", rule_of(number)},
              {"is_word", number.printed.empty()},
              {"here", shown(here, number)},
              {"deviation", deviation(here, number)},
              {"corrected_value", shown(corrected.converged, number)},
              {"corrected_deviation", deviation(corrected.converged, number)},
              {"reason", number.reason}};
  if (number.rule != "is" && number.is_drawn())
    all["ranges"] = {{"as_printed", range_of(reading.b)}, {"corrected", range_of(corrected.b)}};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Verdict verdict = verdict_of(number, set);
    all[set_keys[set]] = verdict_json(verdict.verdict);
    all[set_keys[set]]["off"] = std::isfinite(verdict.off_b) ? verdict.off_b : verdict.off_a;
  }
  return all;
}

/// Refuted, within rounding, reproduced; then by how far off.
bool is_worse(const Json& one, const Json& other) {
  const auto severity = [](const Json& judged) {
    const Json& as_printed = judged.at("as_printed");
    const double off = as_printed.at("off");
    const bool is_refuted = as_printed.at("verdict") == "refuted";
    return std::tuple(is_refuted, as_printed.at("verdict") == "within rounding",
                      std::isfinite(off) ? off : 0);
  };
  return severity(one) > severity(other);
}

}  // namespace

Json claims_json(const std::vector<Number>& numbers) {
  Json claims = Json::object();
  for (const Number& number : numbers) {
    if (!number.instead.empty()) continue;
    if (!claims.contains(number.claim))
      claims[number.claim] = {{"claim", number.claim},    {"opens", Json()},
                              {"changes", Json()},        {"says", words_of(number)},
                              {"figures", Json::array()}, {"place", number.place},
                              {"numbers", Json::array()}};
    Json& claim = claims[number.claim];
    std::istringstream figures(number.figures);
    for (int figure = 0; figures >> figure;)
      if (std::find(claim["figures"].begin(), claim["figures"].end(), figure) ==
          claim["figures"].end())
        claim["figures"].push_back(figure);
    claim["numbers"].push_back(number_json(number));
  }
  for (std::size_t set = 0; set < sets.size(); ++set)
    for (const auto& [claim, verdict] : verdicts_of_claims(numbers, set))
      claims[claim][set_keys[set]] = verdict_json(verdict);
  Json all = Json::array();
  for (Json& claim : claims) {
    Json& numbers_of = claim["numbers"];
    std::stable_sort(numbers_of.begin(), numbers_of.end(), is_worse);
    claim["as_printed"]["off"] = numbers_of[0]["as_printed"]["off"];
    claim["worst"] = numbers_of[0];
    claim["many"] = numbers_of.size() > 1 ? Json(numbers_of.size()) : Json();
    if (!claim["figures"].empty()) {
      const int figure = claim["figures"][0];
      claim["opens"] = {{"name", fmt::format("fig{:02}", figure)}, {"number", figure}};
    }
    if (claim["as_printed"]["verdict"] != claim["corrected"]["verdict"])
      claim["changes"] = claim["corrected"];
    all.push_back(claim);
  }
  std::stable_sort(all.begin(), all.end(), is_worse);
  return all;
}

Json turned_json(const std::vector<Number>& numbers) {
  Json rows = Json::array();
  for (const Turned& turned : turned_by_other_rules(numbers))
    rows.push_back({{"claim", turned.number.claim},
                    {"says", words_of(turned.number)},
                    {"set", turned.set == 0 ? "as printed" : "corrected"},
                    {"verdict", verdict_json(turned.verdict)},
                    {"others", turned.others}});
  return rows;
}

Json settled_json(const std::vector<Number>& numbers) {
  Json all;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    Json counts;
    for (const char* of : {"runs", "arithmetic"})
      for (const char* verdict : {"claims", "reproduced", "within rounding", "refuted", "depends"})
        counts[of][verdict] = 0;
    for (const auto& [claim, verdict] : settled_verdicts(numbers, set))
      for (const std::string& key : {std::string("claims"), verdict}) {
        Json& count = counts[is_arithmetic(numbers, claim) ? "arithmetic" : "runs"][key];
        count = count.get<int>() + 1;
      }
    counts["runs"]["within_rounding"] = counts["runs"]["within rounding"];
    all[set_keys[set]] = counts;
    const auto verdicts = verdicts_of_claims(numbers, set);
    for (const Judging& rule : other_rules())
      all["turned_by"][rule.says][set_keys[set]] = std::ranges::count_if(
          verdicts_of_claims(numbers, set, rule),
          [&](const auto& one) { return one.second != verdicts.at(one.first); });
  }
  return all;
}

Json claims_of(int figure, const Json& claims) {
  Json of_figure = Json::array();
  for (const Json& claim : claims)
    for (const Json& number : claim.at("figures"))
      if (number == figure) of_figure.push_back(claim);
  return of_figure;
}

Json verdicts_json(const Json& claims) {
  Json all = {{"claims", claims.size()}, {"claims_something", !claims.empty()}};
  for (const char* set : set_keys) {
    const auto count = [&](const char* verdict) {
      return std::count_if(claims.begin(), claims.end(), [&](const Json& claim) {
        return claim.at(set).at("verdict") == verdict;
      });
    };
    const auto reproduced = count("reproduced"), rounding = count("within rounding"),
               refuted = count("refuted");
    std::string says = claims.empty() ? "nothing is claimed" : "";
    for (const auto& [number, verdict] :
         {std::pair(reproduced, "reproduced"), {rounding, "within rounding"}, {refuted, "refuted"}})
      if (number > 0) says += fmt::format("{}{} {}", says.empty() ? "" : ", ", number, verdict);
    all[set] = {{"reproduced", reproduced},
                {"within_rounding", rounding},
                {"refuted", refuted},
                {"mark", claims.empty() ? "none"
                         : refuted > 0  ? "refuted"
                         : rounding > 0 ? "rounding"
                                        : "reproduced"},
                {"says", says}};
  }
  return all;
}

}  // namespace rotor
