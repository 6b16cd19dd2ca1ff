#include "figures/data/interruption.hpp"

#include <atomic>
#include <csignal>
#include <initializer_list>

namespace rotor {
namespace {

std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free);

void note(int signal) { noted = signal; }

}  // namespace

void note_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    if (signal == SIGHUP && action.sa_handler == SIG_IGN) continue;  // started by nohup
    action.sa_handler = note;
    action.sa_flags = 0;  // blocking calls return
    ::sigaction(signal, &action, nullptr);
  }
}

bool is_interrupted() { return noted != 0; }
int interrupting_signal() { return noted; }

}  // namespace rotor
