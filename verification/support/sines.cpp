#include "verification/support/sines.hpp"

#include <algorithm>

namespace {
long sines = 0, cosines = 0, both = 0;
}

// The linker's --wrap sends calls of sin to __wrap_sin, and those of __real_sin to sin.
extern "C" {
double __real_sin(double angle);
double __real_cos(double angle);
void __real_sincos(double angle, double* sine, double* cosine);

double __wrap_sin(double angle) {
  ++sines;
  return __real_sin(angle);
}
double __wrap_cos(double angle) {
  ++cosines;
  return __real_cos(angle);
}
void __wrap_sincos(double angle, double* sine, double* cosine) {
  ++both;
  __real_sincos(angle, sine, cosine);
}
}

long rotor::sine_cosine_pairs() { return both + std::max(sines, cosines); }
