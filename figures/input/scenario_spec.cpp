#include "figures/input/scenario_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/digits/digits.hpp"
#include "model/mechanics/contact_law.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

constexpr std::string_view mass_loss_speed = "mass_loss_speed_Hz", start_speed = "start_speed_Hz";
constexpr double greatest_rpm = 60 * greatest_speed;

constexpr std::array alternatives = {
    InputQuantity{
        {"clearance", "r_a - r", "m", "clearance between rotor and ring", nullptr, least_positive},
        "stator_radius"},
    InputQuantity{{"lost_mass", "m_u", "kg",
                   "lost mass (from the rim, opposite to the eccentricity)", nullptr, 0},
                  "unbalance_factor"},
    InputQuantity{{mass_loss_speed, "f_1", "Hz", "speed at the mass loss", nullptr, least_positive,
                   greatest_speed},
                  "mass_loss_time"},
    InputQuantity{{"mass_loss_speed_rpm", "", "rpm", "the same in revolutions per minute", nullptr,
                   least_positive, greatest_rpm},
                  mass_loss_speed},
    InputQuantity{{"motor_off_rpm", "", "rpm", "the same in revolutions per minute", nullptr, 0,
                   greatest_rpm},
                  "motor_off_Hz"},
    InputQuantity{{"start_speed_rpm", "", "rpm", "the same in revolutions per minute", nullptr, 0,
                   greatest_rpm},
                  start_speed}};

/// Together they are instead of the steady response; those that are not stated are 0.
constexpr std::array numbers_of_start = {
    InputQuantity{{"start_x", "", "m", "O at the start, down, instead of the steady response",
                   nullptr, -greatest_number},
                  "",
                  &Start::x},
    InputQuantity{
        {"start_y", "", "m", "the same to the side", nullptr, -greatest_number}, "", &Start::y},
    InputQuantity{{"start_velocity_x", "", "m/s", "velocity of O at the start, down", nullptr,
                   -greatest_speed, greatest_speed},
                  "",
                  &Start::velocity_x},
    InputQuantity{{"start_velocity_y", "", "m/s", "the same to the side", nullptr, -greatest_speed,
                   greatest_speed},
                  "",
                  &Start::velocity_y}};

[[noreturn]] void refuse_both(std::string_view one, std::string_view other) {
  throw ScenarioError({Mention{std::string(one)}, " and ", Mention{std::string(other)},
                       ": one determines the other; state one of them"});
}

/// With speeds in Hz only. Throws ScenarioError if one is stated in both units.
ScenarioSpec with_speeds_in_Hz(ScenarioSpec spec) {
  for (const InputQuantity& input : alternatives)
    if (input.quantity.unit == "rpm")
      if (auto stated = spec.numbers.extract(std::string(input.quantity.name))) {
        if (spec.numbers.contains(input.instead_of)) refuse_both(stated.key(), input.instead_of);
        stated.key() = input.instead_of;
        stated.mapped() /= 60;
        spec.numbers.insert(std::move(stated));
      }
  return spec;
}

bool states_mass_loss(std::string_view input) {
  const std::string_view determined = determined_by(input);
  return determined == "mass_loss_time" || determined == "unbalance_factor";
}

std::optional<double> number(const ScenarioSpec& spec, std::string_view name) {
  const auto found = spec.numbers.find(name);
  return found == spec.numbers.end() ? std::nullopt : std::optional(found->second);
}

/// The default time between the mass loss and the end of a run.
constexpr double default_rub_s = 0.25;

/// The scenario; if the mass loss is stated by its speed, mass is lost at the start.
Scenario numbers_of(const ScenarioSpec& stated) {
  for (const InputQuantity& input : input_quantities())  // the others are checked in the scenario
    if (const auto value = number(stated, input.quantity.name);
        value && !input.quantity.in && !input.quantity.allows(*value))
      throw ScenarioError({input.quantity.with(*value), ": must be " + input.quantity.range()});
  const ScenarioSpec spec = with_speeds_in_Hz(stated);
  for (const InputQuantity& s : input_quantities())
    if (!s.instead_of.empty() && number(spec, s.quantity.name) && number(spec, s.instead_of))
      refuse_both(s.quantity.name, s.instead_of);
  if (spec.digits && number(spec, "tolerance"))
    throw ScenarioError({Mention{"digits"}, " and ", Mention{"tolerance"},
                         ": the first determines the second; state one of them"});
  Scenario scenario;
  for (const Quantity& quantity : quantities())
    if (const auto value = number(spec, quantity.name)) quantity.in(scenario) = *value;
  for (const InputQuantity& input : numbers_of_start)
    if (const auto value = number(spec, input.quantity.name)) {
      if (!scenario.start) scenario.start.emplace();
      *scenario.start.*input.of_start = *value;
    }
  Parameters& p = scenario.parameters;
  p.drive = spec.drive.value_or(p.drive);
  if (p.drive == Drive::constant_speed && number(spec, mass_loss_speed))
    throw ScenarioError({Mention{"drive", "constant_speed"}, " and ",
                         Mention{std::string(mass_loss_speed)}, ": state mass_loss_time instead"});
  p.loses_mass = spec.loses_mass.value_or(true);
  scenario.equations = equations_of(spec);
  scenario.method = spec.method.value_or(scenario.method);
  if (spec.digits && scenario.method == Method::rk4)
    throw ScenarioError({Mention{"digits"}, " and ", Mention{"method", "rk4"},
                         ": only event can estimate digits; rk4 is of first order at contacts"});

  if (const auto clearance = number(spec, "clearance")) p.state_clearance(*clearance);
  if (const auto lost_mass = number(spec, "lost_mass")) p.state_lost_mass(*lost_mass);

  const bool at_speed = number(spec, mass_loss_speed).has_value();
  const auto until = number(spec, "until");
  if (!p.loses_mass) {
    for (const auto& [name, value] : stated.numbers)
      if (states_mass_loss(name))
        throw ScenarioError(
            {Mention{name}, " and ", Mention{"no_mass_loss"}, ": state one of them"});
    if (!until)
      throw ScenarioError({Mention{"no_mass_loss"}, ": until, the end of the run, must be stated"});
  } else if (at_speed || (scenario.start_speed_Hz > 0 && !number(spec, "mass_loss_time"))) {
    p.mass_loss_time = 0;
  }
  scenario.until = until.value_or(p.mass_loss_time + default_rub_s);
  return scenario;
}

}  // namespace

