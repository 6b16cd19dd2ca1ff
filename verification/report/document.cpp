#include "verification/report/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "figures/results/version.hpp"
#include "verification/report/page.hpp"
#include "verification/support/read_csv.hpp"

namespace rotor {
namespace {

/// Why a refuted claim fails: an error in the equations, a word or a number.
std::string cause_of(const Json& claim) {
  if (claim.at("corrected").at("verdict") == "reproduced") return "equations";
  return claim.at("worst").at("is_word").get<bool>() ? "words" : "numbers";
}

/// Claims by their verdict in the equations as printed, the worst first; refuted ones by cause.
Json groups_json(const Json& claims, const Json& causes) {
  Json groups = Json::array();
  for (const std::string verdict : {"refuted", "within rounding", "reproduced"}) {
    Json group = {{"verdict", verdict}, {"is_open", verdict == "refuted"}};
    std::map<std::string, Json> parts;
    std::size_t count = 0;
    for (const Json& claim : claims) {
      if (claim.at("as_printed").at("verdict") != verdict) continue;
      ++count;
      const std::string cause = verdict == "refuted" ? cause_of(claim) : "";
      Json& part = parts.try_emplace(cause, causes.value(cause, Json{{"title", ""}})).first->second;
      part["name"] = cause;
      part["claims"].push_back(claim);
      part["count"] = part["claims"].size();
    }
    for (const auto& [cause, part] : parts) group["parts"].push_back(part);
    group["count"] = count;
    group["mark"] = verdict == "within rounding" ? "rounding" : verdict;
    groups.push_back(group);
  }
  return groups;
}

Json register_json(const std::filesystem::path& assumptions) {
  Json rows = Json::array();
  for (const CsvRow& row : read_csv(assumptions))
    for (Json& of = rows.emplace_back();
         const char* column : {"taken", "other", "quantity", "unit", "value_taken", "value_other"})
      of[column] = row[column];
  return rows;
}

}  // namespace

Json read_json(const std::filesystem::path& file) {
  try {
    return Json::parse(content_of(file));
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

Json document(const Sources& sources) {
  const std::vector<Number> judged = judged_numbers(sources.reference_data);
  const Json claims = claims_json(judged);
  Json words = with_numbers(read_json(sources.texts), values_json(judged));
  for (Json& step : words.at("steps")) step[step.at("id").get<std::string>()] = true;
  Json all = {{"verdict", verdicts_json(claims)},
              {"settled", settled_json(judged)},
              {"turned", turned_json(judged)},
              {"words", words},
              {"figures", figures_json(sources, claims)},
              {"groups", groups_json(claims, words.at("causes"))},
              {"assumptions", register_json(sources.reference_data / "assumptions.csv")},
              {"version", version()},
              {"commit_date", sources.commit_date}};
  for (Json& figure : all["figures"])
    for (const auto& [key, of] : {std::pair("caption", "captions"), {"seen", "seen"}})
      figure[key] = words.at(of).value(figure.at("number").get<std::string>(), figure.at("title"));
  return all;
}

}  // namespace rotor
