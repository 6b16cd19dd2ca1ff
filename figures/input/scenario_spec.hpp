/// What somebody states of a scenario, in a scene file or by options, and the scenario that this
/// makes. What is not stated follows from the rest, or is the paper's.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "figures/input/names.hpp"
#include "figures/runs/run_ups.hpp"

namespace rotor {

/// A number that can be stated: one of the scenario itself, or another way to state one of those.
struct InputQuantity {
  Quantity quantity;
  std::string_view instead_of;  ///< the scenario's own, if it is not that
};

/// In the order in which they are documented.
std::span<const InputQuantity> input_quantities();
const InputQuantity* find_input_quantity(std::string_view name);
/// The name of what a number or choice determines: itself, or what it is stated instead of.
std::string_view determined_by(std::string_view name);

struct ScenarioSpec {
  std::map<std::string, double, std::less<>> numbers;  ///< by the names of input_quantities
  std::optional<bool> loses_mass;
  std::optional<Equations> equations;
  std::optional<VelocityJump> velocity_jump;
  std::optional<GravityMoment> gravity_moment;
  std::optional<Method> method;
  std::optional<int> digits;  ///< that a run is to make sure of

  bool states_equations() const { return equations || velocity_jump || gravity_moment; }

  /// The same, where another one takes precedence.
  ScenarioSpec overridden_by(const ScenarioSpec& other) const;
};

/// Throws InputError, saying what is wrong and what would be right, if two numbers determine the
/// same, if one is missing, or if what they make is not physical. The speed at the mass loss is
/// searched in run-ups that may be known already.
Scenario scenario_of(const ScenarioSpec& spec, RunUps& run_ups);
Scenario scenario_of(const ScenarioSpec& spec);

/// Throws InputError where no run-up could help: scenario_of will, too.
void check_numbers(const ScenarioSpec& spec);

/// The number of digits that a number states. Throws InputError, saying what is allowed.
int parse_digits(double number);

/// What is stated by a name: equations, velocity_jump, gravity_moment, method.
std::span<const std::string_view> named_inputs();
/// States one of them. Throws InputError, saying which names there are.
void state(ScenarioSpec& spec, std::string_view input_quantity, std::string_view name);

/// How the command line calls a number or a choice: with dashes.
std::string option_of(std::string_view name);
/// States a number by its text, as the command line does. Throws InputError, naming its option.
void state_number(ScenarioSpec& spec, const Quantity& quantity, const std::string& text);

}  // namespace rotor
