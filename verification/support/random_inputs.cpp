#include "verification/support/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

/// What has been drawn so far.
using Numbers = decltype(ScenarioSpec::numbers);

double of(const Numbers& drawn, std::string_view name) { return drawn.find(name)->second; }

/// Units of ranges.
double one(const Numbers& /*drawn*/) { return 1; }
double speed_Hz(const Numbers& drawn) {
  const auto in_Hz = drawn.find("start_speed_Hz");
  const double speed = in_Hz != drawn.end() ? in_Hz->second : of(drawn, "start_speed_rpm") / 60;
  return speed > 0 ? speed : 30;
}
double speed_rpm(const Numbers& drawn) { return 60 * speed_Hz(drawn); }
double mass(const Numbers& drawn) { return of(drawn, "mass"); }
double radius(const Numbers& drawn) { return of(drawn, "rotor_radius"); }
double clearance(const Numbers& drawn) {
  const auto stated = drawn.find("clearance");
  return stated != drawn.end() ? stated->second : of(drawn, "stator_radius") - radius(drawn);
}
/// The speed of a point at the clearance that turns with the rotor, m/s.
double start_velocity(const Numbers& drawn) { return two_pi * speed_Hz(drawn) * clearance(drawn); }
/// The period of the rotor on the ring, s.
double contact_period(const Numbers& drawn) {
  return two_pi * std::sqrt(mass(drawn) / of(drawn, "contact_stiffness"));
}

/// A range, in units that may depend on the rows above it; in one draw of so many, a value that is
/// a case of its own, in the same units. Inputs that may be negative are so in every second draw.
struct NumberRange {
  std::string_view name;
  double least, greatest;
  int special_once_in = 0;  ///< 0: never
  double special = 0;
  double (*unit)(const Numbers& drawn) = one;
};

/// The paper's rotor is near the middle of most of them.
const std::vector<NumberRange> number_ranges = {
    {"mass", 0.1, 250},
    {"rotor_radius", 0.006, 0.6},
    {"inertia", 0.1, 2, 0, 0,
     [](const Numbers& drawn) { return mass(drawn) * std::pow(radius(drawn), 2); }},
    {"stator_radius", 1.001, 1.2, 0, 0, radius},
    {"clearance", 1e-3, 0.2, 0, 0, radius},
    {"ring_offset_x", 0.01, 1.01, 2, 0, clearance},  // rests over it
    {"ring_offset_y", 0.01, 1.01, 2, 0, clearance},
    {"eccentricity", 0.01, 1, 10, 0, clearance},
    {"support_stiffness", 1e2, 4e6, 20, 0},
    {"support_damping", 0.6, 1e3, 10, 0},
    {"gravity", 1, 100, 4, 0},
    {"torque", 0.01, 10, 2, 0},
    {"start_speed_Hz", 10, 1e3, 10, 0},
    {"start_speed_rpm", 600, 6e4, 10, 0},
    {"start_x", 0.01, 1.01, 3, 1.003, clearance},  // over the ring
    {"start_y", 0.01, 1.01, 0, 0, clearance},
    {"start_velocity_x", 0.01, 1, 0, 0, start_velocity},
    {"start_velocity_y", 0.01, 1, 0, 0, start_velocity},
    {"motor_off_Hz", 0.3, 3, 4, 1 + 1e-4, speed_Hz},
    {"motor_off_rpm", 0.3, 3, 4, 1 + 1e-4, speed_rpm},
    {"contact_stiffness", 1e6, 1e12},
    {"contact_damping", 1e-3, 10, 3, 0,
     [](const Numbers& drawn) { return std::sqrt(of(drawn, "contact_stiffness") * mass(drawn)); }},
    {"contact_exponent", 1, 3, 2, 1},
    {"reference_indentation", 1e-4, 1, 4, 0, clearance},
    {"friction", 0.01, 10, 4, 0},
    {"unbalance_factor", 1, 9},
    {"lost_mass", 1e-4, 0.1, 10, 0, mass},
    {"mass_loss_time", 1e-3, 0.1, 3, 0},
    {"mass_loss_speed_Hz", 1 + 1e-5, 1.1, 4, 1, speed_Hz},
    {"mass_loss_speed_rpm", 1 + 1e-5, 1.1, 4, 1, speed_rpm},
    {"until", 0.01, 0.5},
    {"tolerance", 1e-12, 1e-9},
    {"step_run_up", 1e-3, 0.03, 0, 0, contact_period},
    {"step_rub", 1e-3, 0.03, 0, 0, contact_period},
};

