/// Interruptions such as Ctrl-C: long work asks for them from time to time, and cleans up.
#pragma once

#include <stdexcept>

namespace rotor {

/// From now on SIGINT, SIGTERM and SIGHUP are noted instead of ending the program.
void note_interruptions();

/// Whether there has been one.
bool is_interrupted();

/// Which signal has been noted, or 0.
int interrupting_signal();

struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
  Interrupted() : std::runtime_error("interrupted; no file has been written") {}
};

}  // namespace rotor
