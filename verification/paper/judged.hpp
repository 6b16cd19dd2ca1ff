/// The judged numbers of reference-data/, for tests, which judge them once.
#pragma once

#include "verification/paper/claims.hpp"

namespace rotor {

inline const std::vector<Number>& judged() {
  static const auto all = judged_numbers(ROTOR_REFERENCE_DATA);
  return all;
}

}  // namespace rotor
