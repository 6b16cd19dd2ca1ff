/// Prints what a reviewer wants to see: the outcome of the tests by class, and what the model makes
/// of every published number, which it writes as well: `report TESTS TABLE OUT`, where TESTS is
/// GoogleTest's JSON.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "figures/csv.hpp"
#include "verification/published_values.hpp"

namespace rotor {
namespace {

/// The class of a test is the file that it stands in.
void print_by_class(const std::filesystem::path& results) {
  struct Outcome {
    int tests = 0, failed = 0;
    double time_s = 0;
  };
  std::map<std::string, Outcome> classes;
  std::ifstream file(results);
  if (!file) {
    fmt::print("\nThe tests ended before their time: there is no {}.\n", results.string());
    return;
  }
  const auto document = nlohmann::json::parse(file);
  for (const auto& suite : document.at("testsuites"))
    for (const auto& test : suite.at("testsuite")) {
      const std::string stem = std::filesystem::path(test.at("file").get<std::string>()).stem();
      std::string name = stem.substr(0, stem.rfind("_test"));
      std::ranges::replace(name, '_', ' ');
      Outcome& outcome = classes[name];
      ++outcome.tests;
      outcome.failed += test.contains("failures") ? 1 : 0;
      outcome.time_s += std::stod(test.at("time").get<std::string>());
    }
  fmt::print("\n{:<24}{:>6}{:>8}{:>8}\n", "Tests by class", "tests", "failed", "s");
  for (const auto& [name, outcome] : classes)
    fmt::print("  {:<22}{:>6}{:>8}{:>8.1f}\n", name, outcome.tests, outcome.failed, outcome.time_s);
}

int print_and_write_numbers(const std::filesystem::path& table, const std::filesystem::path& out) {
  const auto values = published_values(table);
  bool as_expected = true;
  for (const std::string verdict : {"reproduced", "close", "differs", "excused"}) {
    const auto of_it = [&](const PublishedValue& value) { return value.verdict == verdict; };
    fmt::print("\nPublished numbers {}: {}\n", verdict, std::ranges::count_if(values, of_it));
    for (const PublishedValue& value : values) {
      if (!of_it(value)) continue;
      as_expected = as_expected && value.verdict == value.expected_verdict;
      fmt::print("  {:<52} {:>9} {:<7} {:>10}  {}\n", value.quantity, value.printed, value.unit,
                 value.computed ? fmt::format("{:.5g}", *value.computed) : "", value.reason);
    }
  }
  FileTransaction files;
  files.write(out, to_csv(values));
  files.commit();
  return as_expected ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  try {
    if (argc != 4)
      throw std::runtime_error(
          "needs the tests' results, the table of published values and an output file");
    rotor::print_by_class(argv[1]);
    return rotor::print_and_write_numbers(argv[2], argv[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "report: {}\n", error.what());
    return 1;
  }
}
