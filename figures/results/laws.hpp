/// The closed forms of model/theory/accident.hpp for a scenario.
#pragma once

#include <string>
#include <vector>

#include "figures/results/json.hpp"
#include "figures/results/remarks.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// Keys have units; null: does not happen. Throws InputError for a run without mass loss, and
/// std::domain_error for supports that do not vibrate.
Json laws(const Scenario& scenario);

/// The same, all null where they do not apply: without a mass loss, or where supports do not
/// vibrate.
Json laws_or_nulls(const Scenario& scenario);

/// Those of remarks_on_rotor(), and why the closed forms are not trusted.
std::vector<Remark> remarks_on_laws(const Scenario& scenario);

/// The keys of laws() and their meanings, a line each.
std::string meanings_of_laws();

}  // namespace rotor
