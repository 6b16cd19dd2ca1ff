/// Results of other targets; the tests; provenance.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <boost/version.hpp>
#include <chrono>
#include <cmath>
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
  // Numbers in names by their size: 1e-5 before 1e-13.
  std::ranges::sort(found, {}, [](const fs::path& file) {
    return std::pair(file.string().size(), file.string());
  });
  return found;
}

/// Suite and name of a test, without its parameters.
std::string name_of(const Json& test) {
  const auto suite = test.at("classname").get<std::string>(),
             name = test.at("name").get<std::string>();
  return suite + '.' + name.substr(0, name.find('/'));
}

/// Position of a relative uncertainty on the chart's logarithmic axis, in percent of its width.
constexpr double least_exponent = -16, greatest_exponent = 1;
std::string on_axis(double value) {
  const double exponent = std::log10(std::max(value, 1e-16)) - least_exponent;
  return fmt::format("{:.1f}", 100 * exponent / (greatest_exponent - least_exponent));
}

/// For each simulated number: the error of the method as a dot, that of the paper's steps as a
/// cross, the effect of the inputs from population (a) to (b) as an interval.
Json uncertainty_json(const fs::path& csv, const Json& names) {
  Json rows = Json::array();
  if (fs::exists(csv))
    for (const CsvRow& row : read_csv(csv)) {
      const auto place = [&](const char* column) {
        return row[column].empty() ? Json()
                                   : Json(on_axis(static_cast<double>(row.number(column))));
      };
      Json line = {{"says", names.value(std::string(row["number"]), std::string(row["number"]))},
                   {"method", place("u_num")},
                   {"steps", place("u_num_published_method")}};
      if (!row["u_input_b"].empty() && row.number("u_input_b") > 0) {
        const auto b = static_cast<double>(row.number("u_input_b"));
        auto a = static_cast<double>(row.number("u_input_a"));
        if (!(a > 0)) a = b;  // the time of the loss changes nothing
        const double from = std::stod(on_axis(a)), to = std::stod(on_axis(b));
        line["inputs"] = {{"from", fmt::format("{:.1f}", std::min(from, to))},
                          {"wide", fmt::format("{:.1f}", std::abs(to - from))}};
      }
      rows.push_back(line);
    }
  return rows;
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
  const auto words = read_trials_in_words(folder);
  Json rows = Json::array();
  for (const Reason& reason : read_reasons(folder / "reasons.csv")) {
    std::string along = reason.quantity.substr(0, reason.quantity.find("_hz"));
    std::ranges::replace(along, '_', ' ');
    rows.push_back({{"cells",
                     {reason.says, reason.place, along, reason.rule(),
                      words.at({reason.id, "published"}), words.at({reason.id, "consistent"})}}});
  }
  return {{"header",
           {"The text, in our words", "Place", "Quantity varied", "Our rule",
            "Equations as printed", "Corrected"}},
          {"rows", rows}};
}

}  // namespace

Json studies_json(const Sources& sources, const Json& names) {
  const Json bars = uncertainty_json(sources.report / "uncertainty.csv", names);
  Json decades = Json::array();
  for (int exponent = -15; exponent <= 0; exponent += 3)
    decades.push_back({{"exponent", exponent}, {"at", on_axis(std::pow(10, exponent))}});
  Json all = {{"uncertainty", bars},
              {"decades", decades},
              {"reasons", reasons_json(sources.reference_data)},
              {"proven", proven_json(sources.reference_data / "proven.csv")}};
  for (const auto& [title, folder, picture] :
       {std::tuple("Run time against error", "work-precision", "work-precision-2.svg"),
        {"Where the paper's method is stable", "stability", "stability.svg"},
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
  return {{"version", ROTOR_VERSION},
          {"commit", sources.commit},
          {"commit_date", sources.commit_date},
          {"command", "make deps report"}};
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
          {"libraries",
           fmt::format("Boost {}.{}, Eigen {}.{}.{}, fmt {}.{}, nlohmann-json {}.{}.{}",
                       BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, EIGEN_WORLD_VERSION,
                       EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, FMT_VERSION / 10000,
                       FMT_VERSION / 100 % 100, NLOHMANN_JSON_VERSION_MAJOR,
                       NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

}  // namespace rotor
