/// A point of a sweep as a row of its results.
#pragma once

#include "figures/data/csv.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/part.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// All columns of results: what a summary has of a run in plain values and lists.
const std::vector<std::string>& result_columns();
/// All columns that can be selected: also the closed forms for a point.
const std::vector<std::string>& columns_on_request();

/// The place of a column of results in a row of the sweep, if it has that column.
std::optional<std::size_t> place_of(std::string_view column, const Sweep& sweep);

/// The column of a quantity that varies, which may be called like a result, such as method.
std::string column_of(const std::string& quantity);

/// The header above the rows of a part: provenance, and the names of the columns.
std::string sweep_head(const Sweep& sweep, const Part& part = {});

/// The sweep of which this is the head, which messages refer to by `name`, whatever the version.
/// Throws InputError if it is that of a part, or not the head that the sweep would have.
Sweep sweep_of(std::string_view head, const std::string& name);

/// Computes the rows of points, in any order. The points share their run-ups.
class SweepRows {
 public:
  explicit SweepRows(const Sweep& sweep) : sweep_(sweep), points_(sweep) {}

  /// The values that vary, what the whole run gives in each column, and why the run was refused;
  /// without a line end. Throws Interrupted.
  std::string operator()(long n);

 private:
  const Sweep& sweep_;
  SweepPoints points_;
  RunUps run_ups_;
};

}  // namespace rotor
