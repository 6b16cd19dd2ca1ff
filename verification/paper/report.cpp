/// Prints what a reviewer wants to see: the outcome of the tests by class, what the audit shows,
/// what becomes of every claim of the paper, which it writes as well, and what the paper leaves
/// open: `report TESTS DATA REGISTER OUT`, where TESTS is a folder with GoogleTest's JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "verification/paper/claims.hpp"
#include "verification/paper/reasons.hpp"
#include "verification/paper/uncertainty.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

struct TestOutcome {
  std::string suite, name, file;
  bool failed;
  double time_s;
};

/// Of all shards. Empty if the tests ended before they could say.
std::vector<TestOutcome> read_outcomes(const std::filesystem::path& folder) {
  std::vector<TestOutcome> outcomes;
  for (int shard = 0;; ++shard) {
    std::ifstream file(folder / fmt::format("tests-{}.json", shard));
    if (!file) break;
    const auto document = nlohmann::json::parse(file);
    for (const auto& suite : document.at("testsuites"))
      for (const auto& test : suite.at("testsuite"))
        if (test.at("result") != "SUPPRESSED")
          outcomes.push_back(
              {test.at("classname").get<std::string>(), test.at("name").get<std::string>(),
               std::filesystem::path(test.at("file").get<std::string>()).stem().string(),
               test.contains("failures"), std::stod(test.at("time").get<std::string>())});
  }
  return outcomes;
}

/// The name of a test as words.
std::string in_words(const std::string& name) {
  std::string words;
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto is_upper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; };
  for (const char c : name.substr(0, name.find('/'))) {
    const bool begins = is_upper(c) || (is_digit(c) && !words.empty() && !is_digit(words.back()));
    if (begins && !words.empty()) words += ' ';
    words += c;
  }
  return words;
}

void print_audit(const std::vector<TestOutcome>& outcomes) {
  fmt::print("\nWhat the audit of the paper shows (Audit in verification/paper/audit_test.cpp)\n");
  std::string last;
  for (const TestOutcome& outcome : outcomes) {
    const std::string words = in_words(outcome.name);
    const bool audits = outcome.suite.find("Audit") != std::string::npos;
    if (!audits || (words == last && !outcome.failed)) continue;  // one line for several cases
    fmt::print("  {} {}\n", outcome.failed ? "FAILED" : "holds:", words);
    last = words;
  }
}

/// Whether all numbers have the verdicts that the table expects.
bool print_and_write_claims(const std::vector<Number>& numbers, FileTransaction& files,
                            const std::filesystem::path& out) {
  const auto draws = static_cast<double>(numbers.front().readings.front().in[0].b.spread.draws);
  fmt::print(
      "\nThe claims of the paper's text, by the rules of reference-data/policy.md, over {} draws "
      "of "
      "each population (standard error of a share: {:.1f} % at most)\n{}",
      draws, 50 / std::sqrt(draws), claims_table(numbers));
  files.write(out / "claims.csv", to_csv(numbers));
  std::string counts = "equations,width_of_words,reproduced,within_rounding,refuted\n";
  bool as_expected = true;
  for (const Counts& its : sensitivity(numbers))
    counts += fmt::format("{},{},{},{},{}\n", its.set, its.words, its.claims.at("reproduced"),
                          its.claims.at("within rounding"), its.claims.at("refuted"));
  files.write(out / "verdict-counts.csv", counts);
  for (std::size_t set = 0; set < sets.size(); ++set)
    for (const Number& number : numbers)
      as_expected = as_expected && verdict_of(number, set).says == number.expected[set];
  return as_expected;
}

void print_register(const std::filesystem::path& assumptions) {
  fmt::print("\nWhat the paper leaves open, and what follows from either choice\n");
  for (const CsvRow& row : read_csv(assumptions))
    fmt::print("  {}: {}: {} {}; {}: {} {}\n", row["quantity"], row["taken"], row["value_taken"],
               row["unit"], row["other"], row["value_other"], row["unit"]);
}

void print_reasons(const std::filesystem::path& folder) {
  fmt::print(
      "\nThe paper's reasons for the accident, on the rotors of verification/paper/reasons.toml: "
      "for "
      "a random rotor and a random pair of\nvalues, how often the riskier one is not worse, where "
      "the statement applies; else, the force at it relative to that at the other one\n(median). "
      "Last, how often a quantity decides whether the rotor rolls (reference-data/reasons.csv; "
      "make "
      "reasons)\n  {:<62}{:<20}{:>28}{:>28}\n",
      "", "along", "published", "consistent");
  const auto words = read_trials_in_words(folder);
  for (const Reason& reason : read_reasons(folder / "reasons.csv"))
    fmt::print("  {:<62}{:<20}{:>28}{:>28}\n", reason.says, reason.quantity,
               words.at({reason.id, "published"}), words.at({reason.id, "consistent"}));
}

int main(const Arguments& arguments) {
  if (arguments.size() != 4)
    throw std::runtime_error(
        "needs the tests' results, the folder of reference data, the register of assumptions and "
        "an output folder");
  const std::vector<TestOutcome> outcomes = read_outcomes(arguments[0]);
  if (outcomes.empty())
    fmt::print("\nThe tests ended before their time: there is no {}/tests-0.json.\n", arguments[0]);
  print_audit(outcomes);
  print_register(arguments[2]);
  const std::filesystem::path data = arguments[1], out = arguments[3];
  print_reasons(data);
  const auto numbers = judged_numbers(data);
  FileTransaction files;
  files.write(out / "uncertainty.csv",
              to_csv(uncertainties(numbers, read_ranking(data / "ranking.csv"))));
  const bool as_expected = print_and_write_claims(numbers, files, out);
  files.commit();
  return as_expected ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("report", rotor::main, argc, argv); }
