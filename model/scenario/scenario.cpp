#include "model/scenario/scenario.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

/// A number of a scenario, or of its parameters.
template <auto Member>
double& in(Scenario& scenario) {
  if constexpr (requires { scenario.*Member; })
    return scenario.*Member;
  else
    return scenario.parameters.*Member;
}

constexpr std::array all_quantities = {
    Quantity{"mass", "m", "kg", "rotor mass", in<&Parameters::mass>, least_positive},
    Quantity{"inertia", "I_C", "kg m^2", "moment of inertia about the mass centre",
             in<&Parameters::inertia>, least_positive},
    Quantity{"eccentricity", "e_x", "m", "distance of the mass centre from the geometrical centre",
             in<&Parameters::eccentricity>, 0},
    Quantity{"support_stiffness", "k", "N/m", "radial stiffness of the supports together",
             in<&Parameters::support_stiffness>, 0},
    Quantity{"support_damping", "d", "N s/m", "radial damping of the supports together",
             in<&Parameters::support_damping>, 0},
    Quantity{"gravity", "g", "m/s^2",
             "acceleration due to gravity (the position of rest is the loaded one)",
             in<&Parameters::gravity>, 0, greatest_speed},
    Quantity{"torque", "M_mot", "N m", "torque of the motor until it is switched off",
             in<&Parameters::torque>, 0},
    Quantity{"motor_off_Hz", "f_max", "Hz", "rotation speed at which the motor is switched off",
             in<&Parameters::motor_off_Hz>, 0, greatest_speed},
    Quantity{"contact_stiffness", "k_t", "N/m", "stiffness of the contact zone",
             in<&Parameters::contact_stiffness>, least_positive},
    Quantity{"contact_damping", "d_t", "N s/m", "damping of the contact zone",
             in<&Parameters::contact_damping>, 0},
    Quantity{"contact_exponent", "n", "",
             "exponent of the contact's elastic force in the indentation; 1: linear, 1.5: Hertz",
             in<&Parameters::contact_exponent>, 1, 3},
    Quantity{"reference_indentation", "Delta_0", "m",
             "indentation at which the elastic force is k_t Delta_0, unless contact_exponent is 1",
             in<&Parameters::reference_indentation>, 0},
    Quantity{"friction", "mu", "", "coefficient of Coulomb friction between rotor and ring",
             in<&Parameters::friction>, 0},
    Quantity{"rotor_radius", "r", "m", "radius of the rotor", in<&Parameters::rotor_radius>,
             least_positive},
    Quantity{"stator_radius", "r_a", "m", "radius of the stator's contact ring",
             in<&Parameters::stator_radius>, least_positive},
    Quantity{"ring_offset_x", "", "m",
             "centre of the ring from the position of rest, down; -m g/k: from the unloaded one",
             in<&Parameters::ring_offset_x>, -greatest_number},
    Quantity{"ring_offset_y", "", "m", "the same to the side", in<&Parameters::ring_offset_y>,
             -greatest_number},
    Quantity{"unbalance_factor", "k_u", "", "factor by which the mass loss raises the eccentricity",
             in<&Parameters::unbalance_factor>, 1},
    Quantity{"mass_loss_time", "t_1", "s", "instant of the mass loss",
             in<&Parameters::mass_loss_time>, 0},
    Quantity{"start_speed_Hz", "", "Hz",
             "speed at which the run starts, in steady response to the unbalance; 0: at rest",
             in<&Scenario::start_speed_Hz>, 0, greatest_speed},
    Quantity{"until", "", "s", "end of the run", in<&Scenario::until>, least_positive},
    Quantity{"tolerance", "", "", "event: error allowed in a step, relative to each phase's scale",
             in<&Scenario::tolerance>, 1e-15, 1e-3},
    Quantity{"step_run_up", "h", "s", "rk4: step until the mass loss or the first contact",
             in<&Scenario::step_run_up>, least_positive},
    Quantity{"step_rub", "h", "s", "rk4: step from then on", in<&Scenario::step_rub>,
             least_positive},
};

}  // namespace

void Parameters::state_clearance(double clearance_m) {
  clearance.number_ = clearance_m;
  stator_radius = rotor_radius + clearance_m;
}

std::optional<double> Parameters::stated_clearance() const {
  const auto& stated = clearance.number_;
  return stated && stator_radius == rotor_radius + *stated ? stated : std::nullopt;
}

void Parameters::state_lost_mass(double lost_mass_kg) {
  if (!(lost_mass_kg < mass))
    throw ScenarioError({Mention{"lost_mass", fmt::format("{} kg", lost_mass_kg)},
                         ": must be less than ", Mention{"mass", fmt::format("{} kg", mass)}});
  lost_mass.number_ = lost_mass_kg;
  unbalance_factor = MassLoss<double>::unbalance_factor(*this, lost_mass_kg);
}

std::optional<double> Parameters::stated_lost_mass() const {
  const auto& stated = lost_mass.number_;
  return stated && unbalance_factor == MassLoss<double>::unbalance_factor(*this, *stated)
             ? stated
             : std::nullopt;
}

void Scenario::state_mass_loss_speed(double speed_Hz, double time_s) {
  mass_loss_speed_Hz.number_ = speed_Hz;
  time_at_that_speed_s.number_ = parameters.mass_loss_time = time_s;
}

