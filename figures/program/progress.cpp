#include "figures/program/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "figures/data/text.hpp"

namespace rotor {
namespace {

constexpr double first_report_s = 3, patience_elsewhere = 4;

}  // namespace

ReportTimes::ReportTimes() : next_s_(first_report_s), on_terminal_(::isatty(STDERR_FILENO) != 0) {}

std::optional<double> ReportTimes::due() {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (elapsed.count() <= next_s_) return std::nullopt;
  next_s_ = on_terminal_ ? elapsed.count() + 1 : patience_elsewhere * elapsed.count();
  return elapsed.count();
}

void ReportTimes::print(const std::string& report) {
  has_reported_ = true;
  if (on_terminal_)
    static_cast<void>(std::fputs(fmt::format("\r{} (Ctrl-C stops)  ", report).c_str(), stderr));
  else
    tell("rotor: " + report);
}

ReportTimes::~ReportTimes() {
  if (has_reported_ && on_terminal_) tell("");
}

bool RunProgress::goes_on(const Progress& now) {
  constexpr long seldom = 256;  // a clock takes as long as a small part of a step
  if (++steps_ % seldom == 0)
    if (const auto elapsed_s = times_.due())
      times_.print(fmt::format("at {:.6g} s of {:.6g} s after {} steps in {}; about {} to go",
                               now.time_s, until_s_, steps_, duration(*elapsed_s),
                               duration(time_to_go_s(*elapsed_s, now.time_s, until_s_))));
  return Interruptible::goes_on(now);
}

void DigitsProgress::report(double time_s) {
  if (time_s < last_s_) ++computation_;
  last_s_ = time_s;
  if (const auto elapsed_s = times_.due())
    times_.print(fmt::format("computation {} for {} digits is at {:.6g} s of {:.6g} s after {}",
                             computation_, digits_, time_s, until_s_, duration(*elapsed_s)));
}

void SweepProgress::report(long done) {
  done_ = done;
  const long worked = done_ - begun_with_;
  if (worked == 0) return;
  if (const auto elapsed_s = times_.due()) {
    const auto now = static_cast<double>(worked), then = static_cast<double>(all_ - begun_with_);
    times_.print(fmt::format("{} of {} points in {}, {:.3g} a second; about {} to go", done_, all_,
                             duration(*elapsed_s), now / *elapsed_s,
                             duration(time_to_go_s(*elapsed_s, now, then))));
  }
}

}  // namespace rotor
