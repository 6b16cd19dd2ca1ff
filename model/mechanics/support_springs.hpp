/// The springs of the supports, which pull O towards O_a: the one place that knows their force law.
/// Source: "Overcritical high-speed rotor systems, full annular rub and accident",
/// Sec. 2.1, Eq. (4).
#pragma once

#include <array>
#include <stdexcept>
#include <string>

#include "model/mechanics/parameters.hpp"
#include "model/mechanics/plane.hpp"

namespace rotor {

template <class S>
class SupportSprings {
 public:
  explicit SupportSprings(const Parameters& p) : stiffness_(stated<S>(p.support_stiffness)) {}

  /// What loads them at a distance of O from O_a, N.
  S force(const S& distance) const { return stiffness_ * distance; }
  /// The same at a displacement of O, in its direction.
  Vector<S> force(const Vector<S>& displacement) const { return stiffness_ * displacement; }
  /// Its rate, N/s.
  Vector<S> force_rate(const Vector<S>& /*displacement*/, const Vector<S>& velocity) const {
    return stiffness_ * velocity;
  }
  /// What they store, J.
  S energy(const Vector<S>& displacement) const {
    return stiffness_ * displacement.squaredNorm() / 2;
  }
  /// The force's slope over the distance, N/m; up to a distance none is larger than there.
  S tangent_stiffness(const S& /*distance*/) const { return stiffness_; }

  /// Whether the force is proportional to the displacement.
  bool is_linear() const { return true; }
  /// k, N/m, for a formula that holds for linear springs alone. Throws std::domain_error, naming
  /// the formula, for others.
  const S& linear_stiffness(const char* formula) const {
    if (!is_linear())
      throw std::domain_error(std::string(formula) + ": holds for linear springs alone");
    return stiffness_;
  }

  /// All numbers of the law, which are disturbed to see what their rounding does.
  std::array<S*, 1> numbers() { return {&stiffness_}; }

 private:
  S stiffness_;  ///< k, N/m
};

}  // namespace rotor
