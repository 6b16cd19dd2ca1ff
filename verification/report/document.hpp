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
  std::string commit_date{};
};

Json document(const Sources& sources);

// Its parts.
Json claims_json(const std::vector<Number>& numbers);
Json claims_of(int figure, const Json& claims);
Json turned_json(const std::vector<Number>& numbers);  ///< verdicts that other rules would turn
Json values_json(const std::vector<Number>& numbers);
Json figures_json(const Sources& sources, const Json& claims);

/// Stills of the accident, and the recorded runs and maps of the interactive part.
Json accident_json();
Json instrument_json(const std::filesystem::path& report);

/// The rows of a table by the texts of some columns, with "_" for a point and none for an empty
/// text: laws.published.rolling_speed.0_03. `agree`, a share of `runs`, is in percent with its
/// standard error.
Json rows_by(const std::filesystem::path& csv, const std::vector<const char*>& keys);

/// Words and colours: figures/paper/palette.gp, script/words.js, and properties before page.css.
std::string palette_of_gnuplot();
std::string words_of_page();
std::string tints_of_page();

/// The numbers of verdicts in each set of equations, in words and as a mark.
Json verdicts_json(const Json& claims);

/// A JSON file. Throws std::runtime_error, naming it, if it is not valid JSON.
Json read_json(const std::filesystem::path& file);

}  // namespace rotor
