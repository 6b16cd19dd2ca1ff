/// Interruptions such as Ctrl-C: long work checks for them from time to time, and cleans up.
#pragma once

#include <stdexcept>

namespace rotor {

/// From now on SIGINT, SIGTERM and SIGHUP are only noted and do not end the program.
void note_interruptions();

/// Whether one has been noted.
bool is_interrupted();

/// The signal that was noted, or 0.
int interrupting_signal();

struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
  Interrupted() : std::runtime_error("interrupted; no file has been written") {}
};

}  // namespace rotor
