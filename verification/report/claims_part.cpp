/// The claims and their verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>
#include <sstream>

#include "verification/report/document.hpp"

namespace rotor {
namespace {

/// As keys of the document.
constexpr std::array set_keys = {"as_printed", "corrected"};

/// A statement, 1 if it is true and 0 if not, which its words explain in brackets.
bool is_statement(const Number& number) {
  return number.rule == "is" && number.says.find(" (1)") != std::string::npos;
}

std::string words_of(const Number& number) {
  return is_statement(number) ? std::regex_replace(number.says, std::regex(" \\([01]\\)"), "")
                              : number.says;
}

/// In a unit, without superfluous digits; in powers of ten if the paper has them.
std::string shown(const std::optional<double>& value, const Number& number) {
  if (!value || !std::isfinite(*value)) return "–";
  if (is_statement(number)) return *value == 1 ? "yes" : "no";
  const double size = std::abs(*value);
  const bool in_powers = number.printed.find('e') != std::string::npos;
  std::string text = size != 0 && size < 1e-3 && !in_powers ? "below 0.001"
                     : size >= 1e4                          ? fmt::format("{:.0f}", *value)
                     : in_powers && size < 1e-2
                         ? fmt::format("{:.2e}", *value)
                         : fmt::format("{:.{}g}", *value, number.printed.empty() ? 3 : 4);
  if (const auto zero = text.find("e-0"); zero != std::string::npos) text.erase(zero + 2, 1);
  return text + ' ' + number.unit;
}

/// What the paper states: a number, or a word with its allowed width.
std::string printed(const Number& number) {
  if (is_statement(number)) return shown(std::stod(number.printed), number);
  if (!number.printed.empty()) return number.printed + ' ' + number.unit;
  const Allowed allowed = number.allowed();
  if (allowed.greatest() < 1e-3) return number.rule;
  return fmt::format("{}: {:g} {} {}", number.rule,
                     number.rule == "major" ? allowed.least() : allowed.greatest(), number.unit,
                     number.rule == "major" ? "at least" : "at most");
}

/// The position of a value along a strip, in percent of its width: the allowed interval is the
/// middle quarter, and values beyond an end are drawn at it.
double place(const Allowed& allowed, double value) {
  const double off = (value - allowed.middle) / allowed.half;
  return std::round(500 + 125 * std::clamp(off, -3.9, 3.9)) / 10;
}
Json mark(const Allowed& allowed, const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return {};
  return {{"at", fmt::format("{}", place(allowed, *value))},
          {"is_beyond", allowed.off(*value) > 3.9}};
}
Json bar(const Allowed& allowed, const Stored& stored) {
  if (!std::isfinite(stored.spread.low)) return {};
  const double from = place(allowed, stored.spread.low), to = place(allowed, stored.spread.high);
  return {{"from", fmt::format("{}", from)}, {"wide", fmt::format("{:.1f}", to - from)}};
}

/// With its class of the page's style.
Json verdict_json(const std::string& verdict) {
  return {{"says", verdict}, {"mark", verdict == "within rounding" ? "rounding" : verdict}};
}

/// A number by the reading that fits it best.
Json number_json(const Number& number) {
  const Allowed allowed = number.allowed();
  const bool has_strip = number.rule != "is", is_drawn = number.kind != Kind::method;
  const auto here_of = [&](const Reading& reading) {
    return is_drawn ? reading.in[0].converged : reading.in[0].by_rk4;
  };
  const Reading& reading = *std::ranges::min_element(number.readings, {}, [&](const Reading& one) {
    const auto value = here_of(one);
    return value ? allowed.off(*value) : INFINITY;
  });
  const auto here = here_of(reading);
  Json all = {{"id", number.id},
              {"says", words_of(number)},
              {"place", number.place},
              {"printed", printed(number)},
              {"least", allowed.least()},
              {"greatest", allowed.greatest()},
              {"here", shown(here, number)},
              {"corrected_value", shown(reading.in[1].converged, number)},
              {"reason", number.reason}};
  if (has_strip)
    all["strip"] = {{"a", is_drawn ? bar(allowed, reading.in[0].a) : Json()},
                    {"b", is_drawn ? bar(allowed, reading.in[0].b) : Json()},
                    {"here", mark(allowed, here)},
                    {"corrected", mark(allowed, reading.in[1].converged)}};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Verdict verdict = verdict_of(number, set);
    all[set_keys[set]] = verdict_json(verdict.says);
    all[set_keys[set]]["off"] = std::isfinite(verdict.off_b) ? verdict.off_b : verdict.off_a;
  }
  return all;
}

/// Severity: refuted, within rounding, reproduced; then by how far off.
std::pair<int, double> severity(const Json& judged) {
  const auto says = judged.at("as_printed").at("says").get<std::string>();
  const double off = judged.at("as_printed").value("off", 0.);
  return {says == "refuted" ? 2 : says == "within rounding" ? 1 : 0, std::isfinite(off) ? off : 0};
}
bool is_worse(const Json& one, const Json& other) { return severity(one) > severity(other); }

}  // namespace

Json claims_json(const std::vector<Number>& numbers) {
  Json claims = Json::object();
  for (const Number& number : numbers) {
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
    const auto says = claim["says"].get<std::string>();
    if (says != claim["worst"]["says"])
      claim["worst"]["says"] = says + ": " + claim["worst"]["says"].get<std::string>();
    claim["many"] = numbers_of.size() > 1 ? Json(numbers_of.size()) : Json();
    if (!claim["figures"].empty()) {
      const int figure = claim["figures"][0];
      claim["opens"] = {{"name", fmt::format("fig{:02}", figure)}, {"number", figure}};
    }
    if (claim["as_printed"]["says"] != claim["corrected"]["says"])
      claim["changes"] = claim["corrected"];
    all.push_back(claim);
  }
  std::stable_sort(all.begin(), all.end(), is_worse);
  return all;
}

Json verdicts_json(const std::vector<const Json*>& claims) {
  Json all = {{"claims", claims.size()}, {"claims_something", !claims.empty()}};
  for (const char* set : set_keys) {
    const auto count = [&](const char* verdict) {
      return std::ranges::count_if(
          claims, [&](const Json* claim) { return claim->at(set).at("says") == verdict; });
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
                {"mark", claims.empty()               ? "none"
                         : reproduced + rounding == 0 ? "refuted"
                         : refuted > 0                ? "partly"
                         : rounding > 0               ? "rounding"
                                                      : "reproduced"},
                {"says", says}};
  }
  return all;
}

}  // namespace rotor
