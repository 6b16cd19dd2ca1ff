#include "verification/paper/claims_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "figures/scenes/scene.hpp"

namespace rotor {
namespace {

std::vector<int> figures_of(const Number& number) {
  std::istringstream stream(number.figures);
  std::vector<int> figures;
  for (int figure = 0; stream >> figure;) figures.push_back(figure);
  return figures;
}

/// Where a claim is printed: with its first figure, or else with the first of its places.
std::string heading_of(const Number& number) {
  const std::vector<int> figures = figures_of(number);
  if (!figures.empty()) return fmt::format("Fig. {}", figures.front());
  const std::string first = number.place.substr(0, number.place.find(" and "));
  return first.starts_with("Secs.") ? "Sec." + first.substr(5) : first;
}

std::string digits(const std::optional<double>& value) {
  return value ? fmt::format("{:.5g}", *value) : "-";
}
std::string range(const Spread& spread) {
  return spread.draws == 0 ? "" : fmt::format("{:.4g} ... {:.4g}", spread.low, spread.high);
}
std::string share(const Spread& spread) {
  return spread.draws == 0 ? "" : fmt::format("{:.0f} %", 100 * spread.share);
}

std::string lines_of(const Number& number) {
  std::string lines;
  for (const Reading& reading : number.readings) {
    const bool first = &reading == &number.readings.front();
    lines +=
        fmt::format("  {:<16}{:<80}{:>10} {:<7}{:>10}{:>10}  {:<20}{:>6}  {:<20}{:>6}\n",
                    first ? number.verdict : "", first ? number.says : "    or: " + reading.name,
                    !first                   ? ""
                    : number.printed.empty() ? number.rule
                                             : number.printed,
                    first ? number.unit : "", digits(reading.converged), digits(reading.by_rk4),
                    range(reading.times), share(reading.times), range(reading.everything),
                    share(reading.everything));
  }
  if (!number.reason.empty()) lines += fmt::format("{:18}({})\n", "", number.reason);
  return lines;
}

}  // namespace

std::vector<int> figures_without_claim(const std::vector<Number>& numbers) {
  std::set<int> claimed;
  for (const Number& number : numbers)
    for (const int figure : figures_of(number)) claimed.insert(figure);
  std::vector<int> without;
  for (const auto& [figure, scene] : figure_files(ROTOR_SOURCES "/figures/paper"))
    if (!claimed.contains(figure)) without.push_back(figure);
  return without;
}

std::string claims_table(const std::vector<Number>& numbers) {
  const auto verdicts = verdicts_of_claims(numbers);
  std::vector<std::string> headings, claims;
  for (const Number& number : numbers) {
    if (std::ranges::find(claims, number.claim) != claims.end()) continue;
    claims.push_back(number.claim);
    if (std::ranges::find(headings, heading_of(number)) == headings.end())
      headings.push_back(heading_of(number));
  }
  // Figures, Nomenclature, sections. Equations without a figure stand in Sec. 3.
  const auto order = [](const std::string& heading) {
    constexpr double nomenclature = 100, equations = nomenclature + 3.5;
    if (heading.starts_with("Fig. ")) return std::stod(heading.substr(5));
    if (heading.starts_with("Sec. ")) return nomenclature + std::stod(heading.substr(5));
    return heading.starts_with("Eq. ") ? equations : nomenclature;
  };
  std::ranges::stable_sort(headings, {}, order);
  std::string table =
      fmt::format("  {:<96}{:>10} {:<7}{:>10}{:>10}  {:<20}{:>6}  {:<20}{:>6}\n", "", "printed", "",
                  "converged", "by rk4", "rounding of t_1", "holds", "of every digit", "holds");
  for (const std::string& heading : headings) {
    table += heading + '\n';
    for (const std::string& claim : claims) {
      const auto is_its = [&](const Number& number) { return number.claim == claim; };
      if (heading_of(*std::ranges::find_if(numbers, is_its)) != heading) continue;
      if (std::ranges::count_if(numbers, is_its) > 1)
        table += fmt::format("  {}: {}, as the worst of\n", claim, verdicts.at(claim));
      for (const Number& number : numbers)
        if (is_its(number)) table += lines_of(number);
    }
  }
  table += fmt::format("\nOf {} claims:", verdicts.size());
  for (const std::string verdict : {"reproduced", "within rounding", "refuted"})
    table += fmt::format(
        " {} {};",
        std::ranges::count(verdicts, verdict, [](const auto& claim) { return claim.second; }),
        verdict);
  return table + fmt::format(" nothing is claimed about Figs. {}, which is no success.\n",
                             fmt::join(figures_without_claim(numbers), ", "));
}

}  // namespace rotor
