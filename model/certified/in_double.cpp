#include "model/certified/comparison.ipp"

namespace rotor {

template class EventMethod<double, Fehlberg78<std::array<double, 6>, double>>;
template std::optional<Comparison> compare<double>(const Scenario&, double, const ShouldContinue&);

double estimated_relative_error(const Scenario& scenario, const Summary& summary,
                                const ShouldContinue& should_continue) {
  constexpr double least = 1e-15;  // a few roundings
  const Settings<double> finer{std::max(least, scenario.tolerance / Comparison::finest), 3. / 8,
                               disturbances<double>().front()};
  const auto other = compute(scenario, finer, should_continue);
  if (other.summary.outcome != summary.outcome || other.summary.touch_downs != summary.touch_downs)
    return 1;
  const auto ours = values_of(summary, scenario.parameters),
             theirs = values_of(other.summary, scenario.parameters);
  double largest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (ours[i].follows) continue;
    const auto &value = ours[i].value, &same = theirs[i].value;
    if (value.has_value() != same.has_value()) return 1;
    if (value && *value != *same)
      largest =
          std::max(largest, std::abs(*value - *same) / std::max(std::abs(*value), ours[i].size));
  }
  return std::min(1., safety * largest);
}

}  // namespace rotor
