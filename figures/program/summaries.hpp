/// Summaries of runs, as they are printed.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "figures/input/scene.hpp"

namespace rotor {

/// Each name and value on its own line, or as JSON.
void print_summary(const nlohmann::ordered_json& run, bool as_json, std::FILE* to);

/// Several runs: one row each with the most important values, or all values as JSON.
void print_summaries(const nlohmann::ordered_json& runs, bool as_json, std::FILE* to);

/// Says on standard error which equations were used if none were stated.
void say_which_equations(bool left_open);
void say_which_equations(const std::vector<SceneRun>& runs);

}  // namespace rotor
