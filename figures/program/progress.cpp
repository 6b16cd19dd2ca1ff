#include "figures/program/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace rotor {
namespace {

constexpr double first_report_s = 3, patience_elsewhere = 4;

/// As one would say it.
std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 172'800) return fmt::format("{:.0f} h", seconds / 3600);
  return fmt::format("{:.3g} days", seconds / 86'400);
}

}  // namespace

RunProgress::RunProgress(double until_s)
    : until_s_(until_s), next_s_(first_report_s), on_terminal_(::isatty(STDERR_FILENO) != 0) {}

RunProgress::~RunProgress() {
  if (has_reported_ && on_terminal_) fmt::print(stderr, "\n");
}

bool RunProgress::goes_on(const Progress& now) {
  constexpr long seldom = 256;  // a clock takes as long as a small part of a step
  if (++steps_ % seldom == 0) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (elapsed.count() > next_s_) report(now.time_s, elapsed.count());
  }
  return Interruptible::goes_on(now);
}

void RunProgress::report(double time_s, double elapsed_s) {
  has_reported_ = true;
  next_s_ = on_terminal_ ? elapsed_s + 1 : patience_elsewhere * elapsed_s;
  fmt::print(stderr, "{}at {:.6g} s of {:.6g} s after {} steps in {}; about {} to go{}",
             on_terminal_ ? "\r" : "rotor: ", time_s, until_s_, steps_, duration(elapsed_s),
             duration(elapsed_s * (until_s_ - time_s) / time_s),
             on_terminal_ ? " (Ctrl-C stops)  " : "\n");
}

}  // namespace rotor
