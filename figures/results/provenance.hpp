/// The header of data files.
#pragma once

#include <string>
#include <string_view>

#include "figures/runs/scene.hpp"

namespace rotor {

/// The head of a CSV file: its contents, everything it was computed from, and its headings; the
/// first heading is for the tables' names.
std::string csv_head(const std::string& title, const Scene& scene, std::string_view names);

}  // namespace rotor
