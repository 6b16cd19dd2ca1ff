#include "figures/explore/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "figures/data/text.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

std::vector<std::string> option_names() {
  std::vector<std::string> names = {"--no-separation", "--from"};
  for (const Statable& statable : statables()) names.push_back(option_of(statable.quantity.name));
  for (const std::string_view name : named_statables()) names.push_back(option_of(name));
  return names;
}

void set(Settings& settings, const std::string& option, const std::string& text) {
  const auto is_called = [&](std::string_view name) { return option == option_of(name); };
  if (option == "--no-separation") {
    settings.statement.loses_mass = false;
    return;
  }
  if (option == "--from") {
    settings.from_s = number_in(text);
    if (!settings.from_s) throw InputError(fmt::format("{}: {}", option, unless_number(text)));
    return;
  }
  for (const Statable& statable : statables())
    if (is_called(statable.quantity.name))
      return state_number(settings.statement, statable.quantity, text);
  for (const std::string_view name : named_statables())
    if (is_called(name)) try {
        return state(settings.statement, name, text);
      } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
      }
  throw InputError(fmt::format("{}: there is no such option of run{}", shown(option),
                               suggestion(option, option_names())));
}

/// The quantity of a printed input. Of those that differ from scene to scene there are several.
std::string_view quantity_of(std::string_view input) {
  if (input.starts_with("mu_")) return "friction";
  if (input.starts_with("t_")) return "separation_time";
  return input;
}

/// What a statable determines: itself, or what it stands for.
std::string_view determined_by(const Statable& statable) {
  return statable.instead_of.empty() ? statable.quantity.name : statable.instead_of;
}

/// Whether the printed value is the one in effect; of what follows from other numbers, whether it
/// is within the printed digits.
bool is_in_effect(std::string_view quantity, const CsvRow& row, const Statement& statement,
                  const Scenario& scenario) {
  const Statable& drawn = *find_statable(quantity);
  const auto printed = static_cast<double>(row.number("printed"));
  if (determined_by(drawn) == "separation_time" && !statement.loses_mass.value_or(true))
    return false;
  for (const auto& [name, value] : statement.numbers)
    if (determined_by(*find_statable(name)) == determined_by(drawn))
      return name == quantity && value == printed;
  if (drawn.quantity.in) return drawn.quantity.of(scenario) == printed;
  const Parameters& p = scenario.parameters;
  const double value =
      quantity == "clearance" ? p.stator_radius - p.rotor_radius : MassLoss<double>(p).lost_mass;
  return row.number("least") <= value && value <= row.number("greatest");
}

}  // namespace

Settings settings_of(const Options& options) {
  Settings settings;
  for (const auto& [option, text] : options) set(settings, "--" + option, text);
  return settings;
}

Sweep over_printed_digits(const Statement& statement, const std::vector<CsvRow>& printed_inputs,
                          long count) {
  Sweep sweep{.title = {}, .text = {}, .base = statement, .axes = {}, .sample = {}};
  sweep.sample.count = count;
  sweep.sample.seed = 1;
  const Scenario scenario = scenario_of(statement);
  for (const CsvRow& row : printed_inputs) {
    const std::string_view quantity = quantity_of(row["input"]);
    if (is_in_effect(quantity, row, statement, scenario))
      sweep.sample.over.push_back({std::string(quantity), Distribution::uniform,
                                   static_cast<double>(row.number("least")),
                                   static_cast<double>(row.number("greatest"))});
  }
  return sweep;
}

}  // namespace rotor
