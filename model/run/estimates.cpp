#include "model/run/estimates.hpp"

#include <algorithm>

namespace rotor {

bool Comparison::is_course_sure() const {
  // A miss that only some computations count as near is too far to be a margin.
  return same_course && std::none_of(margins.begin(), margins.end(), [](const auto& margin) {
           return margin.has_finite_error() && !(margin.estimate->value > margin.estimate->error);
         });
}

void Comparison::invalidate_path_dependent_values() {
  const auto forget = [](std::vector<NamedEstimate>& estimates) {
    for (NamedEstimate& value : estimates)
      if (value.estimate && value.of_tolerance > 0)
        value.estimate->error = std::numeric_limits<double>::infinity();
  };
  forget(summary);
  for (EventEstimate& event : events) forget(event.values);
}

int sure_digits(const NamedEstimate& value) {
  int digits = most_digits;
  while (digits > 0 && value.estimate && !(value.estimate->error <= value.allowed_error(digits)))
    --digits;
  return digits;
}

bool has_digits(const Comparison& comparison, int digits) {
  const auto have_all = [digits](const std::vector<NamedEstimate>& values) {
    return std::all_of(values.begin(), values.end(), [digits](const NamedEstimate& value) {
      return sure_digits(value) >= digits;
    });
  };
  return comparison.is_course_sure() && have_all(comparison.summary) &&
         std::all_of(comparison.events.begin(), comparison.events.end(),
                     [&](const EventEstimate& event) { return have_all(event.values); });
}

}  // namespace rotor
