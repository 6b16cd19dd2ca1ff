/// Progress of long work, which can be interrupted.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "figures/runs/run_ups.hpp"

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
  double next_s_ = 1.5;  ///< next time a text is due, since the start
  bool on_terminal_, is_shown_ = false;
};

/// Interruptible, with the progress of one run.
class RunProgress : public Interruptible {
 public:
  explicit RunProgress(double until_s, std::optional<StopOn> stop_on = {})
      : Interruptible(unlimited, stop_on), until_s_(until_s) {}

  bool should_continue(const Progress& now) override;

  /// How many steps the run still takes, if they are as long as the last ones: in a rub they are
  /// shorter than in the run-up.
  double steps_left() const { return steps_left_; }

 private:
  ProgressLine line_;
  double until_s_, last_s_ = 0, steps_left_ = 0;
  long steps_ = 0;
};

}  // namespace rotor
