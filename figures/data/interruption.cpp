#include "figures/data/interruption.hpp"

#include <csignal>
#include <initializer_list>

namespace rotor {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) { noted = signal; }

}  // namespace

void note_interruptions() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // and calls that block return
    ::sigaction(signal, &action, nullptr);
  }
}

bool is_interrupted() { return noted != 0; }
int interrupting_signal() { return noted; }

}  // namespace rotor
