/// What a run says of itself.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "figures/runs/run_ups.hpp"
#include "model/results/energy.hpp"
#include "model/results/stop_on.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

/// Why a run has ended before its time, if it has.
struct EarlyEnd {
  std::optional<StopOn> stop_on;  ///< as asked for
  bool stop_reached = false;
  bool interrupted = false;
};

struct RunResult {
  Scenario scenario;
  Summary summary;
  RunEnd end;
  EarlyEnd early;
  std::optional<double> estimated_relative_error{};  ///< of the summary, if that was asked for
};

/// A run from where it has got to its end, or to where it is to stop. Others watch, who have seen
/// nothing yet.
RunResult finish(RunUpCheckpoint way, const Scenario& scenario, std::optional<StopOn> stop_on,
                 Observer& others);

/// What has not happened is null.
nlohmann::ordered_json to_json(const RunResult& result);
nlohmann::ordered_json to_json(const EnergyObserver& energy);

/// The JSON schema of what `rotor run --json` prints: each key, what it means, and its values.
nlohmann::ordered_json summary_schema();

/// What a reader has to know of a run beside its numbers: of its circumstances, of something stated
/// that was not reached, or of a limit of model or method that it exceeds.
struct Remark {
  std::string sentence;
  enum class Of { circumstances, missed_goal, limit } of = Of::circumstances;
};
std::vector<Remark> remarks(const RunResult& result);

}  // namespace rotor
