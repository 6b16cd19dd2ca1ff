#include "figures/scenes/statement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "figures/data/text.hpp"
#include "figures/scenes/interruptible.hpp"
#include "model/simulation/extended/digits.hpp"

namespace rotor {
namespace {

constexpr std::string_view separation_speed = "separation_speed_hz";

const std::vector<Statable>& all_statables() {
  static const std::vector<Statable> all = [] {
    std::vector<Statable> list;
    const auto add = [&](std::string_view instead_of, Quantity quantity) {
      list.push_back({quantity, instead_of});
    };
    for (const Quantity& quantity : quantities()) {
      add("", quantity);
      if (quantity.name == "stator_radius")
        add(quantity.name,
            {"clearance", "r_a - r", "m", "clearance between rotor and ring", nullptr, 0, false});
      if (quantity.name == "unbalance_factor")
        add(quantity.name, {"lost_mass", "m_u", "kg", "mass that is lost", nullptr, 0, true});
      if (quantity.name == "separation_time")
        add(quantity.name,
            {separation_speed, "f_1", "Hz", "speed at the mass loss", nullptr, 0, false});
    }
    return list;
  }();
  return all;
}

std::optional<double> number(const Statement& statement, std::string_view name) {
  const auto found = statement.numbers.find(name);
  return found == statement.numbers.end() ? std::nullopt : std::optional(found->second);
}

/// Eq. (5) for k_u.
double unbalance_factor(const Parameters& p, double lost_mass) {
  if (!(p.eccentricity > 0))
    throw InputError("lost_mass: a rotor without eccentricity has no unbalance that could grow");
  if (!(lost_mass < p.mass))
    throw InputError(
        fmt::format("lost_mass = {} kg: must be less than mass = {} kg", lost_mass, p.mass));
  return 1 + lost_mass * (p.eccentricity + p.rotor_radius) /
                 ((p.mass - lost_mass) * p.eccentricity);  // which is never below 1
}

/// The time between the mass loss and the end of a run that states none.
constexpr double default_rub_s = 0.25;

/// The scenario but for the time at which a speed is reached: then the mass is lost at the start.
Scenario numbers_of(const Statement& statement) {
  for (const Statable& s : statables())
    if (!s.instead_of.empty() && number(statement, s.quantity.name) &&
        number(statement, s.instead_of))
      throw InputError(fmt::format("{} and {}: one determines the other; state one of them",
                                   s.quantity.name, s.instead_of));
  if (statement.digits) {
    if (number(statement, "tolerance"))
      throw InputError("digits and tolerance: the first determines the second; state one of them");
    for (const Statable& s : statables())
      if (!s.instead_of.empty() && number(statement, s.quantity.name))
        throw InputError(
            fmt::format("digits and {}: a {} that follows from it is rounded, and digits are of "
                        "what is stated; "
                        "state {}",
                        s.quantity.name, s.instead_of, s.instead_of));
  }
  Scenario scenario;
  for (const Quantity& quantity : quantities())
    if (const auto value = number(statement, quantity.name)) quantity.in(scenario) = *value;
  Parameters& p = scenario.parameters;
  p.separates = statement.loses_mass.value_or(true);
  scenario.equations = statement.equations.value_or(scenario.equations);
  if (statement.velocity_jump) scenario.equations.velocity_jump = *statement.velocity_jump;
  if (statement.gravity_moment) scenario.equations.gravity_moment = *statement.gravity_moment;
  scenario.method = statement.method.value_or(scenario.method);
  if (statement.digits && scenario.method == Method::rk4)
    throw InputError(
        "digits: method rk4 is of first order at contacts; only event can have any number of them");

  if (const auto clearance = number(statement, "clearance"))
    p.stator_radius = p.rotor_radius + *clearance;
  if (const auto lost_mass = number(statement, "lost_mass"))
    p.unbalance_factor = unbalance_factor(p, *lost_mass);

  const bool at_speed = number(statement, separation_speed).has_value();
  const auto until = number(statement, "until");
  if (!p.separates) {
    for (const std::string_view name : {std::string_view("separation_time"), separation_speed})
      if (number(statement, name))
        throw InputError(fmt::format("{}: there is no mass loss in this run", name));
    if (!until) throw InputError("until: must be stated for a run without mass loss");
  } else if (at_speed || (scenario.start_speed_Hz > 0 && !number(statement, "separation_time"))) {
    p.separation_time = 0;
  }
  scenario.until = until.value_or(p.separation_time + default_rub_s);
  return scenario;
}

}  // namespace

std::span<const Statable> statables() { return all_statables(); }

const Statable* find_statable(std::string_view name) {
  const auto& all = all_statables();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Statable& s) { return s.quantity.name == name; });
  return found == all.end() ? nullptr : &*found;
}

