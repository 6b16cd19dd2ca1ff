/// Runs for interactive use: fast, and repeated with changed settings.
#pragma once

#include <string>
#include <vector>

#include "figures/record/columns.hpp"
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

/// Keeps the run-ups of the last settings, so that knobs that act later need no new run-up. All
/// functions throw std::exception with the messages of the command line, and call the monitor after
/// each step.
class Explorer {
 public:
  explicit Explorer(std::vector<CsvRow> printed_inputs)
      : printed_inputs_(std::move(printed_inputs)) {}

  /// Largest distance of its curves from the motion, relative to their range: half a pixel.
  Picture run(const Options& options, Observer& monitor, double closeness = 1e-3);

  /// One of `count` draws over the rounding of the inputs: its outcome and its curves over time.
  Picture draw(const Options& options, long n, long count, Observer& monitor);

  /// What `rotor run --trace` writes.
  std::string trace(const Options& options, Observer& monitor);

  /// The inputs: name, symbol, unit, meaning, and the paper's value, if there is one.
  Json describe_numbers() const;

 private:
  /// What a picture shows, and how accurately.
  struct Shot {
    Scenario scenario;
    double from_s, closeness;
    const std::vector<const Column*>& columns;
  };
  Picture picture(const Shot& shot, Observer& monitor);

  std::vector<CsvRow> printed_inputs_;
  RunUps run_ups_;
};

}  // namespace rotor
