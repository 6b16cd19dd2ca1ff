/// The claims and their verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include "verification/report/document.hpp"

namespace rotor {
namespace {

/// As keys of the document.
constexpr std::array set_keys = {"as_printed", "corrected"};

Json number_or_nothing(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json number_or_nothing(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json population_json(const Stored& stored) {
  const Spread& spread = stored.spread;
  return {{"draws", spread.draws},
          {"valued_in_percent", number_or_nothing(100 * spread.valued)},
          {"median", number_or_nothing(spread.median)},
          {"low", number_or_nothing(spread.low)},
          {"high", number_or_nothing(spread.high)},
          {"is_range", std::isfinite(spread.low)},
          {"holds_in_percent", number_or_nothing(100 * stored.holds)}};
}

Json reading_json(const Reading& reading) {
  std::string words = reading.name;
  std::ranges::replace(words, '_', ' ');
  const Reading::InSet& in = reading.in[0];
  return {{"name", reading.name},
          {"words", words},
          {"converged", number_or_nothing(in.converged)},
          {"published_method", number_or_nothing(in.by_rk4)},
          {"corrected_value", number_or_nothing(reading.in[1].converged)},
          {"a", population_json(in.a)},
          {"b", population_json(in.b)}};
}

/// With its class of the page's style.
Json verdict_json(const std::string& verdict) {
  return {{"says", verdict}, {"mark", verdict == "within rounding" ? "rounding" : verdict}};
}

Json number_json(const Number& number) {
  Json readings = Json::array();
  for (const Reading& reading : number.readings) readings.push_back(reading_json(reading));
  const Allowed allowed = number.allowed();
  Json all = {{"id", number.id},
              {"says", number.says},
              {"printed", number.printed},
              {"unit", number.unit},
              {"rule", number.rule},
              {"least", allowed.least()},
              {"greatest", allowed.greatest()},
              {"is_interval", number.rule != "major" && number.rule != "is"},
              {"is_bound", number.rule == "major"},
              {"is_drawn", number.kind != Kind::method},
              {"conditions", number.conditions},
              {"reason", number.reason},
              {"readings", readings}};
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const Verdict verdict = verdict_of(number, set);
    all[set_keys[set]] = verdict_json(verdict.says);
    all[set_keys[set]]["off_a"] = number_or_nothing(verdict.off_a);
    all[set_keys[set]]["off_b"] = number_or_nothing(verdict.off_b);
  }
  return all;
}

}  // namespace

Json claims_json(const std::vector<Number>& numbers) {
  std::map<std::string, Json> claims;
  std::vector<std::string> order;
  for (const Number& number : numbers) {
    if (!claims.contains(number.claim)) {
      order.push_back(number.claim);
      claims[number.claim] = {{"id", number.claim},
                              {"figures", Json::array()},
                              {"place", number.place},
                              {"numbers", Json::array()}};
    }
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
  for (const std::string& id : order) all.push_back(claims[id]);
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
