/// The parameters of the paper's Nomenclature, and where its equations contradict themselves.
#pragma once

#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>

// Results are compared to the last bit, and NaN is a value. Compilers report some of the flags that
// give this up.
#if defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ || defined(__ASSOCIATIVE_MATH__) || \
    defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "Results need the arithmetic of IEEE 754: leave out -Ofast, -ffast-math and its parts"
#endif
static_assert(0.1 != 0.1F, "constants must be doubles: leave out -fsingle-precision-constant");

namespace rotor {

inline constexpr double two_pi = 2 * std::numbers::pi;  ///< radians per turn

/// The shortest decimal that reads as this double: what was typed, if that has at most 15 digits.
std::string shortest_decimal(double number);

/// A stated number in the precision of the computation: the decimal, not the double.
template <class S>
S as_typed(double number) {
  if constexpr (std::numeric_limits<S>::digits <= std::numeric_limits<double>::digits)
    return S(number);
  else if constexpr (std::is_same_v<S, long double>)
    return std::strtold(shortest_decimal(number).c_str(), nullptr);
  else
    return S(shortest_decimal(number).c_str());
}

/// How often the mass loss raises the velocity of the mass centre by Delta_vy, Eq. (14). As
/// printed, twice: by Eq. (1) with e_x1 for e_x, and by an addition to q2'.
enum class VelocityJump { twice, once };

/// How much of gravity's moment about O_a stays in Q_3. As printed, the whole of it, although Q_1
/// and Q_2 leave gravity to the springs; their preload balances all but the part due to the
/// eccentricity.
enum class GravityMoment { whole, balanced };

/// The choice between printed and corrected equations.
struct Equations {
  VelocityJump velocity_jump;
  GravityMoment gravity_moment;

  bool operator==(const Equations&) const = default;

  static const Equations published;  ///< twice, whole
  static const Equations corrected;  ///< once, balanced
};
inline constexpr Equations Equations::published{VelocityJump::twice, GravityMoment::whole};
inline constexpr Equations Equations::corrected{VelocityJump::once, GravityMoment::balanced};

/// What turns the rotor: the paper's motor with its torque, or a drive that holds the speed,
/// whatever torque that takes; the rotation then has no energy that could be exchanged.
enum class Drive { motor, constant_speed };

/// A number that functions beside it set, which also set the one that follows from it.
class Remembered {
 public:
  bool operator==(const Remembered&) const = default;

 private:
  friend struct Parameters;
  friend struct Scenario;
  std::optional<double> number_;
};

/// Parameters in SI units; the defaults are the paper's (Nomenclature).
struct Parameters {
  double mass = 5;                  // m
  double inertia = 9e-3;            // I_C
  double eccentricity = 0.15e-3;    // e_x
  double support_stiffness = 20e3;  // k
  double support_damping = 25;      // d
  double gravity = 9.81;            // g
  Drive drive = Drive::motor;       // at constant speed inertia, torque and motor_off_Hz do nothing
  double torque = 0.3;              // M_mot
  double motor_off_Hz = 150;        // f_max
  double contact_stiffness = 8e8;   // k_t
  double contact_damping = 1e4;     // d_t
  double friction = 0.3;            // mu
  double rotor_radius = 0.06;       // r
  double stator_radius = 0.063;     // r_a
  double unbalance_factor = 3;      // k_u
  double mass_loss_time = 29.1;     // t_1
  bool loses_mass = true;           // whether the mass m_u is lost at all
  double ring_offset_x = 0;         // of the ring's centre from the position of rest, down
  double ring_offset_y = 0;         // the same to the side

  // The contact's law, if it is not the paper's:
  double contact_exponent = 1;       // n of its elastic force
  double reference_indentation = 0;  // Delta_0, at which that is k_t Delta_0, unless n = 1

  Remembered clearance{}, lost_mass{};

  bool operator==(const Parameters&) const = default;

  /// States r_a by the clearance r_a - r, m; r before it.
  void state_clearance(double clearance_m);
  /// States k_u by m_u, kg; m, e_x and r before it. Throws ScenarioError unless m_u < m. Of a
  /// balanced rotor, which no factor describes, m_u is kept.
  void state_lost_mass(double lost_mass_kg);
  /// As they were stated, for a precision in which they are not what their doubles say; nothing if
  /// a number from which they follow has been set since.
  std::optional<double> stated_clearance() const;
  std::optional<double> stated_lost_mass() const;
};

}  // namespace rotor
