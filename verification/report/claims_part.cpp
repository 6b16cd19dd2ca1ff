/// The claims and their verdicts.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

Json reading_json(const ClaimReading& reading, const std::optional<double>& put_right) {
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

Json figures_of(const Claim& claim) {
  Json numbers = Json::array();
  std::istringstream stream(claim.figures);
  for (int number = 0; stream >> number;) numbers.push_back(number);
  return numbers;
}

/// As a class of the page's style.
std::string mark_of(const std::string& verdict) {
  return verdict == "within rounding" ? "rounding" : verdict;
}

}  // namespace

Json claims_json(const std::vector<Claim>& claims) {
  PaperInputs put_right;
  put_right.statement.equations = Equations::consistent;
  PaperRuns consistent(put_right);
  Json all = Json::array();
  for (const Claim& claim : claims) {
    Json readings = Json::array();
    bool holds = false;
    for (const ClaimReading& reading : claim.readings) {
      const auto value = read_off(reading.name, consistent);
      holds = holds || (value && claim.allowed.holds(*value));
      readings.push_back(reading_json(reading, value));
    }
    all.push_back({{"id", claim.id},
                   {"figures", figures_of(claim)},
                   {"place", claim.place},
                   {"says", claim.says},
                   {"printed", claim.printed},
                   {"unit", claim.unit},
                   {"rule", claim.rule},
                   {"least", number_or_nothing(claim.allowed.least)},
                   {"greatest", number_or_nothing(claim.allowed.greatest)},
                   {"is_interval", claim.allowed.least < claim.allowed.greatest &&
                                       std::isfinite(claim.allowed.greatest)},
                   {"is_bound", !std::isfinite(claim.allowed.greatest)},
                   {"is_arithmetic", claim.is_arithmetic},
                   {"verdict", claim.verdict},
                   {"mark", mark_of(claim.verdict)},
                   {"holds_put_right", holds},
                   {"reason", claim.reason},
                   {"readings", readings}});
  }
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
