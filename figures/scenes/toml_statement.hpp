/// What a table of a TOML file states of a scenario.
#pragma once

#include "figures/scenes/statement.hpp"
#include "figures/scenes/toml_file.hpp"

namespace rotor {

/// The table may have other keys beside. Throws InputError, naming file, line and key.
Statement stated_in(const TomlFile& file, const toml::table& table, TomlFile::Keys other_keys);

}  // namespace rotor
