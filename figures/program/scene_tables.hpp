/// The data of scenes, as tables in memory.
#pragma once

#include <map>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/input/scene.hpp"
#include "figures/runs/production.hpp"

namespace rotor {

struct SceneTables {
  std::map<int, std::vector<NamedTable>> of;  ///< a table a run, by the scenes' numbers
  ProductionCost cost;
};

/// Runs what the scenes ask for, nothing twice, and thins the curves. Throws Interrupted when it is
/// interrupted, and InputError if a window holds nothing of a run or digits are asked for.
SceneTables compute_tables(const std::map<int, Scene>& scenes);

}  // namespace rotor
