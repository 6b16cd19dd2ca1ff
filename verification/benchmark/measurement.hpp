/// Run times and errors.
#pragma once

#include <string>
#include <vector>

#include "verification/benchmark/problem.hpp"

namespace rotor {

/// One method with one setting on one problem. NaN: failed.
struct Row {
  std::string problem, method, setting;
  double error_state{}, error_event_s{}, error_peak{}, time_s{};
  long right_hand_sides{}, steps{}, events{}, contact_evaluations{};
};

/// Collects rows, and prints each as it comes.
class Measurement {
 public:
  /// Each row is measured for this time, or fifty times.
  explicit Measurement(double seconds_per_row);

  /// A row to be measured in the next run().
  void enter(const std::string& method, const std::string& setting, const Solve& solve);

  /// Measures all entries in turns, so that a slow period of the machine affects all equally.
  void run(const Problem& problem, const Outcome& exact);

  void add(const Row& row);

  const std::vector<Row>& rows() const { return rows_; }

 private:
  struct Entry {
    std::string method, setting;
    Solve solve;
    std::vector<double> times{};
    Outcome outcome{};
    bool works = true;
  };

  static void measure(Entry& entry, const Problem& problem);
  static Row row(const Entry& entry, const Problem& problem, const Outcome& exact);

  double seconds_per_row_;
  std::vector<Entry> entries_;
  std::vector<Row> rows_;
};

}  // namespace rotor
