/// Summaries of runs, as they are printed.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>

namespace rotor {

/// Of one run, each name and value in a line of their own; of several, the most important ones in a
/// row for each. As JSON, all of them.
void print_summaries(const nlohmann::ordered_json& runs, bool as_json, std::FILE* to);

}  // namespace rotor
