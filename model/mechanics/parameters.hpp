/// The parameters of the paper's Nomenclature, and its two sets of equations.
#pragma once

namespace rotor {

/// The two sets of equations. `published` is the paper as printed: the velocity jump of Eq. (14) is
/// added to q2', and the moment of gravity has no partner. `consistent` puts both right.
enum class Equations { published, consistent };

/// Parameters in SI units; the defaults are the paper's (Nomenclature).
struct Parameters {
  double mass = 5;                  // m
  double inertia = 9e-3;            // I_C
  double eccentricity = 0.15e-3;    // e_x
  double support_stiffness = 20e3;  // k
  double support_damping = 25;      // d
  double gravity = 9.81;            // g
  double torque = 0.3;              // M_mot
  double motor_off_Hz = 150;        // f_max
  double contact_stiffness = 8e8;   // k_t
  double contact_damping = 1e4;     // d_t
  double friction = 0.3;            // mu
  double rotor_radius = 0.06;       // r
  double stator_radius = 0.063;     // r_a
  double unbalance_factor = 3;      // k_u
  double separation_time = 29.1;    // t_1
  bool separates = true;            // whether the mass m_u is lost at all

  bool operator==(const Parameters&) const = default;
};

}  // namespace rotor
