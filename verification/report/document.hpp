/// The contents of the reviewer's page as one JSON document: the page shows nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "figures/results/json.hpp"
#include "verification/paper/claims.hpp"
#include "verification/support/content.hpp"

namespace rotor {

/// Its sources.
struct Sources {
  std::filesystem::path texts{};           ///< words, with places for numbers: texts.json
  std::filesystem::path scenes{};          ///< figNN.toml
  std::filesystem::path reference_data{};  ///< claims, ensembles, assumptions
  std::filesystem::path pictures{};        ///< figNN.svg
};

Json document(const Sources& sources);

// Its parts.
Json claims_json(const std::vector<Number>& numbers);  ///< by passages of the paper
/// The tally in each set of equations, and how many claims each other rule turns.
Json tally_json(const std::vector<Number>& numbers);
/// The tally of the claims that a figure shows, in each set of equations, and these claims.
Json tally_of_figure(int figure, const std::vector<Number>& numbers);
/// Causes, by their names, with the claims that are refuted as printed: an error in the equations,
/// a number or a word.
Json causes_json(const std::vector<Number>& numbers, const Json& causes);
/// Rows of tables in Markdown: of all numbers, and of those that are refuted.
std::string claim_rows(const std::vector<Number>& numbers);
std::string refuted_rows(const std::vector<Number>& numbers);
Json values_json(const std::vector<Number>& numbers);
Json figures_json(const Sources& sources, const std::vector<Number>& numbers);
/// A picture from gnuplot as part of a page: as wide as possible, with unique names.
std::string inline_svg(std::string svg, const std::string& name);

/// Stills of the accident, and the recorded runs and maps of the interactive part.
Json accident_json();
Json instrument_json(const std::filesystem::path& report);

/// The rows of a table by the texts of some columns, with "_" for a point and none for an empty
/// text: laws.published.rolling_speed.0_03. `agree`, a share of `runs`, is in percent with its
/// standard error.
Json rows_by(const std::filesystem::path& csv, const std::vector<const char*>& keys);

/// Words and colours: script/words.js, and properties before page.css.
std::string words_of_page();
std::string tints_of_page();

/// A JSON file. Throws std::runtime_error, naming it, if it is not valid JSON.
Json read_json(const std::filesystem::path& file);

}  // namespace rotor
