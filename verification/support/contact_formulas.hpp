/// The contact's law written anew from its formula, for tests of the model's.
#pragma once

#include <cmath>

#include "model/mechanics/parameters.hpp"

namespace rotor {

/// F = k_t Delta_0 (Delta / Delta_0)^n, N; odd, because rounding may show a gap.
inline double spring_force_by_formula(const Parameters& p, double indentation) {
  if (p.contact_exponent == 1) return p.contact_stiffness * indentation;
  const double ratio = std::abs(indentation) / p.reference_indentation;
  return std::copysign(
      p.contact_stiffness * p.reference_indentation * std::pow(ratio, p.contact_exponent),
      indentation);
}
/// Its integral over the indentation, J.
inline double contact_energy_by_formula(const Parameters& p, double indentation) {
  return spring_force_by_formula(p, indentation) * indentation / (p.contact_exponent + 1);
}

}  // namespace rotor
