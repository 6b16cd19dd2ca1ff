#include "verification/report/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "figures/data/read_csv.hpp"
#include "figures/results/version.hpp"
#include "verification/report/page.hpp"

namespace rotor {
namespace {

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
  Json words = with_numbers(read_json(sources.texts), values_json(judged));
  for (Json& step : words.at("steps")) step[step.at("id").get<std::string>()] = true;
  Json all = {{"tally", tally_json(judged)},
              {"claims", claims_json(judged)},
              {"words", words},
              {"figures", figures_json(sources, judged)},
              {"causes", causes_json(judged, words.at("causes"))},
              {"assumptions", register_json(sources.reference_data / "assumptions.csv")},
              {"version", version()}};
  for (Json& figure : all["figures"])
    for (const auto& [key, of] : {std::pair("caption", "captions"), {"seen", "seen"}})
      figure[key] = words.at(of).value(figure.at("number").get<std::string>(), figure.at("title"));
  return all;
}

}  // namespace rotor
