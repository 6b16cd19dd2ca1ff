/// The ring's resistance to indentation, which presses the rim back: the only place with its force
/// law. Sources: "Overcritical high-speed rotor systems, full annular rub and accident", Sec. 2.3,
/// Eq. (21), is exponent 1 without hysteresis; exponent 1.5 is Hertz's; damping in proportion to
/// the elastic force is that of K. H. Hunt and F. R. E. Crossley, J. Appl. Mech. 42 (1975) 440.
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
        reference_(as_typed<S>(p.reference_indentation)),
        hysteresis_(as_typed<S>(p.contact_hysteresis)),
        is_linear_(exponent_ == 1 && hysteresis_ == 0),
        ends_with_indentation_(!is_linear_ && linear_.damping == 0) {}

  /// F_n at an indentation (m) and its rate (m/s), N: negative in compression, positive where the
  /// ring would have to pull. Odd in the indentation, so that a step may end beyond the contact.
  S force(const S& indentation, const S& rate) const {
    return is_linear_ ? linear_.force(indentation, rate) : nonlinear_force(indentation, rate);
  }
  /// Rate of -F_n, N/s, from the first and second rate of the indentation.
  S pressure_rate(const S& indentation, const S& rate, const S& second_rate) const {
    if (is_linear_) return linear_.pressure_rate(indentation, rate, second_rate);
    return tangent_stiffness(indentation) * (rate + hysteresis_ * rate * rate) +
           damping(indentation) * second_rate;
  }

  /// Has the sign of -F_n for an indented ring and a simple zero at the release, where F_n may
  /// vanish with its slope.
  S pressing(const S& indentation, const S& rate) const {
    if (ends_with_indentation_) return indentation * (1 + hysteresis_ * rate);
    return -force(indentation, rate);
  }
  /// Has the sign of F_n for an indented ring, and no zero only because the ring springs back.
  S pulling(const S& indentation, const S& rate) const {
    if (ends_with_indentation_) return -1 - hysteresis_ * rate;
    return force(indentation, rate);
  }

  /// Elastic part of the resistance, N; its slope, N/m; the stored energy, J.
  S spring_force(const S& indentation) const { return secant_stiffness(indentation) * indentation; }
  S tangent_stiffness(const S& indentation) const {
    return is_linear_ ? linear_.stiffness : exponent_ * secant_stiffness(indentation);
  }
  S energy(const S& indentation) const {
    return spring_force(indentation) * indentation / (1 + exponent_);
  }
  /// Force per velocity of the damper, N s/m.
  S damping(const S& indentation) const {
    return linear_.damping + hysteresis_ * spring_force(indentation);
  }

  /// Whether the force is linear in the indentation and its rate.
  bool is_linear() const { return is_linear_; }
  /// Whether the force is an analytic function at the touch-down, too.
  bool is_smooth() const { return exponent_ == 1; }
  /// For a formula that holds only for a linear ring. Throws std::domain_error, naming the formula,
  /// for others.
  const LinearContact<S>& linear(const char* formula) const {
    if (!is_linear_)
      throw std::domain_error(std::string(formula) +
                              ": holds only for a ring with contact_exponent = 1 and "
                              "contact_hysteresis = 0");
    return linear_;
  }

  /// The same where is_linear() is known.
  const LinearContact<S>& linear() const { return linear_; }

 private:
  /// Not inlined: its registers would slow down the paper's linear ring.
  [[gnu::cold, gnu::noinline]] S nonlinear_force(S indentation, S rate) const {
    return -spring_force(indentation) - damping(indentation) * rate;
  }
  S power_stiffness(const S& indentation) const {
    using std::abs, std::pow;
    return linear_.stiffness * pow(S(abs(indentation) / reference_), S(exponent_ - 1));
  }
  S secant_stiffness(const S& indentation) const {
    return exponent_ == 1 ? linear_.stiffness : power_stiffness(indentation);
  }

  LinearContact<S> linear_;
  S exponent_;    ///< n
  S reference_;   ///< Delta_0, m; the elastic force there is k_t Delta_0
  S hysteresis_;  ///< alpha, s/m
  bool is_linear_;
  bool ends_with_indentation_;  ///< F_n vanishes only with the indentation, or where it would pull
};

}  // namespace rotor
