#include "verification/report/marked_numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <regex>

#include "figures/data/csv.hpp"
#include "figures/input/names.hpp"
#include "verification/report/page.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// Numbers of verdicts, in all and by figure.
void add_verdicts(Json& values, const std::vector<Number>& judged) {
  const Json claims = claims_json(judged);
  std::vector<const Json*> all;
  std::map<int, std::vector<const Json*>> by_figure;
  for (const Json& claim : claims) {
    all.push_back(&claim);
    for (const Json& figure : claim.at("figures")) by_figure[figure.get<int>()].push_back(&claim);
  }
  values["claims"] = verdicts_json(all);
  values["claims"]["numbers"] = judged.size();
  for (const auto& [figure, its] : by_figure)
    values["figures"][std::to_string(figure)] = verdicts_json(its);
}

/// The largest normal force with each correction separately, kN, or no contact.
Json corrections_json() {
  Json all;
  for (const VelocityJump jump : {VelocityJump::twice, VelocityJump::once})
    for (const GravityMoment moment : {GravityMoment::whole, GravityMoment::balanced})
      for (const double loss_s : {29.1, 19.1, 14.15}) {
        Scenario scenario{.equations = {jump, moment}, .until = loss_s + 0.25};
        scenario.parameters.mass_loss_time = loss_s;
        const auto peak_N = summary_of(scenario).peak_normal_force_N;
        all[std::string(name_of(jump))][std::string(name_of(moment))]
           [fmt::format("t_{:.0f}", std::floor(loss_s))] =
               peak_N ? fmt::format("{:.2f}", 1e-3 * *peak_N) : "no contact";
      }
  return all;
}

/// How often statements about trends hold, and the standard error, %.
Json reasons_json(const std::filesystem::path& tried) {
  Json all;
  for (const CsvRow& row : read_csv(tried))
    all[row["reason"]][row["equations"]] = {
        {"holds", 100 * (1 - static_cast<double>(row.number("share")))},
        {"error", 100 * static_cast<double>(row.number("standard_error"))}};
  return all;
}

/// How well the laws of model/theory hold, %: `laws.EQUATIONS.QUANTITY`, by the least share of the
/// unbalance in %, as in `from_3`, or for `all`.
Json laws_json(const std::filesystem::path& laws) {
  Json all;
  for (const CsvRow& row : read_csv(laws)) {
    const std::string from = row["share_from"];
    const bool has_all = from.empty() || (from == "0" && row["share_to"].empty());
    const std::string which = has_all ? "all" : fmt::format("from_{:.0f}", 100 * std::stod(from));
    all[row["equations"]][row["quantity"]][which] = 100 * static_cast<double>(row.number("agree"));
  }
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
  Json values = values_json(judged);
  add_verdicts(values, judged);
  values["corrections"] = corrections_json();
  values["reasons"] = reasons_json(reference_data / "reasons-tried.csv");
  values["laws"] = laws_json(reference_data / "laws.csv");
  return values;
}

}  // namespace rotor
