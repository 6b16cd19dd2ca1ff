/// Long work: says how far it is, and can be interrupted.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "figures/runs/interruptible.hpp"

namespace rotor {

/// When long work says how far it is: after a few seconds, then again and again in one line of a
/// terminal, and seldom elsewhere.
class ReportTimes {
 public:
  ReportTimes();
  ~ReportTimes();  ///< ends the line
  ReportTimes(const ReportTimes&) = delete;
  ReportTimes& operator=(const ReportTimes&) = delete;

  std::optional<double> due();  ///< seconds since the start, if it is time to report
  void print(const std::string& report);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double next_s_;  ///< when to report, since the start
  bool on_terminal_, has_reported_ = false;
};

/// Interruptible, for one run. Says on standard error how far the run is and how long the rest
/// will take if it goes on like this.
class RunProgress : public Interruptible {
 public:
  explicit RunProgress(double until_s) : until_s_(until_s) {}

  bool goes_on(const Progress& now) override;

 private:
  ReportTimes times_;
  double until_s_;
  long steps_ = 0;
};

/// The same for the computations of a run to a number of digits, one after the other.
class DigitsProgress {
 public:
  DigitsProgress(int digits, double until_s) : digits_(digits), until_s_(until_s) {}

  /// To be called after each step.
  void report(double time_s);

 private:
  ReportTimes times_;
  int digits_;
  double until_s_, last_s_ = 0;
  int computation_ = 1;
};

/// The same for a sweep.
class SweepProgress {
 public:
  SweepProgress(long done, long all) : begun_with_(done), done_(done), all_(all) {}

  /// To be called from time to time.
  void report(long done);

 private:
  ReportTimes times_;
  long begun_with_, done_, all_;
};

}  // namespace rotor