const std::vector<InputQuantity>& input_quantities() {
  static const std::vector<InputQuantity> all = [] {
    std::vector<InputQuantity> list;
    const auto add = [&](const auto& self, const InputQuantity& input) -> void {
      list.push_back(input);
      for (const InputQuantity& other : alternatives)
        if (other.instead_of == input.quantity.name) self(self, other);
    };
    for (const Quantity& quantity : quantities()) {
      add(add, {quantity, ""});
      if (quantity.name == start_speed)
        list.insert(list.end(), numbers_of_start.begin(), numbers_of_start.end());
    }
    return list;
  }();
  return all;
}

const InputQuantity* find_input_quantity(std::string_view name) {
  for (const InputQuantity& input : input_quantities())
    if (input.quantity.name == name) return &input;
  return nullptr;
}

const std::vector<std::string>& varied_inputs() {
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const InputQuantity& input : input_quantities()) names.emplace_back(input.quantity.name);
    for (const NamedInput& input : named_inputs()) names.emplace_back(input.name);
    return names;
  }();
  return all;
}

std::string_view name_of_symbol(std::string_view text) {
  for (const InputQuantity& input : input_quantities())
    if (input.quantity.symbol == text && !text.empty()) return input.quantity.name;
  return text;
}

std::string_view determined_by(std::string_view name) {
  const InputQuantity* const input = find_input_quantity(name);
  return input && !input->instead_of.empty() ? determined_by(input->instead_of) : name;
}

bool ScenarioSpec::states(std::string_view input) const {
  return numbers.contains(input) || (input == "drive" && drive) || (input == "method" && method) ||
         (input == "digits" && digits) || (input == "no_mass_loss" && loses_mass);
}

bool ScenarioSpec::states_rpm() const {
  return std::any_of(numbers.begin(), numbers.end(),
                     [](const auto& number) { return number.first.ends_with("_rpm"); });
}

ScenarioSpec ScenarioSpec::overridden_by(const ScenarioSpec& other) const {
  ScenarioSpec result = *this;
  if (other.digits) result.numbers.erase("tolerance");
  if (number(other, "tolerance")) result.digits = std::nullopt;
  for (const auto& [name, value] : other.numbers)
    std::erase_if(result.numbers, [&, stated = std::string_view(name)](const auto& lower) {
      return determined_by(lower.first) == determined_by(stated);
    });
  result.numbers.insert(other.numbers.begin(), other.numbers.end());
  // What states a mass loss overrides "no mass loss", and is overridden by it.
  const auto is_of_loss = [](const auto& number) { return states_mass_loss(number.first); };
  if (std::any_of(other.numbers.begin(), other.numbers.end(), is_of_loss))
    result.loses_mass = true;
  else if (other.loses_mass == false)
    std::erase_if(result.numbers, is_of_loss);
  if (other.loses_mass) result.loses_mass = other.loses_mass;
  if (other.digits) result.digits = other.digits;
  if (other.equations) {
    result.equations = other.equations;
    result.velocity_jump = std::nullopt;
    result.gravity_moment = std::nullopt;
  }
  if (other.velocity_jump) result.velocity_jump = other.velocity_jump;
  if (other.gravity_moment) result.gravity_moment = other.gravity_moment;
  if (other.method) result.method = other.method;
  if (other.drive) result.drive = other.drive;
  return result;
}

