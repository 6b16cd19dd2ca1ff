/// Summaries of runs, as they are printed.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "figures/input/scene.hpp"

namespace rotor {

/// Each name and value in a line of their own, or as JSON.
void print_summary(const nlohmann::ordered_json& run, bool as_json, std::FILE* to);

/// Of several runs the most important values in a row for each, or all of them as JSON.
void print_summaries(const nlohmann::ordered_json& runs, bool as_json, std::FILE* to);

/// Says on standard error which equations were used where it was left open.
void say_which_equations(bool left_open);
void say_which_equations(const std::vector<SceneRun>& runs);

}  // namespace rotor
