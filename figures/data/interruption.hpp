/// Interruptions such as Ctrl-C: long work checks for them from time to time, and cleans up.
#pragma once

#include <stdexcept>

namespace rotor {

/// From now on the signals that ask a program to end are only noted: SIGINT, SIGTERM, SIGHUP,
/// SIGQUIT, and SIGXCPU of `ulimit -t`.
void note_interruptions();

/// Whether one has been noted.
bool is_interrupted();

/// The signal that was noted, or 0.
int interrupting_signal();

struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
  Interrupted() : std::runtime_error("interrupted; no file has been written") {}
};

/// Nobody reads standard output any more: there is nothing left to do or to say.
struct ReaderGone : Interrupted {};

}  // namespace rotor
