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

Json number_or_nothing(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json spread_json(const Spread& spread) {
  Json all = {{"draws", spread.draws},
              {"median", number_or_nothing(spread.median)},
              {"low", number_or_nothing(spread.low)},
              {"high", number_or_nothing(spread.high)},
              {"holds_in_percent", number_or_nothing(100 * spread.share)}};
  all["is_range"] = !all["low"].is_null();
  return all;
}

Json number_or_nothing(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json reading_json(const Reading& reading, const std::optional<double>& put_right) {
  std::string words = reading.name;
  std::ranges::replace(words, '_', ' ');
  return {{"name", reading.name},
          {"words", words},
          {"converged", number_or_nothing(reading.converged)},
          {"published_method", number_or_nothing(reading.by_rk4)},
          {"put_right", number_or_nothing(put_right)},
          {"times", spread_json(reading.times)},
          {"inputs", spread_json(reading.everything)}};
}

/// As a class of the page's style.
std::string mark_of(const std::string& verdict) {
  return verdict == "within rounding" ? "rounding" : verdict;
}

Json number_json(const Number& number, PaperRuns& consistent) {
  Json readings = Json::array();
  bool holds = false;
  for (const Reading& reading : number.readings) {
    const auto value = read_off(reading.name, consistent);
    holds = holds || (value && number.allowed.holds(*value));
    readings.push_back(reading_json(reading, value));
  }
  return {{"id", number.id},
          {"says", number.says},
          {"printed", number.printed},
          {"unit", number.unit},
          {"rule", number.rule},
          {"least", number_or_nothing(number.allowed.least)},
          {"greatest", number_or_nothing(number.allowed.greatest)},
          {"is_interval", number.allowed.least < number.allowed.greatest &&
                              std::isfinite(number.allowed.greatest)},
          {"is_bound", !std::isfinite(number.allowed.greatest)},
          {"is_drawn", number.kind == Kind::simulated},
          {"verdict", number.verdict},
          {"mark", mark_of(number.verdict)},
          {"holds_put_right", holds},
          {"reason", number.reason},
          {"readings", readings}};
}

}  // namespace

Json claims_json(const std::vector<Number>& numbers) {
  PaperInputs put_right;
  put_right.statement.equations = Equations::consistent;
  PaperRuns consistent(put_right);
  const auto verdicts = verdicts_of_claims(numbers);
  std::map<std::string, Json> claims;
  std::vector<std::string> order;
  for (const Number& number : numbers) {
    if (!claims.contains(number.claim)) {
      order.push_back(number.claim);
      claims[number.claim] = {{"id", number.claim},
                              {"figures", Json::array()},
                              {"place", number.place},
                              {"verdict", verdicts.at(number.claim)},
                              {"mark", mark_of(verdicts.at(number.claim))},
                              {"holds_put_right", true},
                              {"numbers", Json::array()}};
    }
    Json& claim = claims[number.claim];
    std::istringstream figures(number.figures);
    for (int figure = 0; figures >> figure;)
      if (std::find(claim["figures"].begin(), claim["figures"].end(), figure) ==
          claim["figures"].end())
        claim["figures"].push_back(figure);
    claim["numbers"].push_back(number_json(number, consistent));
    if (claim["numbers"].back()["holds_put_right"] == false) claim["holds_put_right"] = false;
  }
  Json all = Json::array();
  for (const std::string& id : order) all.push_back(claims[id]);
  return all;
}

Json verdict_json(const std::vector<const Json*>& claims) {
  const auto count = [&](const char* verdict) {
    return std::ranges::count_if(claims,
                                 [&](const Json* claim) { return (*claim)["verdict"] == verdict; });
  };
  const auto put_right = std::ranges::count_if(
      claims, [](const Json* claim) { return claim->at("holds_put_right") == true; });
  const auto all = static_cast<long>(claims.size());
  const auto reproduced = count("reproduced"), rounding = count("within rounding"),
             refuted = count("refuted");
  const auto [mark, says] = [&]() -> std::array<const char*, 2> {
    if (all == 0) return {"none", "nothing is claimed"};
    if (refuted == all) return {"refuted", "refuted"};
    if (refuted > 0) return {"partly", "holds in part"};
    if (rounding > 0) return {"rounding", "holds within rounding"};
    return {"reproduced", "holds"};
  }();
  return {{"claims", all},      {"reproduced", reproduced},   {"within_rounding", rounding},
          {"refuted", refuted}, {"put_right", put_right},     {"mark", mark},
          {"says", says},       {"claims_something", all > 0}};
}

}  // namespace rotor
