/// What is simulated: the parameters of the Nomenclature, which equations, for how long, and how.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace rotor {

/// The two sets of equations. `published` is the paper as printed: the velocity jump of Eq. (14) is
/// added to q2', and the moment of gravity has no partner. `consistent` puts both right.
enum class Equations { published, consistent };

/// How the equations are integrated. `event`: phase by phase between located events, with error
/// control. `rk4`: as in the paper, classical Runge-Kutta with fixed steps.
enum class Method { event, rk4 };

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

struct Scenario {
  Parameters parameters{};
  Equations equations = Equations::published;
  Method method = Method::event;
  double until = 29.35;      // end of the run, s
  double tolerance = 1e-11;  // of event: error allowed in a step, in parts of scale() of phases.hpp
  double step_run_up = 1e-4;  // step of rk4 until the mass loss or the first contact, s
  double step_rub = 5e-6;     // and after it, s

  bool operator==(const Scenario&) const = default;

  /// Whether the mass is lost within this run.
  bool loses_mass() const { return parameters.separates && parameters.separation_time <= until; }
};

/// A number that a scenario states: how it is called and what it may be.
struct Quantity {
  std::string_view name;    ///< as in options and scene files, with underscores
  std::string_view symbol;  ///< the paper's
  std::string_view unit;    ///< "" for a pure number
  std::string_view meaning;
  double& (*in)(Scenario&);  ///< the number itself
  double least;              ///< smallest allowed value
  bool least_allowed;        ///< whether the value may be the least itself
  double greatest = std::numeric_limits<double>::infinity();  ///< greatest allowed value

  double of(Scenario scenario) const { return in(scenario); }
  bool allows(double value) const;
  std::string range() const;  ///< for messages, such as "a number greater than 0 kg"
};

/// All numbers of a scenario, in the order in which they are documented.
std::span<const Quantity> quantities();

/// Throws std::invalid_argument, naming the quantity and what is allowed, if the scenario is not
/// physical or its numbers contradict each other.
void check(const Scenario& scenario);

}  // namespace rotor
