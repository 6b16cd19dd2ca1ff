#include "verification/report/engine/settings.hpp"

#include <fmt/format.h>

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

}  // namespace

Settings settings_of(const Options& options) {
  Settings settings;
  for (const auto& [option, text] : options) set(settings, "--" + option, text);
  return settings;
}

}  // namespace rotor
