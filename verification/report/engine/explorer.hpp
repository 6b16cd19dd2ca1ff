/// Runs for interactive use: fast, and repeated with changed settings.
#pragma once

#include "figures/data/csv.hpp"
#include "figures/results/json.hpp"
#include "figures/runs/run_ups.hpp"
#include "verification/report/engine/settings.hpp"

namespace rotor {

/// A run, ready to be drawn.
struct Picture {
  /// "summary" as `rotor run --energy --json` prints it, the "events", the columns of the tables,
  /// the start of the trace and the time of the mass loss.
  Json metadata;
  Table motion;  ///< rows of the requested columns
  Table works;   ///< time, and the works of EnergyBalance up to then, J
};

/// Keeps the run-ups of the last settings, so that knobs that act later need no new run-up.
class Explorer {
 public:
  /// Largest distance of its curves from the motion, relative to their range: half a pixel. Calls
  /// the monitor after each step. Throws std::exception with the messages of the command line.
  Picture run(const Options& options, Observer& monitor, double closeness = 1e-3);

  /// The inputs: name, symbol, unit, meaning, and the paper's value, if there is one.
  static Json describe_numbers();

 private:
  RunUps run_ups_;
};

}  // namespace rotor