struct NameRange {
  std::string_view name;
  std::vector<std::string_view> values;
};

const std::vector<NameRange> name_ranges = {
    {"equations", {"published", "corrected"}},
    {"velocity_jump", all_names<VelocityJump>()},
    {"gravity_moment", all_names<GravityMoment>()},
    {"method", all_names<Method>()},
    {"drive", all_names<Drive>()},
};

bool has_range(std::string_view name) {
  const auto is_its = [&](const auto& row) { return row.name == name; };
  return std::ranges::any_of(number_ranges, is_its) || std::ranges::any_of(name_ranges, is_its);
}

}  // namespace

double RandomInputs::between(double least, double greatest) {
  return least * std::pow(greatest / least, std::uniform_real_distribution<double>()(random_));
}

ScenarioSpec RandomInputs::spec(double part) {
  ScenarioSpec spec;
  for (const NumberRange& row : number_ranges) {
    const std::string_view number = determined_by(row.name);
    const auto determines_it = [&](const NumberRange& other) {
      return determined_by(other.name) == number;
    };
    // The first of several rows is drawn for all of them.
    if (&row != &*std::ranges::find_if(number_ranges, determines_it)) continue;
    std::vector<const NumberRange*> rows;
    for (const NumberRange& other : number_ranges)
      if (determines_it(other)) rows.push_back(&other);
    const NumberRange& drawn = *rows[below(rows.size())];
    const double reach = std::pow(drawn.greatest / drawn.least, part / 2),
                 middle = std::sqrt(drawn.least * drawn.greatest);
    const bool is_special = drawn.special_once_in > 0 && one_in(drawn.special_once_in),
               is_negative = find_input_quantity(drawn.name)->quantity.allows(-1) && one_in(2);
    spec.numbers.emplace(drawn.name,
                         (is_special ? drawn.special : between(middle / reach, middle * reach)) *
                             drawn.unit(spec.numbers) * (is_negative ? -1 : 1));
  }
  for (const NameRange& row : name_ranges)
    if (one_in(2)) find_named_input(row.name)->state(spec, row.values[below(row.values.size())]);
  if (!one_in(4))
    std::erase_if(spec.numbers, [](const auto& number) {
      return find_input_quantity(number.first)->of_start != nullptr;
    });
  if (spec.drive == Drive::constant_speed)
    for (const char* run_up : {"mass_loss_speed_Hz", "mass_loss_speed_rpm"})
      spec.numbers.erase(run_up);
  if (equations_of(spec).gravity_moment == GravityMoment::whole)
    for (const char* offset : {"ring_offset_x", "ring_offset_y"}) spec.numbers.erase(offset);
  if (one_in(10)) {
    std::erase_if(spec.numbers, [](const auto& number) {
      return determined_by(number.first) == "mass_loss_time";
    });
    spec.loses_mass = false;
  }
  return spec;
}

RandomInputs::Rotor RandomInputs::rotor(double part, const ScenarioSpec& fixed) {
  for (const std::string& name : varied_inputs())
    if (!has_range(name))
      throw std::logic_error(name + ": has no range in verification/support/random_inputs.cpp");
  for (const NumberRange& row : number_ranges)
    if (!find_input_quantity(row.name))
      throw std::logic_error(std::string(row.name) + ": no input");
  for (;;) {
    const ScenarioSpec stated = spec(part).overridden_by(fixed);
    try {
      const Scenario scenario = scenario_of(stated);
      // Tests may let it lose its mass though the run ends before that.
      if (MassLoss<double>(scenario.parameters).after.inertia > 0) return {stated, scenario};
    } catch (const ScenarioError&) {  // not physical, or it does not reach its speed
    }
  }
}

std::string options_of(const ScenarioSpec& spec) {
  std::vector<std::string> options;
  const auto add = [&](std::string_view name, const auto& value) {
    options.push_back(fmt::format("{} {}", option_of(name), value));
  };
  for (const auto& [name, value] : spec.numbers) add(name, value);
  if (spec.loses_mass == false) options.emplace_back("--no-mass-loss");
  if (spec.equations) add("equations", name_of(*spec.equations));
  if (spec.velocity_jump) add("velocity_jump", name_of(*spec.velocity_jump));
  if (spec.gravity_moment) add("gravity_moment", name_of(*spec.gravity_moment));
  if (spec.method) add("method", name_of(*spec.method));
  if (spec.drive) add("drive", name_of(*spec.drive));
  return fmt::format("{}", fmt::join(options, " "));
}

}  // namespace rotor
