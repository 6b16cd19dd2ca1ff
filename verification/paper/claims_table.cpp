#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "verification/paper/claims.hpp"

namespace rotor {
namespace {

std::string digits(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : "-";
}
std::string range(const Stored& stored) {
  if (stored.spread.draws == 0) return {};
  return fmt::format("{:.4g} ... {:.4g}, {:.0f} %", stored.spread.low, stored.spread.high,
                     100 * stored.holds);
}

/// Verdict and margins of a number, and what its readings give.
std::string lines_of(const Number& number) {
  const Verdict as_printed = verdict_of(number, 0), corrected = verdict_of(number, 1);
  std::string lines;
  for (const Reading& reading : number.readings) {
    const bool first = &reading == &number.readings.front();
    const auto& in = reading.in[0];
    lines +=
        fmt::format("  {:<30}  {:<80}{:>12} {:<7}{:>10}{:>10}  {:<32}{:<32}{:>10}  {}\n",
                    first ? fmt::format("{:<16}{:>7.2g}{:>7.2g}", as_printed.says, as_printed.off_a,
                                        as_printed.off_b)
                          : "",
                    first ? number.says : "    or: " + reading.name,
                    !first                   ? ""
                    : number.printed.empty() ? number.rule
                                             : number.printed,
                    first ? number.unit : "", digits(in.converged), digits(in.by_rk4), range(in.a),
                    range(in.b), digits(reading.in[1].converged), first ? corrected.says : "");
  }
  if (!number.reason.empty()) lines += fmt::format("{:34}({})\n", "", number.reason);
  return lines;
}

}  // namespace

std::vector<int> figures_without_claim(const std::vector<Number>& numbers) {
  std::set<int> claimed;
  for (const Number& number : numbers) {
    std::istringstream figures(number.figures);
    for (int figure = 0; figures >> figure;) claimed.insert(figure);
  }
  std::vector<int> without;
  for (int figure = 2; figure <= 17; ++figure)
    if (!claimed.contains(figure)) without.push_back(figure);
  return without;
}

std::string claims_table(const std::vector<Number>& numbers) {
  const auto verdicts = verdicts_of_claims(numbers, 0);
  std::string table =
      fmt::format("  {:<16}{:>7}{:>7}    {:<78}{:>12} {:<7}{:>10}{:>10}  {:<32}{:<32}{:>10}\n", "",
                  "off (a)", "off (b)", "", "printed", "", "converged", "by rk4", "over (a), holds",
                  "over (b), holds", "corrected");
  std::string claim;
  for (const Number& number : numbers) {
    const auto count = std::ranges::count(numbers, number.claim, &Number::claim);
    if (number.claim != claim && count > 1)
      table += fmt::format("  {}: {}, as the worst of\n", number.claim, verdicts.at(number.claim));
    claim = number.claim;
    table += lines_of(number);
  }
  table += "\nVerdicts by the width that words are given:\n";
  for (const Counts& counts : sensitivity(numbers))
    table += fmt::format("  {:<11}{:>4} times: {}\n", counts.set, counts.words,
                         fmt::join(counts.claims, ", "));
  return table + fmt::format("nothing is claimed about Figs. {}, which is no success.\n",
                             fmt::join(figures_without_claim(numbers), ", "));
}

}  // namespace rotor
