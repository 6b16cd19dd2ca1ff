/// A point of a sweep as a row of its results.
#pragma once

#include "figures/results/run_result.hpp"
#include "figures/runs/run_ups.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// The columns that results have: the plain keys of a summary.
const std::vector<std::string>& result_columns();
/// The columns that can be asked for: what the laws say of a point, too.
const std::vector<std::string>& columns_on_request();

/// The header above the rows: where they come from, and the names of their columns.
std::string sweep_head(const Sweep& sweep);

/// Works out the rows of points, in any order. Run-ups are shared between them.
class SweepRows {
 public:
  explicit SweepRows(const Sweep& sweep) : sweep_(sweep), points_(sweep) {}

  /// What varies, what `rotor run` says of the run, which limits it exceeds, and why the run is
  /// refused. Throws Interrupted.
  std::string operator()(long n);

 private:
  const Sweep& sweep_;
  SweepPoints points_;
  RunUps run_ups_;
};

}  // namespace rotor
