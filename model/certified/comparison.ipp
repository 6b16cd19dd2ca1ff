/// Definitions of comparison.hpp, for instantiation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/certified/computation.hpp"
#include "model/integration/fehlberg.hpp"

namespace rotor {

/// The coarser computations err more than the finest, but may agree with it by chance. Its error is
/// taken as this multiple of their distance from it.
constexpr double safety = 20;
/// Rounding is about a tenth of the disturbance, but errors in other directions may grow more than
/// the disturbance does.
constexpr double safety_of_disturbance = 10;

/// The relative disturbance of a run: more than rounding.
template <class S>
S disturbance() {
  return 8 * std::numeric_limits<S>::epsilon();
}

/// Two independent disturbances.
template <class S>
std::array<Disturbance<S>, 2> disturbances() {
  return {{{disturbance<S>(), 0x135a8f}, {disturbance<S>(), 0x0d31a4}}};
}

template <class S>
struct Computations {
  Computation<S> finest, coarse, disturbed, other;
};

/// A value of the finest computation with the error that the others show.
template <class S>
NamedEstimate estimate(const NamedValue<S>& finest, const NamedValue<S>& coarse,
                       const NamedValue<S>& disturbed, const NamedValue<S>& other,
                       double tolerance) {
  using std::abs, std::max;
  NamedEstimate result{.name = finest.name};
  if (!finest.value) return result;
  const S exactly = *finest.value;
  const auto value = static_cast<double>(exactly);
  const auto printed = static_cast<double>(S(abs(exactly - S(value))));
  result.size = max(std::abs(value), static_cast<double>(finest.size));
  result.estimate = {value, printed};
  if (finest.is_exact) return result;
  if (coarse.value && disturbed.value && other.value) {
    const auto apart = [](const S& a, const S& b) { return static_cast<double>(S(abs(a - b))); };
    const double of_disturbance = safety_of_disturbance * apart(*coarse.value, *disturbed.value);
    // Even where computations happen to agree, each step may err by its tolerance, and each number
    // by its rounding.
    result.of_tolerance =
        safety * max(apart(exactly, *coarse.value), apart(exactly, *other.value) - of_disturbance) +
        tolerance / Comparison::finest * result.size;
    result.of_rounding =
        of_disturbance +
        static_cast<double>(S(disturbance<S>() * max(S(result.size), finest.error_base)));
  } else {
    result.of_tolerance = std::numeric_limits<double>::infinity();
  }
  result.estimate->error += result.of_tolerance + result.of_rounding;
  return result;
}

/// The same for many values, which `values_of(computation)` returns.
template <class S, class ValuesOf>
std::vector<NamedEstimate> estimates(const Computations<S>& of, double tolerance,
                                     const ValuesOf& values_of) {
  const auto finest = values_of(of.finest), coarse = values_of(of.coarse),
             disturbed = values_of(of.disturbed), other = values_of(of.other);
  std::vector<NamedEstimate> all;
  for (std::size_t i = 0; i < finest.size(); ++i)
    all.push_back(estimate<S>(finest[i], coarse[i], disturbed[i], other[i], tolerance));
  return all;
}

/// The number of events before the first on which the computations disagree.
template <class S>
std::size_t common_events(const Computation<S>& a, const Computation<S>& b) {
  const auto differ = std::mismatch(
      a.events.begin(), a.events.end(), b.events.begin(), b.events.end(),
      [](const auto& x, const auto& y) { return x.event == y.event && x.contact == y.contact; });
  return static_cast<std::size_t>(differ.first - a.events.begin());
}

/// Whether two computations have the same events, contact state at the end and outcome.
template <class S>
bool agree(const Computation<S>& a, const Computation<S>& b) {
  return a.events.size() == b.events.size() && common_events(a, b) == a.events.size() &&
         a.end.contact == b.end.contact && a.summary.outcome == b.summary.outcome;
}

/// How far two instants are apart, relative to the clearance and its velocity.
template <class S>
double distance(const BasicInstant<S>& a, const BasicInstant<S>& b, const S& clearance) {
  using std::abs;
  const Motion<S> m = a.motion(), n = b.motion();
  const S velocity = clearance * (abs(m.speed) + 1);
  return static_cast<double>(S((m.displacement - n.displacement).norm() / clearance +
                               (m.velocity - n.velocity).norm() / velocity));
}

/// Growth of the distance from the first touch-down to the last event that two computations have in
/// common, or to the end if they have all.
template <class S>
std::optional<double> amplification(const Computation<S>& a, const Computation<S>& b,
                                    const S& clearance) {
  const std::size_t common = common_events(a, b);
  const auto last = a.events.begin() + static_cast<std::ptrdiff_t>(common);
  const auto touch = std::find_if(a.events.begin(), last,
                                  [](const auto& at) { return at.event == Event::touch_down; });
  if (touch == last) return std::nullopt;
  const auto apart = [&](std::size_t i) { return distance(a.events[i], b.events[i], clearance); };
  const double before = apart(static_cast<std::size_t>(touch - a.events.begin()));
  if (!(before > 0)) return std::nullopt;
  const bool all = common == a.events.size() && common == b.events.size();
  return (all ? distance(a.end, b.end, clearance) : apart(common - 1)) / before;
}

template <class S>
std::optional<Comparison> compare(const Scenario& scenario, double tolerance,
                                  const ShouldContinue& should_continue) {
  // In the highest precision the part of rounding in the error is not needed.
  constexpr bool is_last = std::numeric_limits<S>::digits > 64;
  const auto [first, second] = disturbances<S>();
  const S usual(tolerance);
  const Settings<S> coarse{usual}, disturbed{usual, S(1), first},
      other{usual / Comparison::other, S(5) / 8, second},
      finest{usual / Comparison::finest, S(3) / 8};
  Computations<S> all;
  using Unknowns = std::array<S, 6>;
  const auto goes_well = [&]<class Stepper>(Stepper, Computation<S>& into,
                                            const Settings<S>& settings) {
    into = compute<S, Stepper>(scenario, settings, should_continue);
    return !into.stopped;
  };
  const Verner87<Unknowns, S> verner;
  const Fehlberg78<Unknowns, S> fehlberg;
  const bool finished = goes_well(verner, all.coarse, coarse) &&
                        goes_well(fehlberg, all.other, other) &&
                        (is_last || goes_well(verner, all.disturbed, disturbed)) &&
                        goes_well(verner, all.finest, finest);
  if (!finished) return std::nullopt;

  if (is_last) all.disturbed = all.coarse;
  const Computation<S>& best = all.finest;
  Comparison result;
  result.tolerance = tolerance;
  result.values = in_double(best.summary);
  result.end = {in_double(best.end), best.counters};
  const S clearance = Ring<S>(scenario.parameters).clearance;
  std::size_t common = best.events.size();
  result.same_course = true;
  for (const auto* run : {&all.coarse, &all.disturbed, &all.other}) {
    common = std::min(common, common_events(best, *run));
    result.same_course = result.same_course && agree(best, *run);
  }
  const auto estimates_of = [&](const auto& values_of) {
    return estimates<S>(all, tolerance, values_of);
  };
  for (std::size_t i = 0; i < common; ++i)
    result.events.push_back({best.events[i].event, estimates_of([&](const Computation<S>& run) {
                               return values_of(run.events[i], scenario);
                             })});
  result.events.push_back({Event::none, estimates_of([&](const Computation<S>& run) {
                             return values_of(run.end, scenario);
                           })});
  result.summary = estimates_of(
      [&](const Computation<S>& run) { return values_of(run.summary, scenario.parameters); });
  if (result.same_course)
    result.margins =
        estimates_of([&](const Computation<S>& run) { return margins_of(run, scenario); });
  result.amplification = amplification(all.coarse, all.other, clearance);
  if (!result.is_course_sure()) result.invalidate_path_dependent_values();
  return result;
}

// In in_double.cpp; tests use them, too.
extern template std::optional<Comparison> compare<double>(const Scenario&, double,
                                                          const ShouldContinue&);
extern template class EventMethod<double, Fehlberg78<std::array<double, 6>, double>>;

}  // namespace rotor
