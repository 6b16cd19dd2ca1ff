/// Prints the verdict on every claim of the paper, and writes the claims and their uncertainties:
/// `report-numbers DATA OUT`.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/data/files.hpp"
#include "verification/paper/uncertainty.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

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
  bool as_expected = true;
  for (std::size_t set = 0; set < sets.size(); ++set)
    for (const Number& number : numbers)
      as_expected = as_expected && verdict_of(number, set).says == number.expected[set];
  return as_expected;
}

int main(const Arguments& arguments) {
  if (arguments.size() != 2)
    throw std::runtime_error("needs the folder of reference data and an output folder");
  const std::filesystem::path data = arguments[0], out = arguments[1];
  const auto numbers = judged_numbers(data);
  FileTransaction files;
  files.write(out / "uncertainty.csv", to_csv(uncertainties(numbers)));
  const bool as_expected = print_and_write_claims(numbers, files, out);
  files.commit();
  return as_expected ? 0 : 1;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("report", rotor::main, argc, argv); }