std::optional<double> Scenario::stated_mass_loss_speed_Hz() const {
  return time_at_that_speed_s.number_ == parameters.mass_loss_time ? mass_loss_speed_Hz.number_
                                                                   : std::nullopt;
}

std::string shortest_decimal(double number) { return fmt::format("{}", number); }

Scenario run_up_part(const Scenario& scenario) {
  const Scenario standard;
  Scenario part = scenario;
  using P = Parameters;
  for (double P::*const later :
       {&P::contact_stiffness, &P::contact_damping, &P::contact_exponent, &P::reference_indentation,
        &P::friction, &P::unbalance_factor, &P::mass_loss_time})
    part.parameters.*later = standard.parameters.*later;
  part.parameters.lost_mass = standard.parameters.lost_mass;
  part.parameters.loses_mass = standard.parameters.loses_mass;
  part.equations.velocity_jump = standard.equations.velocity_jump;
  part.until = standard.until;
  part.step_rub = standard.step_rub;
  part.mass_loss_speed_Hz = standard.mass_loss_speed_Hz;
  part.time_at_that_speed_s = standard.time_at_that_speed_s;
  return part;
}

std::span<const Quantity> quantities() { return all_quantities; }

Mention Quantity::with(double value) const {
  return {std::string(name), fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit)};
}

Mention mention_of(const Scenario& scenario, std::string_view name) {
  for (const Quantity& quantity : quantities())
    if (quantity.name == name) return quantity.with(quantity.of(scenario));
  throw std::logic_error(fmt::format("there is no quantity {}", name));
}

bool Quantity::allows(double value) const {
  const bool is_tiny = least == 0 && value > 0 && value < least_positive;
  return value >= least && value <= greatest && !is_tiny;
}

std::string Quantity::range() const {
  return fmt::format("{}a number from {} to {}{}{}", least == 0 ? "0 or " : "",
                     least == 0 ? least_positive : least, greatest, unit.empty() ? "" : " ", unit);
}

void check_numbers(const Scenario& scenario) {
  const auto the = [&](std::string_view name) { return mention_of(scenario, name); };
  for (const Quantity& quantity : quantities())
    if (!quantity.allows(quantity.of(scenario)))
      throw ScenarioError({the(quantity.name), ": must be " + quantity.range()});
  const Parameters& p = scenario.parameters;
  if (!(p.stator_radius > p.rotor_radius))
    throw ScenarioError({the("stator_radius"), " and ", the("rotor_radius"),
                         ": the ring must be larger than the rotor"});
  if (!(p.eccentricity < p.rotor_radius))
    throw ScenarioError({the("eccentricity"), ": must be smaller than ", the("rotor_radius")});
  if (scenario.equations.gravity_moment == GravityMoment::whole &&
      (p.ring_offset_x != 0 || p.ring_offset_y != 0))
    throw ScenarioError({the(p.ring_offset_x != 0 ? "ring_offset_x" : "ring_offset_y"), " and ",
                         Mention{"gravity_moment", "whole"},
                         ": as printed, the weight's moment is about the centre of the ring, which "
                         "must be the position of rest; state balanced, or corrected equations"});
  if (p.contact_exponent != 1 && !(p.reference_indentation > 0))
    throw ScenarioError({the("contact_exponent"), " and ", the("reference_indentation"),
                         ": the indentation at which contact_stiffness holds must be greater than "
                         "0 m"});
  if (scenario.method == Method::rk4) {
    constexpr double most_steps = 1e10;
    const auto require_few = [&](std::string_view name, double step) {
      if (!(scenario.until / step <= most_steps))
        throw ScenarioError({the(name), " and ", the("until"),
                             fmt::format(": there must be at most {} steps", most_steps)});
    };
    require_few("step_run_up", scenario.step_run_up);
    require_few("step_rub", scenario.step_rub);
    if (!(scenario.step_run_up <= scenario.until))
      throw ScenarioError(
          {the("step_run_up"), ": must not be longer than the run, ", the("until")});
  }
  if (p.drive == Drive::constant_speed && !(scenario.start_speed_Hz > 0))
    throw ScenarioError({Mention{"drive", "constant_speed"}, " and ", the("start_speed_Hz"),
                         ": the speed must be greater than 0"});
  if (const auto& start = scenario.start;
      start && !(std::hypot(start->x, start->y) < p.stator_radius))
    throw ScenarioError(
        {Mention{"start_x", fmt::format("{} m", start->x)}, " and ",
         Mention{"start_y", fmt::format("{} m", start->y)},
         fmt::format(": must be nearer the centre than the ring's radius, {} m", p.stator_radius)});
  const MassLoss<double> loss(p);
  if (scenario.loses_mass() && !(loss.after.mass > 0))
    throw ScenarioError({the("unbalance_factor"), ": no mass would be left of ", the("mass")});
  if (scenario.loses_mass() && !(loss.after.inertia > 0))
    throw ScenarioError({the("inertia"),
                         fmt::format(": would be {:.6g} kg m^2 after the loss of {:.6g} kg at ",
                                     loss.after.inertia, loss.lost_mass),
                         the("rotor_radius"), ", and must be greater than 0 then; ", the("mass"),
                         ", ", the("eccentricity"), ", ", the("unbalance_factor")});
}

}  // namespace rotor