Statement Statement::overridden_by(const Statement& other) const {
  Statement result = *this;
  if (other.digits) result.numbers.erase("tolerance");
  if (number(other, "tolerance")) result.digits = std::nullopt;
  const auto determines = [](std::string_view name) {
    const Statable* const statable = find_statable(name);
    return statable->instead_of.empty() ? name : statable->instead_of;
  };
  for (const auto& [name, value] : other.numbers)
    std::erase_if(result.numbers, [&, stated = std::string_view(name)](const auto& lower) {
      return determines(lower.first) == determines(stated);
    });
  result.numbers.insert(other.numbers.begin(), other.numbers.end());
  // Above "no mass loss", a time or speed of it states that there is one; below it, none.
  const auto is_of_loss = [&](const auto& number) {
    return determines(number.first) == "separation_time";
  };
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
  return result;
}

Scenario scenario_of(const Statement& statement) {
  RunUps none;
  return scenario_of(statement, none);
}

Scenario scenario_of(const Statement& statement, RunUps& run_ups) {
  Scenario scenario = numbers_of(statement);
  Parameters& p = scenario.parameters;
  if (const auto speed = number(statement, separation_speed)) {
    check(scenario);
    if (*speed < scenario.start_speed_Hz)
      throw InputError(fmt::format("{} = {} Hz: the rotor begins with {} Hz already",
                                   separation_speed, *speed, scenario.start_speed_Hz));
    Interruptible monitor;
    const auto until = number(statement, "until");
    const SpeedReached reached = run_ups.time_at_speed(scenario, *speed, until, monitor);
    if (is_interrupted()) throw Interrupted();
    if (!reached.time_s)
      throw InputError(fmt::format(
          "{} = {} Hz: is not reached; until {:.6g} s{} the rotor has {:.6g} Hz at most",
          separation_speed, *speed, reached.looked_until_s,
          reached.touches ? ", when it touches the ring," : "", reached.greatest_Hz));
    p.separation_time = *reached.time_s;
    scenario.until = until.value_or(p.separation_time + default_rub_s);
  }
  check(scenario);
  return scenario;
}

void check_numbers(const Statement& statement) { check_numbers(numbers_of(statement)); }

std::span<const std::string_view> named_statables() {
  static constexpr std::array<std::string_view, 4> all = {"equations", "velocity_jump",
                                                          "gravity_moment", "method"};
  return all;
}

int parse_digits(double number) {
  if (!(number >= 1 && number <= most_digits && number == std::floor(number)))
    throw InputError(
        fmt::format("digits = {}: must be a whole number from 1 to {}", number, most_digits));
  return static_cast<int>(number);
}

void state(Statement& statement, std::string_view statable, std::string_view name) {
  if (statable == "equations")
    statement.equations = parse_equations(name);
  else if (statable == "velocity_jump")
    statement.velocity_jump = parse_velocity_jump(name);
  else if (statable == "gravity_moment")
    statement.gravity_moment = parse_gravity_moment(name);
  else
    statement.method = parse_method(name);
}

std::string option_of(std::string_view name) {
  std::string option = "--" + std::string(name);
  std::replace(option.begin(), option.end(), '_', '-');
  return option;
}

void state_number(Statement& statement, const Quantity& quantity, const std::string& text) {
  const auto value = number_in(text);
  if (!value || !quantity.allows(*value))
    throw InputError(fmt::format("{}: must be {}, not {}", option_of(quantity.name),
                                 quantity.range(), shown(text)));
  statement.numbers.insert_or_assign(std::string(quantity.name), *value);
}

}  // namespace rotor
