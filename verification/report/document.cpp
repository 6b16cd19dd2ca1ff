#include "verification/report/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "figures/data/csv.hpp"
#include "verification/report/page.hpp"

namespace rotor {
namespace {

/// Why a refuted claim fails: an error in the equations, a word or a number.
std::string cause_of(const Json& claim) {
  if (claim.at("corrected").at("says") == "reproduced") return "equations";
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
      if (claim.at("as_printed").at("says") != verdict) continue;
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

/// Adds the settings of the run that shows a claim: of its figure, the one that it names, or the
/// first.
void add_run(Json& claim, const Json& figures) {
  Json& opens = claim["opens"];
  if (opens.is_null()) return;
  opens["moment"] = nullptr;
  for (const Json& figure : figures)
    if (figure.at("name") == opens["name"])
      for (const Json& run : figure.at("runs")) {
        const auto name = run.at("name").get<std::string>();
        const bool is_named = !name.empty() && claim.dump().find(name) != std::string::npos;
        if (run.at("is_moment").get<bool>() && (opens["moment"].is_null() || is_named))
          opens["moment"] = run.at("moment");
      }
}

Json register_json(const std::filesystem::path& assumptions) {
  Json rows = Json::array();
  for (const CsvRow& row : read_csv(assumptions))
    for (Json& of = rows.emplace_back();
         const char* column : {"taken", "other", "quantity", "unit", "value_taken", "value_other"})
      of[column] = row[column];
  return rows;
}

/// Largest forces at three speeds on one scale, kN.
Json forces_json(const Json& values) {
  Json rows = Json::array();
  for (const auto& [run, printed] :
       {std::pair("mu_03", "peak_force"), {"t_19", "peak_100"}, {"t_14", "peak_75"}}) {
    const Json& of = values.at("published").at(run);
    Json row = {{"speed_Hz", fmt::format("{:.0f}", of.at("speed_at_loss_Hz").get<double>())}};
    row["bars"] = Json::array();
    const auto add = [&](const char* mark, const char* name, const Json& kN) {
      row["bars"].push_back(
          {{"mark", mark},
           {"name", name},
           {"kN", kN.is_null() ? "no contact" : fmt::format("{:.0f} kN", kN.get<double>())},
           {"percent", kN.is_null() ? "0" : fmt::format("{:.1f}", kN.get<double>() / 5)}});
    };
    add("paper", "paper", std::stod(values.at("printed").at(printed).get<std::string>()));
    for (const auto& [set, name] : {std::pair("published", "here"), {"consistent", "corrected"}})
      add(set, name, values.at(set).at(run).at("peak_kN"));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(file.string() + " cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

Json read_json(const std::filesystem::path& file) {
  try {
    return Json::parse(content_of(file));
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

Json document(const Sources& sources) {
  const std::vector<Number> judged = judged_numbers(sources.reference_data);
  Json claims = claims_json(judged);
  const Json values = values_json(judged);
  const Json words = with_numbers(read_json(sources.texts), values);
  const Json figures = figures_json(sources, claims);
  for (Json& claim : claims) add_run(claim, figures);
  Json all = {{"title", words.at("title")},
              {"paper", words.at("paper")},
              {"verdict", verdicts_json(claims)},
              {"turned", turned_json(judged)},
              {"words", words},
              {"values", values},
              {"figures", figures},
              {"forces", forces_json(values)},
              {"groups", groups_json(claims, words.at("causes"))},
              {"tests", tests_json(sources)},
              {"studies", studies_json(sources)},
              {"assumptions", register_json(sources.reference_data / "assumptions.csv")},
              {"provenance", provenance_json(sources)}};
  for (Json& figure : all["figures"])
    figure["caption"] =
        words.at("captions").value(figure.at("number").get<std::string>(), figure.at("title"));
  all["words"].erase("captions");
  return all;
}

}  // namespace rotor
