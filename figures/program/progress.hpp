/// Long work: says how far it is, and can be interrupted.
#pragma once

#include <chrono>

#include "figures/scenes/interruptible.hpp"

namespace rotor {

/// Interruptible, for one run. After a few seconds it says on standard error how far the run is and
/// how long the rest will take if it goes on like this: again and again in one line of a terminal,
/// and seldom elsewhere.
class RunProgress : public Interruptible {
 public:
  explicit RunProgress(double until_s);
  ~RunProgress() override;
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;

  bool goes_on(const Progress& now) override;

 private:
  void report(double time_s, double elapsed_s);

  double until_s_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double next_s_;  ///< when to report, since the start
  long steps_ = 0;
  bool on_terminal_, has_reported_ = false;
};

}  // namespace rotor
