/// The ring's resistance to indentation, which presses the rim back. Sources: "Overcritical
/// high-speed rotor systems, full annular rub and accident", Sec. 2.3, Eq. (21), is exponent 1;
/// exponent 1.5 is Hertz's.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "model/mechanics/parameters.hpp"

namespace rotor {

/// The paper's ring: exponent 1 and a dashpot.
template <class S>
struct LinearContact {
  S stiffness;  ///< k_t, N/m
  S damping;    ///< d_t, N s/m

  S force(const S& indentation, const S& rate) const {
    return -stiffness * indentation - damping * rate;  // Eq. (21)
  }
  S pressing(const S& indentation, const S& rate) const { return -force(indentation, rate); }
  S pressure_rate(const S& /*indentation*/, const S& rate, const S& second_rate) const {
    return stiffness * rate + damping * second_rate;
  }
  const S& tangent_stiffness(const S& /*indentation*/) const { return stiffness; }
};

template <class S>
class ContactLaw {
 public:
  explicit ContactLaw(const Parameters& p)
      : linear_{as_typed<S>(p.contact_stiffness), as_typed<S>(p.contact_damping)},
        exponent_(as_typed<S>(p.contact_exponent)),
        reference_(as_typed<S>(p.reference_indentation)) {}

  /// F_n at an indentation (m) and its rate (m/s), N: negative in compression, positive where the
  /// ring would have to pull. Odd in the indentation, so that a step may end beyond the contact.
  S force(const S& indentation, const S& rate) const {
    return is_linear() ? linear_.force(indentation, rate) : nonlinear_force(indentation, rate);
  }
  /// Rate of -F_n, N/s, from the first and second rate of the indentation.
  S pressure_rate(const S& indentation, const S& rate, const S& second_rate) const {
    if (is_linear()) return linear_.pressure_rate(indentation, rate, second_rate);
    return tangent_stiffness(indentation) * rate + damping() * second_rate;
  }

  /// Has the sign of -F_n while the ring is indented, and a simple zero where contact ends: a
  /// dashpot ends it before the ring has sprung back. Without one F_n may vanish with its slope.
  S pressing(const S& indentation, const S& rate) const {
    return has_dashpot() ? -force(indentation, rate) : indentation;
  }

  /// Elastic part of the resistance, N; its slope, N/m; the stored energy, J.
  S spring_force(const S& indentation) const { return secant_stiffness(indentation) * indentation; }
  S tangent_stiffness(const S& indentation) const {
    return is_linear() ? linear_.stiffness : exponent_ * secant_stiffness(indentation);
  }
  S energy(const S& indentation) const {
    return spring_force(indentation) * indentation / (1 + exponent_);
  }

  /// d_t, N s/m.
  const S& damping() const { return linear_.damping; }
  bool has_dashpot() const { return damping() > 0; }
  /// Whether the force is linear in the indentation and its rate, and so smooth at a touch-down.
  bool is_linear() const { return exponent_ == 1; }
  /// For the closed forms. Throws std::domain_error for a ring that is not linear.
  const LinearContact<S>& required_linear() const {
    if (!is_linear()) throw std::domain_error("the closed forms need contact_exponent = 1");
    return linear_;
  }

  /// The same where is_linear() is known.
  const LinearContact<S>& linear() const { return linear_; }

 private:
  /// Not inlined: its registers would slow down the paper's linear ring.
  [[gnu::cold, gnu::noinline]] S nonlinear_force(S indentation, S rate) const {
    return -spring_force(indentation) - damping() * rate;
  }
  S power_stiffness(const S& indentation) const {
    using std::abs, std::pow;
    return linear_.stiffness * pow(S(abs(indentation) / reference_), S(exponent_ - 1));
  }
  S secant_stiffness(const S& indentation) const {
    return is_linear() ? linear_.stiffness : power_stiffness(indentation);
  }

  LinearContact<S> linear_;
  S exponent_;   ///< n
  S reference_;  ///< Delta_0, m; the elastic force there is k_t Delta_0
};

}  // namespace rotor
