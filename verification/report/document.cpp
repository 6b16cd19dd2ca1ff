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

std::vector<const Json*> all_of(const Json& claims) {
  std::vector<const Json*> all;
  for (const Json& claim : claims) all.push_back(&claim);
  return all;
}

/// Claims that belong to no figure.
Json without_figure(const Json& claims) {
  Json rest = Json::array();
  for (const Json& claim : claims)
    if (claim.at("figures").empty()) rest.push_back(claim);
  return rest;
}

Json register_json(const std::filesystem::path& assumptions) {
  Json rows = Json::array();
  for (const CsvRow& row : read_csv(assumptions))
    rows.push_back({{"id", row["id"]},
                    {"taken", row["taken"]},
                    {"other", row["other"]},
                    {"quantity", row["quantity"]},
                    {"unit", row["unit"]},
                    {"value_taken", row["value_taken"]},
                    {"value_other", row["value_other"]}});
  return rows;
}

/// The runs of both sets beside each other.
Json comparison_json(const Json& values) {
  Json rows = Json::array();
  for (const char* set : {"published", "consistent"}) {
    Json runs = Json::array();
    for (const char* run : {"mu_03", "mu_02", "mu_008", "t_19", "t_14"}) {
      const Json& of = values.at(set).at(run);
      const Json& peak = of.at("peak_kN");
      runs.push_back({{"touch_downs", of.at("touch_downs").dump() + " touch-downs"},
                      {"peak", peak.is_null() ? "" : fmt::format("{:.1f}", peak.get<double>())}});
    }
    rows.push_back({{"name", set}, {"runs", runs}});
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

Json table_json(const std::filesystem::path& csv) {
  std::istringstream lines(content_of(csv));
  Json rows = Json::array();
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    Json cells = Json::array();
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
    rows.push_back(cells);
  }
  return rows;
}

Json document(const Sources& sources) {
  const std::vector<Number> judged = judged_numbers(sources.reference_data);
  const Json claims = claims_json(judged);
  const Json values = values_json(judged, read_accidents(sources.reference_data / "accidents.csv"));
  const Json words = with_numbers(read_json(sources.texts), values);
  Json all = {{"title", words.at("title")},
              {"paper", words.at("paper")},
              {"verdict", verdict_json(all_of(claims))},
              {"words", words},
              {"values", values},
              {"figures", figures_json(sources, claims)},
              {"comparison", comparison_json(values)},
              {"other", {{"claims", without_figure(claims)}}},
              {"accident", accident_json(sources)},
              {"tests", tests_json(sources)},
              {"studies", studies_json(sources)},
              {"assumptions", register_json(sources.reference_data / "assumptions.csv")},
              {"provenance", provenance_json(sources)}};
  for (Json& figure : all["figures"])
    figure["caption"] =
        words.at("captions").value(figure.at("number").get<std::string>(), figure.at("title"));
  all["words"].erase("captions");
  if (sources.of_this_machine) all["machine"] = machine_json();
  return all;
}

}  // namespace rotor
