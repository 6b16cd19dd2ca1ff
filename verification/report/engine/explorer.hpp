/// Runs for interactive use: fast, and repeated with changed inputs.
#pragma once

#include <map>
#include <string>

#include "figures/data/csv.hpp"
#include "figures/results/json.hpp"
#include "figures/runs/run_ups.hpp"

namespace rotor {

/// What the page states about a run: options of `rotor run` without their dashes, and their texts.
using Options = std::map<std::string, std::string>;

/// A run, ready to be drawn.
struct Picture {
  /// "summary" as `rotor run --json` prints it, the "events", the columns of "motion", the start of
  /// the trace and the time of the mass loss.
  Json metadata;
  Table motion;
};

/// Keeps the run-ups of the last inputs, so that inputs that act later need no new run-up.
class Explorer {
 public:
  /// Largest distance of its curves from the motion, relative to their range: half a pixel. Throws
  /// std::exception with the messages of the command line.
  Picture run(const Options& options, double closeness = 1e-3);

 private:
  RunUps run_ups_;
};

}  // namespace rotor
