/// The result of a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "figures/results/json.hpp"
#include "figures/results/remarks.hpp"
#include "figures/runs/run_ups.hpp"
#include "model/results/energy.hpp"
#include "model/results/stop_on.hpp"

namespace rotor {

/// Why a run ended early, if it did.
struct EarlyEnd {
  std::optional<StopOn> stop_on;  ///< as requested
  bool stop_reached = false;
  bool interrupted = false;

  /// Whether the rest of the run could change results. Where to rest is an end of its own.
  bool leaves_rest_open() const { return stop_reached && stop_on != StopOn::rest; }
};

struct RunResult {
  Scenario scenario;
  Summary summary;
  RunEnd end;
  EarlyEnd early;
  bool is_course_sure = false;  ///< by estimated digits
};

/// Continues a run from a checkpoint to its end, or to where it is to stop. `others` are shown
/// everything from the checkpoint on.
RunResult complete_run(RunUpCheckpoint run_so_far, const Scenario& scenario,
                       std::optional<StopOn> stop_on, Observer& others);
/// Finishes a run, but only until the rest of the run cannot change any value with these keys,
/// which are those of the whole run. No other value may be read.
RunResult complete_run_for(const std::vector<std::string>& keys, RunUpCheckpoint run_so_far,
                           const Scenario& scenario, Observer& others);

/// All numbers that determine a run, by their names; null for what does not apply.
Json inputs_of(const Scenario& scenario);
/// Null: has not happened. With `only`, the values with these keys.
Json to_json(const RunResult& result, const std::vector<std::string>* only = nullptr);
Json to_json(const EnergyObserver& energy);

/// The JSON schema of what `rotor run --json` prints: each key, its meaning and its values.
Json summary_schema();

/// On its circumstances, and those of remarks_on_rotor().
std::vector<Remark> remarks(const RunResult& result);

}  // namespace rotor
