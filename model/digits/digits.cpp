#include "model/digits/digits.hpp"

#include <algorithm>
#include <array>

#include "model/digits/computation.hpp"
#include "model/digits/quad.hpp"

namespace rotor {
namespace {

/// The coarser computation errs more than the finer one, but both may agree by chance. The error is
/// taken as this multiple of their distance.
constexpr double safety = 20;

template <class S>
double apart(const S& a, const S& b) {
  using std::abs;
  return static_cast<double>(S(abs(a - b)));
}

/// Each value of the finer computation with its error. Even where both happen to agree, steps may
/// err by their tolerance.
template <class S>
std::vector<NamedEstimate> estimates(const std::vector<NamedValue<S>>& fine,
                                     const std::vector<NamedValue<S>>& coarse, double tolerance) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  std::vector<NamedEstimate> all;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    NamedEstimate& result = all.emplace_back(NamedEstimate{.name = fine[i].name});
    if (!fine[i].value) continue;
    const S& exactly = *fine[i].value;
    const auto value = static_cast<double>(exactly);
    result.value = value;
    result.error = apart(exactly, S(value));
    result.size = std::max(std::abs(value), static_cast<double>(fine[i].size));
    if (fine[i].is_exact) continue;
    result.error += coarse[i].value
                        ? safety * apart(exactly, *coarse[i].value) + tolerance * result.size
                        : unknown;
    if (result.name.find("q2") != result.name.npos)  // a component may agree by chance
      result.error = all[i - 1].error = std::max(result.error, all[i - 1].error);
  }
  return all;
}

/// Whether a margin is larger than its error, or zero by its nature.
template <class S>
bool is_wide(const S& fine, const S& coarse) {
  return (fine == 0 && coarse == 0) || static_cast<double>(fine) > safety * apart(fine, coarse);
}

/// Each number off by more than what a computation rounds, which both share in part: contacts
/// multiply it.
Scenario disturbed(Scenario scenario) {
  double share = 64 * std::numeric_limits<double>::epsilon();
  const auto disturb = [&share](double& number) {
    number *= 1 + share;
    share = -share;  // neighbours oppose each other, as mass and stiffness do in a frequency
  };
  auto lost_mass = scenario.parameters.stated_lost_mass(),
       speed_Hz = scenario.stated_mass_loss_speed_Hz();
  for (const Quantity& quantity : quantities())
    if (quantity.name != "contact_exponent")  // in which 1 is no number like others
      disturb(quantity.in(scenario));
  if (auto& start = scenario.start)
    for (double* of : {&start->x, &start->y, &start->velocity_x, &start->velocity_y}) disturb(*of);
  for (auto* of : {&lost_mass, &speed_Hz})
    if (*of) disturb(**of);
  if (lost_mass) scenario.parameters.state_lost_mass(*lost_mass);
  if (speed_Hz) scenario.state_mass_loss_speed(*speed_Hz, scenario.parameters.mass_loss_time);
  return scenario;
}

template <class S>
std::optional<Comparison> compare_in(const Scenario& scenario, double tolerance,
                                     const ShouldContinue& should_continue) {
  const auto coarse = compute<S>(std::is_same_v<S, double> ? disturbed(scenario) : scenario,
                                 S(tolerance), should_continue);
  if (coarse.stopped) return std::nullopt;
  const auto fine = compute<S>(scenario, S(tolerance) / Comparison::finer, should_continue);
  if (fine.stopped) return std::nullopt;

  Comparison result;
  result.tolerance = tolerance;
  result.values = in_double(fine.summary);
  result.counters = fine.counters;
  const auto differ = std::mismatch(
      fine.events.begin(), fine.events.end(), coarse.events.begin(), coarse.events.end(),
      [](const auto& a, const auto& b) { return a.event == b.event && a.contact == b.contact; });
  result.same_course = differ.first == fine.events.end() && differ.second == coarse.events.end() &&
                       fine.end.contact == coarse.end.contact &&
                       fine.summary.outcome == coarse.summary.outcome;
  result.is_course_sure = result.same_course && std::equal(fine.margins.begin(), fine.margins.end(),
                                                           coarse.margins.begin(), is_wide<S>);
  // A miss that only one computation counts as near is too far to matter.
  if (result.same_course)
    for (const auto& [before, miss] : fine.misses)
      if (const auto other = coarse.misses.find(before); other != coarse.misses.end())
        result.is_course_sure = result.is_course_sure && is_wide(miss, other->second);

  const Parameters& p = scenario.parameters;
  result.summary = estimates(values_of(fine.summary, p), values_of(coarse.summary, p), tolerance);
  const auto add = [&](const BasicInstant<S>& at, const BasicInstant<S>& same) {
    result.events.push_back(
        {at.event, estimates(values_of(at, scenario), values_of(same, scenario), tolerance)});
  };
  std::for_each(fine.events.begin(), differ.first,
                [&, same = coarse.events.begin()](const auto& at) mutable { add(at, *same++); });
  add(fine.end, coarse.end);
  return result;
}

/// On another course everything that is computed may have another value.
void forget_errors(std::vector<NamedEstimate>& estimates) {
  for (NamedEstimate& value : estimates)
    if (value.error > 0) value.error = std::numeric_limits<double>::infinity();
}

std::optional<Comparison> compare_to_digits(const Scenario& scenario, int digits,
                                            const ShouldContinue& should_continue) {
  constexpr std::array levels = {std::pair(Precision::double_, 1e-11),
                                 std::pair(Precision::quadruple, 1e-20)};
  std::optional<Comparison> best;
  for (const auto& [precision, tolerance] : levels) {
    std::optional<Comparison> found = compare(precision, scenario, tolerance, should_continue);
    if (!found) break;
    best = std::move(found);
    if (best->has_digits(digits)) break;
  }
  return best;
}

}  // namespace

std::optional<Comparison> compare(Precision precision, const Scenario& scenario, double tolerance,
                                  const ShouldContinue& should_continue) {
  std::optional<Comparison> result = precision == Precision::double_
                                         ? compare_in<double>(scenario, tolerance, should_continue)
                                         : compare_in<Quad>(scenario, tolerance, should_continue);
  if (!result) return result;
  result->precision = precision;
  if (result->is_course_sure) return result;
  forget_errors(result->summary);
  for (EventEstimate& event : result->events) forget_errors(event.values);
  return result;
}

RunToDigits* const run_to_digits = compare_to_digits;

}  // namespace rotor
