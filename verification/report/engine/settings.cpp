#include "verification/report/engine/settings.hpp"

#include <fmt/format.h>

#include "figures/runs/run_ups.hpp"
#include "model/mechanics/contact.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

std::vector<std::string> option_names() {
  std::vector<std::string> names = {"--no-mass-loss", "--from"};
  for (const InputQuantity& input_quantity : input_quantities())
    names.push_back(option_of(input_quantity.quantity.name));
  for (const NamedInput& input : named_inputs()) names.push_back(option_of(input.name));
  return names;
}

void set(Settings& settings, const std::string& option, const std::string& text) {
  const auto is_called = [&](std::string_view name) { return option == option_of(name); };
  if (option == "--no-mass-loss") {
    settings.spec.loses_mass = false;
    return;
  }
  if (option == "--from") {
    settings.from_s = number_in(text);
    if (!settings.from_s) throw InputError("{}: {}", option, unless_number(text));
    return;
  }
  for (const InputQuantity& input_quantity : input_quantities())
    if (is_called(input_quantity.quantity.name))
      return state_number(settings.spec, input_quantity.quantity, text);
  for (const NamedInput& input : named_inputs())
    if (is_called(input.name)) try {
        return input.state(settings.spec, text);
      } catch (const InputError& error) {
        throw InputError("{}: {}", option, error.what());
      }
  throw InputError("{}: there is no such option of run{}", shown(option),
                   suggestion(option, option_names()));
}

/// The quantity of a printed input; several inputs have the same one in different scenes.
std::string_view quantity_of(std::string_view input) {
  if (input.starts_with("mu_")) return "friction";
  if (input.starts_with("t_")) return "mass_loss_time";
  return input;
}

/// Whether the printed value is the one in effect; for a value that follows from other numbers,
/// whether it is within the printed digits.
bool is_in_effect(std::string_view quantity, const CsvRow& row, const ScenarioSpec& spec,
                  const Scenario& scenario) {
  const InputQuantity& drawn = *find_input_quantity(quantity);
  const auto printed = static_cast<double>(row.number("printed"));
  if (determined_by(quantity) == "mass_loss_time" && !spec.loses_mass.value_or(true)) return false;
  for (const auto& [name, value] : spec.numbers)
    if (determined_by(name) == determined_by(quantity)) return name == quantity && value == printed;
  if (drawn.quantity.in) return drawn.quantity.of(scenario) == printed;
  const Parameters& p = scenario.parameters;
  const double value =
      quantity == "clearance" ? Ring<double>(p).clearance : MassLoss<double>(p).lost_mass;
  return row.number("least") <= value && value <= row.number("greatest");
}

}  // namespace

Settings settings_of(const Options& options) {
  Settings settings;
  for (const auto& [option, text] : options) set(settings, "--" + option, text);
  return settings;
}

Sweep over_printed_digits(const ScenarioSpec& spec, const std::vector<CsvRow>& printed_inputs,
                          long count) {
  Sweep sweep{.title = {}, .text = {}, .base = spec, .axes = {}, .sample = {}};
  sweep.sample.count = count;
  sweep.sample.seed = 1;
  const Scenario scenario = scenario_of(spec);
  for (const CsvRow& row : printed_inputs) {
    const std::string_view quantity = quantity_of(row["input"]);
    if (is_in_effect(quantity, row, spec, scenario))
      sweep.sample.over.push_back({std::string(quantity), Distribution::uniform,
                                   static_cast<double>(row.number("least")),
                                   static_cast<double>(row.number("greatest"))});
  }
  return sweep;
}

}  // namespace rotor
