#include "verification/support/certain_digits.hpp"

#include <fmt/format.h>

#include <cmath>

#include "figures/data/csv.hpp"
#include "figures/input/scenario_spec.hpp"
#include "figures/results/certified_result.hpp"
#include "model/certified/computation.hpp"

namespace rotor {

std::vector<KnownRun> known_runs(const std::filesystem::path& file) {
  std::vector<KnownRun> runs;
  for (const CsvRow& row : read_csv(file)) {
    ScenarioSpec spec;
    KnownValues values;
    for (const std::string& name : row.headings())
      if (const NamedInput* const input = find_named_input(name))
        input->state(spec, row[name]);
      else if (find_input_quantity(name))
        spec.numbers[name] = std::stod(row[name]);
      else
        values[name] = row[name].empty() ? std::nullopt : std::optional(std::stod(row[name]));
    runs.push_back({stated_scenario(spec), values});
  }
  return runs;
}

std::string falsehood(const Comparison& found, int digits, const KnownValues& known,
                      double& worst) {
  std::string text;
  const bool has_all = has_digits(found, digits), is_course_sure = found.is_course_sure();
  const auto is_count = [&](const char* name, double value) {
    if (is_course_sure && known.at(name) != value) text += fmt::format("{}; ", name);
  };
  is_count("touch_downs", static_cast<double>(found.values.touch_downs));
  is_count("outcome", static_cast<double>(found.values.outcome));
  is_count("events", static_cast<double>(found.events.size() - 1));
  for_each_named(found, [&](const std::string& name, const NamedEstimate& value) {
    const auto exact = known.find(name);
    if (exact == known.end()) return;
    if (!exact->second || !value.estimate) {
      if (is_course_sure && value.estimate.has_value() != exact->second.has_value())
        text += name + " exists or not; ";
      return;
    }
    const auto& [number, error] = *value.estimate;
    if (std::isinf(error)) return;
    const double truth = *exact->second, doubt = 2.3e-16 * std::abs(truth);  // of a double
    const double off = std::max(0., std::abs(number - truth) - doubt);
    if (error > 0) worst = std::max(worst, off / error);
    if (off > error) text += fmt::format("{} is {:.2e} off, not {:.2e}; ", name, off, error);
    if (has_all && off > 0.5 * std::pow(10, -digits) * value.size)
      text += name + " has not the digits; ";
    const std::string printed = certified_text(number, error, digits);
    if (error == 0 || printed == "?") return;
    bool is_true = false;
    for (int n = digits; n > 0; --n)
      for (const double sign : {-1, 1})
        is_true = is_true || rounded_to(truth + sign * doubt, n) == printed;
    if (!is_true) text += fmt::format("{} is printed as {}; ", name, printed);
  });
  return text;
}

double true_error(const Summary& summary, const Parameters& p, const KnownValues& known) {
  double largest = 0;
  for (const NamedValue<double>& value : values_of(summary, p)) {
    const auto exact = known.find(std::string(value.name));
    if (exact == known.end()) continue;
    if (value.value.has_value() != exact->second.has_value()) return 1;
    if (value.value && value.value != exact->second)
      largest = std::max(largest, std::abs(*value.value - *exact->second) /
                                      std::max(std::abs(*exact->second), value.size));
  }
  return std::min(1., largest);
}

}  // namespace rotor