Scenario stated_scenario(const ScenarioSpec& spec) {
  Scenario scenario = numbers_of(spec);
  check(scenario);
  if (const auto speed = number(with_speeds_in_Hz(spec), mass_loss_speed)) {
    const Mention at_loss = find_input_quantity(mass_loss_speed)->quantity.with(*speed);
    if (*speed < scenario.start_speed_Hz)
      throw ScenarioError({at_loss, ": must not be less than ", mention_of(scenario, start_speed)});
    if (spec.digits && *speed == scenario.parameters.motor_off_Hz)
      throw ScenarioError({Mention{"digits"}, " and ", at_loss,
                           ": the mass loss and the end of the drive, at ", Mention{"motor_off_Hz"},
                           ", coincide; state mass_loss_time"});
    scenario.state_mass_loss_speed(*speed, 0);
  }
  return scenario;
}

void check_numbers(const ScenarioSpec& spec) { check_numbers(numbers_of(spec)); }

std::string default_end_in_words() {
  return fmt::format("{} s after the mass loss", default_rub_s);
}

Message as_stated(Message message, const ScenarioSpec& spec) {
  for (Message::Part& part : message.parts)
    if (auto* const input = std::get_if<Mention>(&part))
      for (const auto& [name, value] : spec.numbers) {
        const InputQuantity& stated = *find_input_quantity(name);
        if (stated.instead_of == input->name && !spec.numbers.contains(input->name)) {
          *input = stated.quantity.with(value);
          break;
        }
      }
  return message;
}

Equations equations_of(const ScenarioSpec& stated) {
  const Equations all = stated.equations.value_or(Scenario{}.equations);
  return {stated.velocity_jump.value_or(all.velocity_jump),
          stated.gravity_moment.value_or(all.gravity_moment)};
}

std::vector<std::string> left_to_the_paper(const ScenarioSpec& stated) {
  const auto is_stated = [&](std::string_view name) {
    return std::any_of(stated.numbers.begin(), stated.numbers.end(),
                       [&](const auto& number) { return determined_by(number.first) == name; });
  };
  const bool is_driven = stated.drive != Drive::constant_speed;
  const bool loses_mass = stated.loses_mass.value_or(true);
  std::vector<std::string> all;
  bool is_other = false;
  for (const Quantity& quantity : quantities()) {
    const std::string_view name = quantity.name;
    if (name == start_speed) break;  // from here on they are of the run
    is_other = is_other || is_stated(name);
    if (quantity.of(Scenario{}) == std::max(quantity.least, 0.)) continue;  // left out by the paper
    const bool matters = name == "unbalance_factor" ? loses_mass
                         : name == "mass_loss_time" ? loses_mass && !is_stated(start_speed)
                         : name == "motor_off_Hz"   ? is_driven && number(stated, "torque") != 0.
                         : name == "torque" || name == "inertia" ? is_driven
                                                                 : name != "gravity";
    if (matters && !is_stated(name)) all.push_back(mention_of(Scenario{}, name).text());
  }
  if (!is_other) all.clear();
  return all;
}

std::span<const NamedInput> named_inputs() {
  using Spec = ScenarioSpec;
  using Text = std::string_view;
  constexpr Scenario standard{};
  static constexpr std::array all = {
      NamedInput{"equations", name_of(standard.equations),
                 "published (as printed: twice, whole) or corrected (once, balanced)",
                 [](Spec& s, Text name) { s.equations = parse_name<Equations>(name); }},
      NamedInput{"velocity_jump", "by --equations",
                 "once or twice: how often the mass loss adds Delta_vy to the velocity of C",
                 [](Spec& s, Text name) { s.velocity_jump = parse_name<VelocityJump>(name); }},
      NamedInput{"gravity_moment", "by --equations",
                 "whole (as printed) or balanced by the springs except for the part due to the "
                 "eccentricity",
                 [](Spec& s, Text name) { s.gravity_moment = parse_name<GravityMoment>(name); }},
      NamedInput{"method", name_of(standard.method),
                 "event (located contacts, error control) or rk4 (the paper's fixed steps)",
                 [](Spec& s, Text name) { s.method = parse_name<Method>(name); }},
      NamedInput{
          "drive", name_of(Parameters{}.drive),
          "motor (torque, until motor_off_Hz) or constant_speed (held from the start, whatever "
          "torque that takes)",
          [](Spec& s, Text name) { s.drive = parse_name<Drive>(name); }}};
  return all;
}

const NamedInput* find_named_input(std::string_view name) {
  for (const NamedInput& input : named_inputs())
    if (input.name == name) return &input;
  return nullptr;
}

int parse_digits(double number) {
  if (!run_to_digits)
    throw InputError("digits: this program was built without them; make build adds them");
  if (!(number >= 1 && number <= most_digits && number == std::floor(number)))
    throw InputError("digits = {}: must be a whole number from 1 to {}", number, most_digits);
  return static_cast<int>(number);
}

std::string option_of(std::string_view name) {
  std::string option = "--" + std::string(name);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

void state_number(ScenarioSpec& spec, const Quantity& quantity, const std::string& text) {
  const auto value = number_in(text);
  if (!value || !quantity.allows(*value))
    throw InputError("{}: must be {}, not {}", option_of(quantity.name), quantity.range(),
                     shown(text));
  spec.numbers.insert_or_assign(std::string(quantity.name), *value);
}

}  // namespace rotor
