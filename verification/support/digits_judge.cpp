#include "verification/support/digits_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures/results/estimated_result.hpp"

namespace rotor {
namespace {

void compare_values(const std::string& where, const std::vector<NamedEstimate>& found, int digits,
                    const std::vector<NamedEstimate>& exact, std::string& falsehoods) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const NamedEstimate &ours = found[i], &best = exact[i];
    const auto complain = [&](const std::string& what) {
      falsehoods += fmt::format("{}{} {}; ", where, ours.name, what);
    };
    if (ours.value.has_value() != best.value.has_value()) complain("exists or not");
    if (!ours.value || !best.value || *ours.value == *best.value) continue;
    const double truth = *best.value, doubt = best.error + 2.3e-16 * std::abs(truth),
                 off = std::max(0., std::abs(*ours.value - truth) - doubt);
    if (off > ours.error) complain(fmt::format("is {:.2e} off, not {:.2e}", off, ours.error));
    const std::string printed = text_within(*ours.value, ours.error, digits);
    if (ours.error == 0 || printed == no_digit) continue;
    bool is_true = false;
    for (int n = digits; n > 0; --n)
      for (const double by : {-doubt, doubt})
        is_true = is_true || rounded_to(truth + by, n) == printed;
    if (!is_true) complain("is printed as " + printed);
  }
}

}  // namespace

RandomRuns judged_runs(unsigned seed) {
  ScenarioSpec fixed;
  fixed.method = Method::event;
  fixed.digits = 1;  // refuses what has none
  fixed.loses_mass = true;
  return RandomRuns(seed, fixed, 300, 16);
}

std::string falsehood(const Comparison& found, int digits, const Comparison& exact) {
  if (!found.is_course_sure) return "";  // then nothing is claimed
  if (!exact.is_course_sure) return "the course is known, but not to quadruple precision; ";
  if (found.values.touch_downs != exact.values.touch_downs ||
      found.values.outcome != exact.values.outcome || found.events.size() != exact.events.size())
    return "another course; ";
  std::string falsehoods;
  compare_values("", found.summary, digits, exact.summary, falsehoods);
  for (std::size_t i = 0; i < found.events.size(); ++i)
    compare_values(fmt::format("event {} ", i), found.events[i].values, digits,
                   exact.events[i].values, falsehoods);
  return falsehoods;
}

std::array<JudgedDigits, judged_digits.size()> judge(const Scenario& scenario) {
  constexpr double finest = 1e-22;
  constexpr long most_steps = 100'000;  // a minute's work
  const auto patiently = [n = 0L](double /*time_s*/) mutable { return ++n < most_steps; };
  std::array<JudgedDigits, judged_digits.size()> all;
  const auto exact = compare(Precision::quadruple, scenario, finest, patiently);
  if (!exact) return all;
  std::optional<Comparison> found;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const int digits = judged_digits[n];
    if (!found || !found->has_digits(digits)) found = run_to_digits(scenario, digits, patiently);
    if (found->has_digits(digits)) all[n].given = name_of(found->precision).front();
    all[n].falsehood = falsehood(*found, digits, *exact);
  }
  return all;
}

}  // namespace rotor
