#include "figures/input/scenario_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "model/digits/digits.hpp"
#include "model/mechanics/contact_law.hpp"
#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

constexpr std::string_view mass_loss_speed = "mass_loss_speed_hz", start_speed = "start_speed_hz";
constexpr double unbounded = -std::numeric_limits<double>::infinity();

constexpr std::array alternatives = {
    InputQuantity{{"clearance", "r_a - r", "m", "clearance between rotor and ring", nullptr, 0},
                  "stator_radius"},
    InputQuantity{{"lost_mass", "m_u", "kg",
                   "lost mass (from the rim, opposite to the eccentricity)", nullptr, 0, true},
                  "unbalance_factor"},
    InputQuantity{{mass_loss_speed, "f_1", "Hz", "speed at the mass loss", nullptr, 0},
                  "mass_loss_time"},
    InputQuantity{
        {"mass_loss_speed_rpm", "", "rpm", "the same in revolutions per minute", nullptr, 0},
        mass_loss_speed},
    InputQuantity{
        {"motor_off_rpm", "", "rpm", "the same in revolutions per minute", nullptr, 0, true},
        "motor_off_hz"},
    InputQuantity{
        {"start_speed_rpm", "", "rpm", "the same in revolutions per minute", nullptr, 0, true},
        start_speed}};

/// Together they are instead of the steady response; those that are not stated are 0.
constexpr std::array numbers_of_start = {
    InputQuantity{{"start_x", "", "m", "O at the start, down, instead of the steady response",
                   nullptr, unbounded},
                  "",
                  &Start::x},
    InputQuantity{{"start_y", "", "m", "the same to the side", nullptr, unbounded}, "", &Start::y},
    InputQuantity{
        {"start_velocity_x", "", "m/s", "velocity of O at the start, down", nullptr, unbounded},
        "",
        &Start::velocity_x},
    InputQuantity{{"start_velocity_y", "", "m/s", "the same to the side", nullptr, unbounded},
                  "",
                  &Start::velocity_y}};

constexpr const char* state_one = "{} and {}: one determines the other; state one of them";

