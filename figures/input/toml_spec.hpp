/// What a table of a TOML file states of a scenario.
#pragma once

#include "figures/input/scenario_spec.hpp"
#include "figures/input/toml_file.hpp"

namespace rotor {

/// The table may have other keys beside. Throws InputError, naming file, line and key.
ScenarioSpec stated_in(const TomlFile& file, const toml::table& table, TomlFile::Keys other_keys);

}  // namespace rotor
