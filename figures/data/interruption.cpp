#include "figures/data/interruption.hpp"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <initializer_list>

namespace rotor {
namespace {

std::atomic<int> noted{0};
std::atomic<std::int64_t> noted_ms{0};
static_assert(std::atomic<int>::is_always_lock_free);
static_assert(std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

/// A second signal ends the program at once, unless it is the first one's echo: some programs send
/// theirs to a process and then to its whole group. It may interrupt the first one's handling, or
/// be handled by another thread at the same time.
void note(int signal) {
  constexpr std::int64_t echo_ms = 200;
  const std::int64_t now = now_ms();
  std::int64_t first = 0;
  if (noted_ms.compare_exchange_strong(first, now)) {
    noted = signal;
  } else if (now - first > echo_ms) {
    static_cast<void>(::signal(signal, SIG_DFL));
    static_cast<void>(::raise(signal));
  }
}

}  // namespace

void note_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (signal == SIGHUP && action.sa_handler == SIG_IGN) continue;  // nohup wants it to live on
    action.sa_handler = note;
    action.sa_flags = 0;  // calls that block return
    ::sigaction(signal, &action, nullptr);
  }
}

bool is_interrupted() { return noted != 0; }
int interrupting_signal() { return noted; }

}  // namespace rotor
