/// The header above the data that are written.
#pragma once

#include <string>
#include <vector>

#include "figures/input/scene.hpp"

namespace rotor {

/// Lines for the top of a CSV: what it is, and all that it was computed from.
std::vector<std::string> provenance(const std::string& title, const Scene& scene);

/// The headings of a CSV, the first one being that of its tables' names.
std::vector<std::string_view> headings(std::string_view names,
                                       const std::vector<const Column*>& columns);

}  // namespace rotor
