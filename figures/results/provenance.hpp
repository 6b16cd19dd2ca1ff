/// The header of data files.
#pragma once

#include <string>
#include <vector>

#include "figures/input/scene.hpp"

namespace rotor {

/// Lines for the top of a CSV file: its contents, and everything it was computed from.
std::vector<std::string> provenance(const std::string& title, const Scene& scene);

/// The headings of a CSV file; the first is for the tables' names.
std::vector<std::string_view> headings(std::string_view names,
                                       const std::vector<const Column*>& columns);

}  // namespace rotor
