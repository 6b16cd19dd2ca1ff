/// What other targets have made, or have not; the tests; where all of it comes from.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/version.hpp>
#include <chrono>
#include <ctime>
#include <fstream>
#include <map>

#include "figures/data/csv.hpp"
#include "verification/paper/reasons.hpp"
#include "verification/report/document.hpp"

namespace rotor {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> found;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().string().ends_with(ending)) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

/// A study whose tables and pictures stand in a folder below the page's, if they have been made.
Json study_json(const Sources& sources, const std::string& folder) {
  Json files = Json::array();
  for (const auto& file : files_of(sources.report / folder, ""))
    files.push_back(
        {{"file", folder + '/' + file.filename().string()}, {"name", file.filename().string()}});
  return {{"made", !files.empty()}, {"files", files}};
}

/// Suite and name of a test, without its parameters.
std::string name_of(const Json& test) {
  const auto suite = test.at("classname").get<std::string>(),
             name = test.at("name").get<std::string>();
  return suite + '.' + name.substr(0, name.find('/'));
}

Json table_of(const fs::path& csv) {
  if (!fs::exists(csv)) return {{"made", false}};
  Json rows = table_json(csv), header = rows.at(0);
  rows.erase(0);
  Json body = Json::array();
  for (const Json& row : rows) body.push_back({{"cells", row}});
  return {{"made", true}, {"header", header}, {"rows", body}};
}

Json reasons_json(const fs::path& folder) {
  const auto words = read_trials_in_words(folder);
  Json rows = Json::array();
  for (const Reason& reason : read_reasons(folder / "reasons.csv")) {
    std::string along = reason.quantity;
    std::ranges::replace(along, '_', ' ');
    rows.push_back({{"cells",
                     {reason.says, reason.place, along, words.at({reason.id, "published"}),
                      words.at({reason.id, "consistent"})}}});
  }
  return {{"header",
           {"The text, in our words", "Place", "Tried along", "Holds, equations as printed",
            "Holds, corrected"}},
          {"rows", rows}};
}

}  // namespace

Json studies_json(const Sources& sources) {
  Json all = {{"uncertainty", table_of(sources.report / "uncertainty.csv")},
              {"reasons", reasons_json(sources.reference_data)},
              {"maps", study_json(sources, "maps")},
              {"explore", fs::exists(sources.report / "explore.html")}};
  if (sources.of_this_machine) {
    all["work_precision"] = study_json(sources, "work-precision");
    all["stability"] = study_json(sources, "stability");
  }
  return all;
}

Json tests_json(const Sources& sources) {
  struct Law {
    double worst = 0, allowed = 0;
    std::string test;
  };
  std::map<std::string, Law> laws;
  long tests = 0, failed = 0;
  for (const auto& file : files_of(sources.tests, ".json")) {
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
  Json sums = Json::array();
  std::istringstream lines(content_of(sources.report / "SHA256SUMS"));
  for (std::string sum, file; lines >> sum >> file;) sums.push_back({{"file", file}, {"sum", sum}});
  return {{"version", ROTOR_VERSION},
          {"commit", sources.commit},
          {"commit_date", sources.commit_date},
          {"command", "make deps report"},
          {"sums", sums}};
}

Json machine_json() {
  std::string processor = "unknown";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) processor = line.substr(line.find(": ") + 2);
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  return {{"date", date},
          {"processor", processor},
          {"compiler", ROTOR_COMPILER},
          {"flags", ROTOR_FLAGS},
          {"libraries", fmt::format("Boost {}, Eigen {}.{}.{}, {{fmt}} {}, nlohmann-json {}.{}.{}",
                                    BOOST_LIB_VERSION, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                    EIGEN_MINOR_VERSION, FMT_VERSION, NLOHMANN_JSON_VERSION_MAJOR,
                                    NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

}  // namespace rotor
