/// A second way to the motion of a rotor, which shares neither phases, guards and charts nor the
/// integrator with the model: Newton's laws in the stator's axes, integrated by Odeint's
/// Runge-Kutta-Fehlberg 7(8) and cut by bisection wherever the contact changes.
#pragma once

#include <array>

#include "model/scenario/observer.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// O in the stator's axes, x downwards (m), and the angle of the rotor (rad); then their rates.
using Newton = std::array<double, 6>;

Newton in_stator_axes(const State<double>& q);
State<double> in_rotating_axes(const Newton& x);

/// The rim point nearest to the ring.
struct NewtonRim {
  double nx, ny;             ///< its direction from O_a
  double rho;                ///< distance of O, m
  double indentation, rate;  ///< m, m/s; negative indentation: a gap
  double slip;               ///< velocity along (-ny, nx), m/s
};

/// The laws for one body: before the mass loss, or after it.
struct NewtonLaws {
  Parameters parameters;
  GravityMoment gravity_moment;
  Body<double> body;
  bool motor_on;

  NewtonRim rim(const Newton& x) const;
  /// On the supports along an axis, N; they rest where the ring's centre is off by its offset.
  double bearing_force(const Newton& x, std::size_t axis) const;
  /// Of the ring as long as it presses, N; negative where it would have to pull.
  double pressure(const NewtonRim& k) const;
  /// The rates of the motion under a pressure against the normal and a friction along (-ny, nx), N.
  Newton rates(const Newton& x, const NewtonRim& k, double pressure, double friction) const;
  /// The friction that keeps the slip as it is, N.
  double holding_friction(const Newton& x) const;
};

struct NewtonSteps {
  double tolerance;   ///< error of a step, relative to a hundredth of the clearance
  double per_period;  ///< least number of steps in the shortest natural period or turn
  long most;          ///< number of steps
};

/// Follows a scenario to its end, and shows what the event method shows: both sides of each event,
/// and the maxima. Returns false if the steps do not suffice.
bool run_by_newton(const Scenario& scenario, const NewtonSteps& steps, Observer& observer);

}  // namespace rotor
