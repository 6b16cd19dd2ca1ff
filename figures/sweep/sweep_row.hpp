/// A point of a sweep as a row of its results.
#pragma once

#include "figures/data/csv.hpp"
#include "figures/results/run_result.hpp"
#include "figures/sweep/results_file.hpp"
#include "figures/sweep/sweep.hpp"

namespace rotor {

/// All columns of results: what a summary has of a run in plain values and lists, and of a section.
std::vector<std::string> result_columns(bool with_section = false);
/// All columns that can be selected: also the closed forms for a point.
std::vector<std::string> columns_on_request(bool with_section = false);

/// The place of a column of results in a row of the sweep, if it has that column.
std::optional<std::size_t> place_of(std::string_view column, const Sweep& sweep);

/// The column of a quantity that varies, which may be called like a result, such as method.
std::string column_of(const std::string& quantity);

/// The heads of a part's files: provenance, and the names of the columns.
ResultHeads heads_of(const Sweep& sweep, const Part& part = {});

/// The sweep of which this is the head, which messages refer to by `name`, whatever the version.
/// Throws InputError if it is that of a part, or not the head that the sweep would have.
Sweep sweep_of(std::string_view head, const std::string& name);

/// Computes the lines of points, in any order. The points share their run-ups.
class SweepRows {
 public:
  explicit SweepRows(const Sweep& sweep) : sweep_(sweep), points_(sweep) {}

  /// The values that vary, what the whole run gives in each column, and why the run was refused;
  /// then the rows of its section: the number of the point, the values that vary, and what
  /// Section::columns() has. Throws Interrupted.
  std::string operator()(long n);

 private:
  std::string results(const SweepPoint& point, const std::string& start, std::string& section);

  const Sweep& sweep_;
  SweepPoints points_;
  RunUps run_ups_;
};

}  // namespace rotor
