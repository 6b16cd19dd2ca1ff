/// The closed forms of model/theory/accident.hpp for a scenario.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "figures/results/json.hpp"
#include "model/scenario/scenario.hpp"
#include "model/theory/accident.hpp"

namespace rotor {

struct AccidentAtSpeed {
  double speed;  ///< at the mass loss, rad/s
  Accident law;
};

inline constexpr std::string_view no_value = "no value";

/// A closed form: its key with the unit, its label in short summaries, its meaning, and the
/// assumption under which it holds.
struct Law {
  std::string_view key, label, meaning, assumption;
  Json (*of)(const AccidentAtSpeed& accident);
  std::string_view none = no_value;  ///< what null means
};
const std::vector<Law>& all_laws();

/// Of all of them; two lines.
inline constexpr std::string_view assumption_of_laws =
    "All assume that the rotor loses the piece in its steady response, and has not\n"
    "touched the ring before.\n";

/// By their keys. Throws InputError for a run without mass loss, and std::domain_error for supports
/// that do not vibrate and a ring that is not linear or not centred.
Json laws(const Scenario& scenario);

/// `laws()`, all null where they do not apply.
Json laws_or_nulls(const Scenario& scenario);

/// The keys and their meanings, a line each, and what all assume.
std::string meanings_of_laws();

}  // namespace rotor
