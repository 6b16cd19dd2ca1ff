/// Counts the sines and cosines in a program that is linked with the target `sines`, which puts
/// itself between the program and the mathematical library.
#pragma once

namespace rotor {

/// Pairs of sine and cosine in double precision since the program began, however the compiler calls
/// them.
long sine_cosine_pairs();

}  // namespace rotor
