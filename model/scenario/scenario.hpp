/// What is simulated: which rotor, which equations, for how long, and how.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/mechanics/parameters.hpp"
#include "model/scenario/message.hpp"

namespace rotor {

/// How the equations are integrated. `event`: phase by phase between located events, with error
/// control. `rk4`: as in the paper, classical Runge-Kutta with fixed steps.
enum class Method { event, rk4 };

/// Where O is at the start, m, and its velocity, m/s, in the stator's axes: x is down.
struct Start {
  double x = 0, y = 0, velocity_x = 0, velocity_y = 0;

  bool operator==(const Start&) const = default;
};

struct Scenario {
  Parameters parameters{};
  Equations equations = Equations::corrected;
  Method method = Method::event;
  double start_speed_Hz = 0;     // at which the run starts, in steady response; 0: at rest
  std::optional<Start> start{};  // if stated instead of the steady response
  double until = 29.35;          // end of the run, s
  double tolerance = 1e-11;   // of event: error allowed in a step, relative to the phase's scale()
  double step_run_up = 1e-4;  // of rk4: step until the mass loss or the first contact, s
  double step_rub = 5e-6;     // of rk4: step after that, s
  Remembered mass_loss_speed_Hz{}, time_at_that_speed_s{};

  bool operator==(const Scenario&) const = default;

  /// The time of the mass loss, s, as that at which the run-up reaches a speed: for a precision in
  /// which it is found again.
  void state_mass_loss_speed(double speed_Hz, double time_s);
  /// Nothing if the time has been set since.
  std::optional<double> stated_mass_loss_speed_Hz() const;

  /// Whether mass is lost within this run.
  bool loses_mass() const { return parameters.loses_mass && parameters.mass_loss_time <= until; }

  /// End of the run-up if the rotor does not touch the ring before, s.
  double run_up_end() const { return loses_mass() ? parameters.mass_loss_time : until; }
};

/// The part of a scenario on which its run-up depends, everything else at its default. Scenarios
/// with equal parts share their run-up.
Scenario run_up_part(const Scenario& scenario);

/// Between these, in SI units, products and powers of several numbers are doubles, too.
inline constexpr double least_positive = 1e-30, greatest_number = 1e30;
/// Far beyond any machine: of speeds in Hz, velocities in m/s and gravity in m/s^2.
inline constexpr double greatest_speed = 1e6;

/// A number of a scenario: its name, its unit and its range.
struct Quantity {
  std::string_view name;    ///< as in options and scene files, with underscores
  std::string_view symbol;  ///< of the paper
  std::string_view unit;    ///< "" for a pure number
  std::string_view meaning;
  double& (*in)(Scenario&);  ///< the number itself
  double least;              ///< smallest allowed value; 0 or any positive number if it is 0
  double greatest = greatest_number;  ///< greatest allowed value

  double of(Scenario scenario) const { return in(scenario); }
  Mention with(double value) const;  ///< "mass = 5 kg"
  bool allows(double value) const;
  std::string range() const;  ///< for messages: "a number from 1e-30 to 1e+30 kg"
};

/// All numbers of a scenario, in the order in which they are documented.
std::span<const Quantity> quantities();

/// The number with that name, as the scenario has it.
Mention mention_of(const Scenario& scenario, std::string_view name);

/// Throws ScenarioError, with the quantity and what is allowed, if the numbers are not physical or
/// contradict each other.
void check_numbers(const Scenario& scenario);

}  // namespace rotor
