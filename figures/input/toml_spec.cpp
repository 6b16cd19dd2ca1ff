#include "figures/input/toml_spec.hpp"

#include <fmt/format.h>

namespace rotor {

ScenarioSpec stated_in(const TomlFile& file, const toml::table& table, TomlFile::Keys other_keys) {
  TomlFile::Keys allowed = std::move(other_keys);
  for (const InputQuantity& s : input_quantities()) allowed.push_back(s.quantity.name);
  const auto named = named_inputs();
  allowed.push_back("no_mass_loss");
  allowed.push_back("digits");
  allowed.insert(allowed.end(), named.begin(), named.end());
  file.expect_keys(table, allowed);

  ScenarioSpec stated;
  for (const auto& [quantity, instead_of] : input_quantities())
    if (const auto number = file.value<double>(table, quantity.name, quantity.range())) {
      if (!quantity.allows(*number))
        file.fail(*table.get(quantity.name), quantity.name,
                  fmt::format("must be {}, not {}", quantity.range(), *number));
      stated.numbers.emplace(quantity.name, *number);
    }
  if (const auto none = file.value<bool>(table, "no_mass_loss", "true or false"))
    stated.loses_mass = !*none;
  if (const auto digits = file.value<double>(table, "digits", "a number"))
    stated.digits = file.at(*table.get("digits"), "digits", [&] { return parse_digits(*digits); });
  for (const std::string_view key : named)
    if (const auto name = file.text(table, key))
      file.at(*table.get(key), key, [&] { state(stated, key, *name); });
  return stated;
}

}  // namespace rotor
