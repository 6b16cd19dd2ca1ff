/// The springs of the supports, which pull O towards O_a: the only place with their force law.
/// Source: "Overcritical high-speed rotor systems, full annular rub and accident",
/// Sec. 2.1, Eq. (4).
#pragma once

#include <stdexcept>
#include <string>

#include "model/mechanics/parameters.hpp"
#include "model/mechanics/plane.hpp"

namespace rotor {

template <class S>
class SupportSprings {
 public:
  explicit SupportSprings(const Parameters& p) : stiffness_(as_typed<S>(p.support_stiffness)) {}

  /// Force at a distance of O from O_a, N.
  S force(const S& distance) const { return stiffness_ * distance; }
  /// The same at a displacement of O, in the direction of the displacement.
  Vector<S> force(const Vector<S>& displacement) const { return stiffness_ * displacement; }
  /// Its rate, N/s.
  Vector<S> force_rate(const Vector<S>& /*displacement*/, const Vector<S>& velocity) const {
    return stiffness_ * velocity;
  }
  /// Stored energy, J.
  S energy(const Vector<S>& displacement) const {
    return stiffness_ * displacement.squaredNorm() / 2;
  }
  /// Slope of the force over the distance, N/m; it must not fall with the distance.
  S tangent_stiffness(const S& /*distance*/) const { return stiffness_; }

  /// Whether the force is proportional to the displacement.
  bool is_linear() const { return true; }
  /// k, N/m, for a formula that holds only for linear springs. Throws std::domain_error, naming the
  /// formula, for others.
  const S& linear_stiffness(const char* formula) const {
    if (!is_linear())
      throw std::domain_error(std::string(formula) + ": holds only for linear springs");
    return stiffness_;
  }

 private:
  S stiffness_;  ///< k, N/m
};

}  // namespace rotor
