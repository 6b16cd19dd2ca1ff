/// Runs for somebody who turns knobs and watches: fast, again and again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "figures/data/csv.hpp"
#include "figures/data/table.hpp"
#include "figures/explore/settings.hpp"
#include "figures/record/columns.hpp"
#include "figures/runs/run_ups.hpp"

namespace rotor {

/// A run, ready to be drawn.
struct Picture {
  /// "summary" as `rotor run --energy --json` prints it, the "events", the columns of the tables,
  /// and where the trace begins and the mass is lost.
  nlohmann::ordered_json metadata;
  Table motion;  ///< rows of the columns that are asked for
  Table works;   ///< time, and the works of EnergyBalance until then, J
};

/// Keeps the run-ups of the last settings: a knob that matters later than these does not wait for
/// them. All throw std::exception in the words of the command line, and ask the monitor after each
/// step.
class Explorer {
 public:
  explicit Explorer(std::vector<CsvRow> printed_inputs);

  /// As close are its curves to the motion, relative to their range: half a pixel of a screen.
  Picture run(const Options& options, Observer& monitor, double closeness = 1e-3);

  /// One of `count` runs over the printed digits, for its outcome and the curves over time.
  Picture draw(const Options& options, long n, long count, Observer& monitor);

  /// What `rotor run --trace` writes.
  std::string trace(const Options& options, Observer& monitor);

  /// What can be stated: name, symbol, unit, meaning, and the paper's value of each number, if it
  /// has one.
  nlohmann::ordered_json describe_numbers() const;

 private:
  /// What a picture is taken of, and how closely.
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
