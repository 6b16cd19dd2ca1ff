/// The curves of scenes, and the results of their runs.
#pragma once

#include <map>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/runs/scene.hpp"
#include "model/results/summary.hpp"

namespace rotor {

/// What the runs of a scene give.
struct SceneData {
  std::vector<NamedTable> curves;
  std::vector<Summary> results;
};

/// By the scenes' numbers: runs what the scenes need, and thins the curves.
/// Throws Interrupted when it is interrupted, and InputError if no part of a run lies in a window
/// or digits are requested.
std::map<int, SceneData> compute_data(const std::map<int, Scene>& scenes);

}  // namespace rotor
