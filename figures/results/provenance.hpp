/// What data files were computed from, for people and for gnuplot.
#pragma once

#include <string>
#include <string_view>

#include "figures/runs/scene.hpp"
#include "model/results/summary.hpp"

namespace rotor {

/// The head of a CSV file: its contents, everything it was computed from, and its headings; the
/// first heading is for the tables' names.
std::string csv_head(const std::string& title, const Scene& scene, std::string_view names);

/// A text for gnuplot as the octal numbers of its bytes: no part of it can act as a command.
std::string gnuplot_text(std::string_view text);

/// Variables of gnuplot: `known_runs`; of each run, with its number at the end, its name, run1, and
/// all inputs, results and closed forms by their keys, mass1; NaN for what does not happen.
std::string variables(const Scene& scene, const std::vector<Summary>& results);

}  // namespace rotor
