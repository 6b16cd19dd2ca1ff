/// Results of other targets; the tests; provenance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "figures/data/csv.hpp"
#include "figures/results/version.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

/// Suite and name of a test, without its parameters.
std::string name_of(const Json& test) {
  const auto suite = test.at("classname").get<std::string>(),
             name = test.at("name").get<std::string>();
  return suite + '.' + name.substr(0, name.find('/'));
}

/// The theorems from rest at the decimals as printed: each quantity in both sets of equations, to
/// 13 digits if its bounds agree in them.
Json proven_json(const fs::path& csv) {
  Json all;  // by quantity
  for (const CsvRow& row : read_csv(csv)) {
    const std::string command = row["command"], quantity = row["quantity"];
    if (!command.starts_with("build/prove --friction 0.3 ")) continue;
    const std::string set =
        command.find("consistent") == std::string::npos ? "published" : "consistent";
    const double lower = static_cast<double>(row.number("lower"));
    const auto in_digits = [](double value) {
      return value == std::round(value) ? fmt::format("{:g}", value)
                                        : fmt::format("{:#.13g}", value);
    };
    const std::string text = in_digits(lower);
    if (text != in_digits(static_cast<double>(row.number("upper")))) continue;
    all[quantity].emplace(set, text);
  }
  Json rows = Json::array();
  for (auto& [quantity, row] : all.items()) {
    std::string words = quantity.substr(0, quantity.rfind('_')),
                unit = quantity.substr(quantity.rfind('_') + 1);
    if (unit == "downs") words = quantity, unit = "";
    std::ranges::replace(words, '_', ' ');
    row["says"] = words;
    row["unit"] = unit;
    rows.push_back(row);
  }
  return rows;
}

Json reasons_json(const fs::path& folder) {
  const Json shares = rows_by(folder / "reasons-tried.csv", {"reason", "equations"});
  Json rows = Json::array();
  for (const CsvRow& row : read_csv(folder / "reasons.csv")) {
    const Json& of = shares.at(row["reason"]);
    rows.push_back({{"says", row["says"]},
                    {"place", row["place"]},
                    {"as_printed", of.at("published").at("agree")},
                    {"corrected", of.at("consistent").at("agree")}});
  }
  return rows;
}

}  // namespace

Json studies_json(const Sources& sources) {
  Json all = {{"reasons", reasons_json(sources.reference_data)},
              {"proven", proven_json(sources.reference_data / "proven.csv")}};
  for (const auto& [title, folder, picture] :
       {std::tuple("Run time against error", "work-precision", "work-precision-2.svg"),
        {"The accident in rings of other contact laws", "contact-laws", "contact-laws.svg"},
        {"The outcome over speed and friction", "maps", "speed-friction-outcome.svg"}})
    if (const auto file = fs::path(folder) / picture; fs::exists(sources.report / file))
      all["pictures"].push_back({{"title", title}, {"folder", folder}, {"file", file.string()}});
  return all;
}

Json tests_json(const Sources& sources) {
  struct Law {
    double worst = 0, allowed = 0;
    std::string test;
  };
  std::map<std::string, Law> laws;
  long tests = 0, failed = 0;
  std::set<fs::path> files;
  if (fs::is_directory(sources.tests))
    for (const auto& entry : fs::directory_iterator(sources.tests)) files.insert(entry.path());
  for (const fs::path& file : files) {
    if (!file.filename().string().starts_with("tests-")) continue;
    const Json results = read_json(file);
    for (const Json& suite : results.at("testsuites"))
      for (const Json& test : suite.at("testsuite")) {
        if (test.at("result") == "SUPPRESSED") continue;
        ++tests;
        failed += test.contains("failures");
        for (const auto& [key, value] : test.items()) {
          if (!key.starts_with("law ")) continue;
          Law& law = laws[key.substr(4)];
          double worst = 0;
          std::istringstream(value.get<std::string>()) >> worst >> law.allowed;
          law.worst = std::max(law.worst, worst);
          law.test = name_of(test);
        }
      }
  }
  Json list = Json::array();
  for (const auto& [says, law] : laws)
    list.push_back({{"says", says},
                    {"worst", fmt::format("{:.1e}", law.worst)},
                    {"allowed", fmt::format("{:.1e}", law.allowed)},
                    {"test", law.test}});
  return {{"made", tests > 0},
          {"tests", tests},
          {"failed", failed},
          {"all_pass", failed == 0},
          {"laws", list}};
}

Json provenance_json(const Sources& sources) {
  return {{"version", version()},
          {"commit_date", sources.commit_date},
          {"command", "make deps report"}};
}

}  // namespace rotor
