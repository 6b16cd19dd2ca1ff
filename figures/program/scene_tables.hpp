/// The data of scenes, as tables in memory.
#pragma once

#include <map>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/input/scene.hpp"
#include "figures/runs/production.hpp"

namespace rotor {

struct SceneTables {
  std::map<int, std::vector<NamedTable>> of;  ///< one table per run, by the scenes' numbers
  ProductionCost cost;
};

/// Runs what the scenes need, nothing twice, and thins the curves. Throws Interrupted when it is
/// interrupted, and InputError if no part of a run lies in a window or digits are requested.
SceneTables compute_tables(const std::map<int, Scene>& scenes);

}  // namespace rotor
