#include <algorithm>
#include <cmath>

#include "model/certified/comparison.hpp"
#include "model/certified/quad.hpp"

namespace rotor {
namespace {

struct PrecisionLevel {
  Precision precision;
  double epsilon;
  std::optional<Comparison> (*compare)(const Scenario&, double, const ShouldContinue&);

  /// The finest computation has a hundredth of it, still some tens of roundings.
  double least_tolerance() const { return 4096 * epsilon; }
};

template <class S>
PrecisionLevel level(Precision precision) {
  return {precision, static_cast<double>(std::numeric_limits<S>::epsilon()), compare<S>};
}

/// The available precisions, the cheapest first.
const std::vector<PrecisionLevel>& all_levels() {
  static const std::vector<PrecisionLevel> all = [] {
    std::vector<PrecisionLevel> list = {level<double>(Precision::double_)};
    if constexpr (std::numeric_limits<long double>::digits == 64)  // otherwise equal to another
      list.push_back(level<long double>(Precision::extended));
    list.push_back(level<Quad>(Precision::quadruple));
    return list;
  }();
  return all;
}

/// By which factors errors exceed what is allowed: those of tolerance and of rounding, and both.
struct Excess {
  double of_tolerance = 0, of_rounding = 0, of_both = 0;

  void note(const NamedEstimate& value, double allowed) {
    if (!value.estimate) return;
    const auto keep_greatest = [allowed](double& greatest, double error) {
      if (error > 0) greatest = std::max(greatest, error / allowed);
    };
    keep_greatest(of_tolerance, value.of_tolerance);
    keep_greatest(of_rounding, value.of_rounding);
    keep_greatest(of_both, value.estimate->error);
  }
};

Excess excess(const Comparison& comparison, int digits) {
  Excess largest;
  const auto note = [&](const std::vector<NamedEstimate>& values) {
    for (const NamedEstimate& value : values) largest.note(value, value.allowed_error(digits));
  };
  note(comparison.summary);
  for (const EventEstimate& event : comparison.events) note(event.values);
  return largest;
}

/// What another comparison needs, after one that does not have the digits.
struct Needs {
  double tolerance, epsilon;
};

Needs needs_after(const Comparison& comparison, double epsilon, int digits) {
  // The target as a share of the allowed error: tolerances are free to choose, precisions are few.
  constexpr double of_tolerance = 0.2, of_rounding = 0.7;
  constexpr double if_unknown = 1e-4;  // where the missing accuracy is unknown
  constexpr double least = 1e-12;
  const auto factor = [&](double share, double excess) {
    return std::max(least, std::min(1., share / excess));
  };
  if (!comparison.same_course) return {comparison.tolerance * if_unknown, 1};
  Excess now;
  for (const NamedEstimate& margin : comparison.margins)
    if (margin.has_finite_error()) now.note(margin, std::abs(margin.estimate->value));
  if (now.of_both < 1) now = excess(comparison, digits);
  const Needs needs = {comparison.tolerance * factor(of_tolerance, now.of_tolerance),
                       epsilon * factor(of_rounding, now.of_rounding)};
  const bool is_same = needs.tolerance == comparison.tolerance && needs.epsilon == epsilon;
  return is_same ? Needs{comparison.tolerance / 10, epsilon} : needs;
}

}  // namespace

void require_certified() {}

std::optional<Comparison> run_to_digits(const Scenario& scenario, int digits,
                                        const ShouldContinue& should_continue) {
  const std::vector<PrecisionLevel>& all = all_levels();
  // How much the run multiplies errors is not known yet; a thousand is usual. In double precision a
  // run shows it at a tolerance where errors of steps and of rounding can both be seen.
  constexpr double telling = 1e-10;
  double tolerance = std::max(telling, std::pow(10, -digits - 3));
  auto by = all.begin();
  std::optional<Comparison> best;
  for (;;) {
    std::optional<Comparison> found = by->compare(scenario, tolerance, should_continue);
    if (!found) break;
    found->precision = by->precision;
    best = std::move(found);
    if (has_digits(*best, digits)) break;
    const Needs needs = needs_after(*best, by->epsilon, digits);
    const auto serves = [&](const PrecisionLevel& level) {
      return level.least_tolerance() <= needs.tolerance && level.epsilon <= needs.epsilon;
    };
    by = std::find_if(by, all.end(), serves);
    if (by == all.end()) {  // the highest precision at its least tolerance
      --by;
      if (!(by->least_tolerance() < tolerance)) break;
    }
    tolerance = std::max(needs.tolerance, by->least_tolerance());
  }
  return best;
}

}  // namespace rotor
