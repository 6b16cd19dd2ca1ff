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
#include "verification/paper/convergence.hpp"
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

/// The class of a test is the file that it stands in.
void print_by_class(const std::vector<TestOutcome>& outcomes) {
  struct Class {
    int tests = 0, failed = 0;
    double time_s = 0;
  };
  std::map<std::string, Class> classes;
  for (const TestOutcome& outcome : outcomes) {
    std::string name = outcome.file.substr(0, outcome.file.rfind("_test"));
    std::ranges::replace(name, '_', ' ');
    Class& its = classes[name];
    ++its.tests;
    its.failed += outcome.failed;
    its.time_s += outcome.time_s;
  }
  fmt::print("\n{:<24}{:>6}{:>8}{:>8}\n", "Tests by class", "tests", "failed", "s");
  for (const auto& [name, its] : classes)
    fmt::print("  {:<22}{:>6}{:>8}{:>8.1f}\n", name, its.tests, its.failed, its.time_s);
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

void print_and_write_convergence(FileTransaction& files, const std::filesystem::path& out) {
  const auto all = studied_convergence();
  fmt::print(
      "\nConvergence of the landmarks: relative errors. Those of the event method, which locates "
      "its "
      "events, fall with a power of the tolerance.\nThe paper's method is of fourth order while "
      "nothing is switched; across contacts, which lie anywhere in a step, of first order or "
      "none:\n"
      "it has no asymptotic range in which a grid convergence index would mean anything.\n{}",
      convergence_table(all));
  files.write(out / "convergence.csv", to_csv(all));
}

void print_and_write_uncertainty(const std::vector<Number>& numbers,
                                 const std::filesystem::path& folder, FileTransaction& files,
                                 const std::filesystem::path& out) {
  const auto all = uncertainties(numbers, read_ranking(folder / "ranking.csv"));
  fmt::print(
      "\nUncertainty in the terms of ASME V&V 20, in per cent of the simulated value S. E = S - D, "
      "D being the number as printed,\nu_D half a unit of its last digit. u_num: what the "
      "tolerance "
      "leaves open; by rk4: what the paper's steps do; by (a), by (b): half the\nrange from 5 to "
      "95 % of the populations. decided by: the inputs with the greatest total Sobol' indices over "
      "the box (c)\n(reference-data/ranking.csv). The model's part is not quantified: "
      "reference-data/policy.md\n{}",
      uncertainty_table(all));
  files.write(out / "uncertainty.csv", to_csv(all));
}

/// Whether all numbers have the verdicts that the table expects.
bool print_and_write_claims(const std::vector<Number>& numbers, FileTransaction& files,
                            const std::filesystem::path& out) {
  const auto draws = static_cast<double>(numbers.front().readings.front().in[0].b.spread.draws);
  fmt::print(
      "\nThe claims of the paper's text, by the rules of reference-data/policy.md: verdict with "
      "its "
      "margins off (a) and off (b), then what the\npopulations (a) and (b) give from 5 to 95 %, "
      "and "
      "the share of {} draws in which the claim holds (standard error {:.1f} % at most)\n{}",
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
  print_by_class(outcomes);
  print_audit(outcomes);
  print_register(arguments[2]);
  const std::filesystem::path data = arguments[1], out = arguments[3];
  print_reasons(data);
  const auto numbers = judged_numbers(data);
  FileTransaction files;
  print_and_write_convergence(files, out);
  print_and_write_uncertainty(numbers, data, files, out);
  const bool as_expected = print_and_write_claims(numbers, files, out);
  files.commit();
  return as_expected ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("report", rotor::main, argc, argv); }
