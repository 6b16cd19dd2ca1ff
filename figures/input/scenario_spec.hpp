/// What a scene file or options state of a scenario, and the scenario that results. What is not
/// stated follows from the rest, or is the paper's value.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "figures/input/names.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// A number that can be stated: one of the scenario, one from which it follows, or one of its
/// start.
struct InputQuantity {
  Quantity quantity;
  std::string_view instead_of;  ///< name of the number that follows; empty if none does
  double Start::*of_start = nullptr;
};

/// In the order in which they are documented.
const std::vector<InputQuantity>& input_quantities();
const InputQuantity* find_input_quantity(std::string_view name);
/// The names of these quantities and of named_inputs().
const std::vector<std::string>& varied_inputs();
inline constexpr std::string_view list_of_inputs =
    "rotor run --help lists them as options: --mass-loss-time is mass_loss_time";
/// The name of the number that has this symbol; otherwise the text.
std::string_view name_of_symbol(std::string_view text);
/// The name of the number or choice that this one determines: itself, or the one it replaces.
std::string_view determined_by(std::string_view name);

struct ScenarioSpec {
  std::map<std::string, double, std::less<>> numbers;  ///< by the names of input_quantities
  std::optional<bool> loses_mass;
  std::optional<Equations> equations;
  std::optional<VelocityJump> velocity_jump;
  std::optional<GravityMoment> gravity_moment;
  std::optional<Method> method;
  std::optional<Drive> drive;
  std::optional<int> digits;  ///< to be estimated

  bool operator==(const ScenarioSpec&) const = default;

  bool states_equations() const { return equations || velocity_jump || gravity_moment; }
  bool states(std::string_view input) const;
  bool states_rpm() const;

  /// Both together; `other` takes precedence.
  ScenarioSpec overridden_by(const ScenarioSpec& other) const;
};

/// Throws ScenarioError, stating what is wrong and what is allowed, if two numbers determine the
/// same one, if one is missing, or if the scenario is not physical. A mass loss at a stated speed
/// still has the time 0: a run-up finds its time, see scenario_of() in figures/runs.
Scenario stated_scenario(const ScenarioSpec& spec);

/// Throws if stated_scenario() would because of a number.
void check_numbers(const ScenarioSpec& spec);

/// The message with the inputs that are stated: "start_speed_rpm = 9000 rpm" instead of
/// "start_speed_Hz = 150 Hz".
Message as_stated(Message message, const ScenarioSpec& spec);

/// "0.25 s after the mass loss"
std::string default_end_in_words();

/// Those that are stated, otherwise the corrected ones.
Equations equations_of(const ScenarioSpec& stated);
/// What matters of the paper's rotor, supports, ring and loss if some of these are stated, but not
/// all: "inertia = 0.009 kg m^2" and so on.
std::vector<std::string> left_to_the_paper(const ScenarioSpec& stated);

/// A stated number of digits. Throws InputError, stating what is allowed.
int parse_digits(double number);

/// An input that is stated by a name. `state` throws InputError, listing the names.
struct NamedInput {
  std::string_view name, standard, meaning;
  void (*state)(ScenarioSpec& spec, std::string_view name);
};
std::span<const NamedInput> named_inputs();
const NamedInput* find_named_input(std::string_view name);

/// The option of a number or a choice: its name with dashes.
std::string option_of(std::string_view name);
/// States a number by its text, as the command line does. Throws InputError with the option.
void state_number(ScenarioSpec& spec, const Quantity& quantity, const std::string& text);

}  // namespace rotor
