/// Progress of long work, which can be interrupted.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "figures/runs/interruptible.hpp"

namespace rotor {

/// Reports progress on standard error: first after a few seconds, then every second in one line of
/// a terminal, and rarely elsewhere.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();  ///< ends the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Shows a text when one is due; only then is it computed, from the seconds since the start.
  void update(const std::function<std::string(double elapsed_s)>& text);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double next_s_;  ///< next time a text is due, since the start
  bool on_terminal_, is_shown_ = false;
};

/// Interruptible, with the progress of one run.
class RunProgress : public Interruptible {
 public:
  explicit RunProgress(double until_s) : until_s_(until_s) {}

  bool goes_on(const Progress& now) override;

 private:
  ProgressLine line_;
  double until_s_;
  long steps_ = 0;
};

/// Progress of the successive computations of a run with guaranteed digits.
class DigitsProgress {
 public:
  DigitsProgress(int digits, double until_s) : digits_(digits), until_s_(until_s) {}

  /// To be called after each step.
  void update(double time_s);

 private:
  ProgressLine line_;
  int digits_;
  double until_s_, last_s_ = 0;
  int computation_ = 1;
};

/// Progress of a sweep.
class SweepProgress {
 public:
  SweepProgress(long done, long all) : begun_with_(done), all_(all) {}

  /// To be called from time to time.
  void update(long done);

 private:
  ProgressLine line_;
  long begun_with_, all_;
};

}  // namespace rotor
