#include "verification/report/marked_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <regex>

#include "figures/data/csv.hpp"
#include "figures/scenes/statement.hpp"
#include "model/theory/whirl.hpp"
#include "verification/report/page.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// How many claims of which verdict there are, in all and by figure.
void add_verdicts(Json& values, const std::vector<Number>& judged) {
  const Json claims = claims_json(judged);
  std::vector<const Json*> all;
  std::map<int, std::vector<const Json*>> by_figure;
  for (const Json& claim : claims) {
    all.push_back(&claim);
    for (const Json& figure : claim.at("figures")) by_figure[figure.get<int>()].push_back(&claim);
  }
  const Json in_all = verdict_json(all);
  for (const char* key : {"claims", "reproduced", "within_rounding", "refuted"})
    values["claims"][key] = in_all.at(key);
  values["claims"]["numbers"] = judged.size();
  values["claims"]["arithmetic"] = std::ranges::count(judged, Kind::arithmetic, &Number::kind);
  for (const auto& [figure, its] : by_figure) {
    const Json verdict = verdict_json(its);
    values["figures"][std::to_string(figure)] =
        fmt::format("{}, {} of {}", verdict.at("says").get<std::string>(),
                    verdict.at("reproduced").get<int>(), its.size());
  }
}

/// The largest normal force with each correction on its own, kN.
Json corrections_json() {
  const auto peak = [](VelocityJump jump, GravityMoment moment, const char* loss, double at) {
    Statement stated;
    stated.velocity_jump = jump;
    stated.gravity_moment = moment;
    stated.numbers[loss] = at;
    const auto peak_N = summary_of(scenario_of(stated)).peak_normal_force_N;
    return peak_N ? Json(1e-3 * *peak_N) : Json("no contact");
  };
  Json all;
  for (const VelocityJump jump : {VelocityJump::twice, VelocityJump::once})
    for (const GravityMoment moment : {GravityMoment::whole, GravityMoment::balanced})
      all[std::string(name_of(jump))][std::string(name_of(moment))] = {
          {"at_29_1_s", peak(jump, moment, "separation_time", 29.1)},
          {"at_19_1_s", peak(jump, moment, "separation_time", 19.1)},
          {"at_75_Hz", peak(jump, moment, "separation_speed_hz", 75)}};
  return all;
}

Json whirl_json() {
  const Whirl whirl(Parameters{});
  const double speed = 2 * std::numbers::pi * 150;
  return {{"rolling_friction", whirl.rolling_friction(speed)},
          {"synchronous_friction", whirl.synchronous_friction(speed)}};
}

/// How often statements about what matters fail, of the rotors on which they were tried.
Json reasons_json(const std::filesystem::path& tried) {
  Json all;
  for (const CsvRow& row : read_csv(tried))
    all[row["reason"]][row["equations"]] = 100 * static_cast<double>(row.number("share"));
  return all;
}

}  // namespace

std::string with_marked_numbers(const std::string& markdown, const Json& values) {
  static const std::regex mark("<!--([\\w.]+)-->[^<]*<!---->");
  std::string text;
  auto rest = markdown.cbegin();
  for (std::sregex_iterator at(markdown.begin(), markdown.end(), mark), end; at != end; ++at) {
    const std::string name = (*at)[1];
    text.append(rest, (*at)[0].first);
    text += "<!--" + name + "-->" +
            with_numbers(Json("{{" + name + "}}"), values).get<std::string>() + "<!---->";
    rest = (*at)[0].second;
  }
  return text.append(rest, markdown.cend());
}

Json markable_values(const std::vector<Number>& judged,
                     const std::filesystem::path& reference_data) {
  Json values = values_json(judged, read_accidents(reference_data / "accidents.csv"));
  add_verdicts(values, judged);
  values["corrections"] = corrections_json();
  values["whirl"] = whirl_json();
  values["reasons"] = reasons_json(reference_data / "reasons-tried.csv");
  return values;
}

}  // namespace rotor
