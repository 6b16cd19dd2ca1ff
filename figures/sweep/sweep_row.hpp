/// A point of a sweep as a row of its results.
#pragma once

#include "figures/data/csv.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// The default columns of results: the plain keys of a summary.
const std::vector<std::string>& result_columns();
/// Those of this sweep.
const std::vector<std::string>& result_columns(const Sweep& sweep);
/// All columns that can be selected: also the closed forms for a point.
const std::vector<std::string>& columns_on_request();

/// The column of a quantity that varies, which may be called like a result, such as method.
std::string column_of(const std::string& quantity);

/// The header above the rows: provenance, and the names of the columns.
std::string sweep_head(const Sweep& sweep);

/// Computes the rows of points, in any order. The points share their run-ups.
class SweepRows {
 public:
  explicit SweepRows(const Sweep& sweep) : sweep_(sweep), points_(sweep) {}

  /// The values that vary, the summary of the run, the limits that it exceeds, and why the run was
  /// refused. Throws Interrupted.
  std::string operator()(long n);

  /// Whether a line can be the row of a point: it begins with its values.
  bool is_row_of(long n, std::string_view row) const;

 private:
  const Sweep& sweep_;
  SweepPoints points_;
  RunUps run_ups_;
};

}  // namespace rotor
