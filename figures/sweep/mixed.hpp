/// Pseudo-random bits without a state.
#pragma once

#include <cstdint>

namespace rotor {

/// 64 pseudo-random bits from a counter (SplitMix64; Steele, Lea and Flood 2014).
inline std::uint64_t mixed(std::uint64_t counter) {
  counter = (counter + 1) * 0x9e3779b97f4a7c15U;
  counter = (counter ^ (counter >> 30U)) * 0xbf58476d1ce4e5b9U;
  counter = (counter ^ (counter >> 27U)) * 0x94d049bb133111ebU;
  return counter ^ (counter >> 31U);
}

}  // namespace rotor