/// With speeds in Hz only. Throws InputError if one is stated in both units.
ScenarioSpec with_speeds_in_Hz(ScenarioSpec spec) {
  for (const InputQuantity& input : alternatives)
    if (input.quantity.unit == "rpm")
      if (auto stated = spec.numbers.extract(std::string(input.quantity.name))) {
        if (spec.numbers.contains(input.instead_of))
          throw InputError(state_one, stated.key(), input.instead_of);
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

void state_lost_mass(Parameters& p, double lost_mass) {
  if (!(lost_mass < p.mass))
    throw InputError("lost_mass = {} kg: must be less than mass = {} kg", lost_mass, p.mass);
  p.lost_mass = lost_mass;
  p.unbalance_factor =  // that of a balanced rotor would be infinite
      lost_mass > 0 && p.eccentricity > 0 ? MassLoss<double>::unbalance_factor(p) : 1;
}

/// The default time between the mass loss and the end of a run.
constexpr double default_rub_s = 0.25;

/// The scenario; if the mass loss is stated by its speed, mass is lost at the start.
Scenario numbers_of(const ScenarioSpec& stated) {
  for (const InputQuantity& input : input_quantities())  // the others are checked in the scenario
    if (const auto value = number(stated, input.quantity.name);
        value && !input.quantity.in && !input.quantity.allows(*value))
      throw InputError("{} = {}: must be {}", input.quantity.name, *value, input.quantity.range());
  const ScenarioSpec spec = with_speeds_in_Hz(stated);
  for (const InputQuantity& s : input_quantities())
    if (!s.instead_of.empty() && number(spec, s.quantity.name) && number(spec, s.instead_of))
      throw InputError(state_one, s.quantity.name, s.instead_of);
  if (spec.digits && number(spec, "tolerance"))
    throw InputError("digits and tolerance: the first determines the second; state one of them");
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
  if (p.drive == Drive::constant_speed) {
    if (number(spec, mass_loss_speed))
      throw InputError("drive = constant_speed and {}: state mass_loss_time instead",
                       mass_loss_speed);
    p.torque = 0;  // which holds the speed is not known beforehand
  }
  p.loses_mass = spec.loses_mass.value_or(true);
  scenario.equations = equations_of(spec);
  scenario.method = spec.method.value_or(scenario.method);
  if (spec.digits && scenario.method == Method::rk4)
    throw InputError(
        "digits and method = rk4: only event can estimate digits; rk4 is of first order at "
        "contacts");

  if (const auto clearance = number(spec, "clearance")) {
    p.clearance = *clearance;
    p.stator_radius = p.rotor_radius + *clearance;
  }
  if (const auto lost_mass = number(spec, "lost_mass")) state_lost_mass(p, *lost_mass);

  const bool at_speed = number(spec, mass_loss_speed).has_value();
  const auto until = number(spec, "until");
  if (!p.loses_mass) {
    for (const auto& [name, value] : stated.numbers)
      if (states_mass_loss(name)) throw InputError("{} and no_mass_loss: state one of them", name);
    if (!until) throw InputError("no_mass_loss: until, the end of the run, must be stated");
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
    if (*speed < scenario.start_speed_Hz)
      throw InputError("{} = {} Hz: must not be less than {} = {} Hz", mass_loss_speed, *speed,
                       start_speed, scenario.start_speed_Hz);
    if (spec.digits && *speed == scenario.parameters.motor_off_Hz)
      throw InputError(
          "digits and {} = {} Hz: the mass loss and the end of the drive, at motor_off_hz, "
          "coincide; state mass_loss_time",
          mass_loss_speed, *speed);
    scenario.mass_loss_speed_Hz = *speed;
  }
  return scenario;
}

void check_numbers(const ScenarioSpec& spec) { check_numbers(numbers_of(spec)); }

std::string as_stated(std::string message, const ScenarioSpec& spec) {
  for (const auto& [name, value] : spec.numbers) {
    const InputQuantity& input = *find_input_quantity(name);
    const std::string follows(input.instead_of);
    if (follows.empty() || follows == "mass_loss_time" || spec.numbers.contains(follows)) continue;
    const std::string_view unit = find_input_quantity(follows)->quantity.unit;
    const std::regex named(
        fmt::format("\\b{}\\b( = [^ ,:;]+{}{})?", follows, unit.empty() ? "" : " ", unit));
    message = std::regex_replace(message, named,
                                 fmt::format("{} = {} {}", name, value, input.quantity.unit));
  }
  return message;
}

std::vector<std::string> inputs_named(const std::string& message) {
  static const std::regex name("([a-z_]+)( =|:| and )");
  std::vector<std::string> all;
  for (std::sregex_iterator at(message.begin(), message.end(), name), end; at != end; ++at)
    all.push_back((*at)[1]);
  return all;
}

bool is_own_rotor(const ScenarioSpec& stated) {
  const auto states = [&](const char* name) { return stated.numbers.contains(name); };
  return states("mass") || states("inertia") || states("rotor_radius");
}

Equations equations_of(const ScenarioSpec& stated) {
  const Equations usual = is_own_rotor(stated) ? Equations::corrected : Scenario{}.equations;
  const Equations all = stated.equations.value_or(usual);
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
  for (const Quantity& quantity : quantities()) {
    const std::string_view name = quantity.name;
    if (name == start_speed) break;                           // from here on they are of the run
    if (quantity.of(Scenario{}) == quantity.least) continue;  // the paper leaves that out
    const bool matters = name == "unbalance_factor" ? loses_mass
                         : name == "mass_loss_time" ? loses_mass && !is_stated(start_speed)
                         : name == "motor_off_hz"   ? is_driven && number(stated, "torque") != 0.
                         : name == "torque" || name == "inertia" ? is_driven
                                                                 : name != "gravity";
    if (matters && !is_stated(name)) all.push_back(quantity.text(Scenario{}));
  }
  return all;
}

std::span<const NamedInput> named_inputs() {
  using Spec = ScenarioSpec;
  using Text = std::string_view;
  constexpr Scenario standard{};
  static constexpr std::array all = {
      NamedInput{
          "equations", name_of(standard.equations),
          "published (as printed: twice, whole) or corrected (once, balanced): the default for a "
          "rotor that states its mass, inertia or rotor radius",
          [](Spec& s, Text name) {
            s.equations = parse_name<Equations>(name == "consistent" ? "corrected" : name);
          }},
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
          "motor (torque, until motor_off_hz) or constant_speed (held from the start, whatever "
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
