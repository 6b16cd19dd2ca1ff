#include "figures/program/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "figures/data/text.hpp"

namespace rotor {

ProgressLine::ProgressLine() : on_terminal_(::isatty(STDERR_FILENO) != 0) {}

void ProgressLine::update(const std::function<std::string(double elapsed_s)>& text) {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  if (elapsed.count() <= next_s_) return;
  constexpr double times_later_elsewhere = 4;
  next_s_ = on_terminal_ ? elapsed.count() + 1 : times_later_elsewhere * elapsed.count();
  is_shown_ = true;
  const std::string line = text(elapsed.count());
  if (on_terminal_)
    static_cast<void>(std::fputs(fmt::format("\r{} (Ctrl-C stops)  ", line).c_str(), stderr));
  else
    print_message("rotor: " + line);
}

ProgressLine::~ProgressLine() {
  if (is_shown_ && on_terminal_) print_message("");
}

bool RunProgress::should_continue(const Progress& now) {
  constexpr int seldom = 256;  // reading a clock is not free
  if (++steps_ % seldom == 0) {
    steps_left_ = seldom * (until_s_ - now.time_s) / (now.time_s - last_s_);
    last_s_ = now.time_s;
    line_.update([&](double elapsed_s) {
      return fmt::format("at {:.6g} s of {:.6g} s after {} steps in {}; about {} to go", now.time_s,
                         until_s_, steps_, duration(elapsed_s),
                         duration(elapsed_s * steps_left_ / static_cast<double>(steps_)));
    });
  }
  return Interruptible::should_continue(now);
}

}  // namespace rotor
