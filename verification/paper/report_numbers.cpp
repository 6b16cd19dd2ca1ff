/// Prints the verdict on every claim of the paper, and writes the claims: `report-numbers DATA
/// OUT`; or all that is known about one claim: `report-numbers DATA claim ID`; without ID, or with
/// an empty one, a list of the claims.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "figures/data/files.hpp"
#include "figures/input/words.hpp"
#include "verification/paper/tally.hpp"
#include "verification/paper/words.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

/// Whether all numbers have the verdicts that the table expects.
bool print_and_write_claims(const std::vector<Number>& numbers, FileTransaction& files,
                            const std::filesystem::path& out) {
  const auto draws = static_cast<double>(numbers.front().readings.front().in[0].b.spread.draws);
  fmt::print(
      "\nThe claims of the paper's text, each by its own rule of reference-data/policy.md, over {} "
      "draws\nof each population (standard error of a share: {:.1f} % at most), and in brackets "
      "how many of\nthese no other rule turns. make claim ID=... prints all that is known about "
      "one.\n\n{}",
      draws, 50 / std::sqrt(draws), claims_table(numbers));
  files.write(out / "claims.csv", to_csv(numbers));
  bool as_expected = true;
  for (std::size_t set = 0; set < sets.size(); ++set)
    for (const Number& number : numbers)
      as_expected = as_expected && verdict_of(number, set) == number.expected[set];
  return as_expected;
}

/// A reading in one set of equations.
void print_reading(const Number& number, const Reading& reading, std::size_t set) {
  const auto text = [](const auto& value) { return value ? fmt::format("{:.6g}", *value) : "-"; };
  const Reading::InSet& in = reading.in[set];
  fmt::print("    {:<24} converged {}{}\n", reading.name, text(in.converged),
             set == 0 ? ", published method " + text(in.by_rk4) : "");
  if (!number.is_drawn()) return;
  for (const auto& [population, over] : {std::pair("a", in.a), std::pair("b", in.b)})
    fmt::print(
        "      population ({}): median {:.6g}, 5 to 95 % {:.6g} to {:.6g}; holds in {:.1f} % of {} "
        "draws\n",
        population, over.spread.median, over.spread.low, over.spread.high, 100 * over.holds,
        over.spread.draws);
}

void print_number(const Number& n, const std::vector<Number>& numbers) {
  fmt::print("{}: {} ({})\n  paper: {}; allowed by rule {}\n", n.id, words_of(n), n.place,
             printed(n), rule_of(n));
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto value = value_of(n, set), share = share_with_value(n, set);
    fmt::print(
        "  {}: {}, {}{}{}\n", sets_in_words[set].words, words_of(verdict_of(n, set)),
        shown(value, n),
        share && *share < 1 ? fmt::format(" (such a value in {:.0f} % of (b))", 100 * *share) : "",
        n.readings.size() > 1 ? ", by " + n.readings[n.decides[set]].name : "");
    for (const Reading& reading : n.readings) print_reading(n, reading, set);
    for (const std::string& other : other_verdicts(n, set, numbers))
      fmt::print("    by another rule {}\n", other);
  }
  if (!n.reason.empty()) fmt::print("  reason: {}\n", n.reason);
  std::istringstream figures(n.figures);
  for (int figure = 0; figures >> figure;)
    fmt::print("  shown by: make fig{0:02}; build/rotor run figures/paper/fig{0:02}.toml\n",
               figure);
}

int show_claim(const std::filesystem::path& data, const std::string& id) {
  const std::vector<Number> table = read_numbers(data / "claims.csv");
  if (id.empty()) {
    fmt::print("{}", claims_list(judged_numbers(data), read_csv(data / "reasons.csv")));
    return 0;
  }
  const std::string claim = of_claim(table, id).front().claim;  // before all are computed
  const std::vector<Number> numbers = judged_numbers(data);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const auto claims = judged_claims(numbers, set);
    const auto of = std::ranges::find(claims, claim, &JudgedClaim::claim);
    fmt::print("{}, {}: {}, {}\n", claim, sets_in_words[set].words, words_of(of->verdict),
               of->turned_by.empty() ? "turned by no other rule"
                                     : fmt::format("turned by {} of {} other rules",
                                                   of->turned_by.size(), other_rules().size()));
  }
  for (const Number& n : of_claim(numbers, id)) print_number(n, numbers);
  return 0;
}

int main(const Arguments& arguments) {
  if (arguments.size() >= 2 && arguments.size() <= 3 && arguments[1] == "claim")
    return show_claim(arguments[0], arguments.size() == 3 ? arguments[2] : "");
  if (arguments.size() != 2)
    throw std::runtime_error("needs the folder of reference data and an output folder");
  const std::filesystem::path data = arguments[0], out = arguments[1];
  const auto numbers = judged_numbers(data);
  FileTransaction files;
  const bool as_expected = print_and_write_claims(numbers, files, out);
  files.commit();
  return as_expected ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("report", rotor::main, argc, argv); }
