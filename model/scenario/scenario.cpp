#include "model/scenario/scenario.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

constexpr bool closed = true;
constexpr bool open = false;

/// A number of a scenario, or of its parameters.
template <auto Member>
double& in(Scenario& scenario) {
  if constexpr (requires { scenario.*Member; })
    return scenario.*Member;
  else
    return scenario.parameters.*Member;
}

constexpr std::array all_quantities = {
    Quantity{"mass", "m", "kg", "rotor mass", in<&Parameters::mass>, 0, open},
    Quantity{"inertia", "I_C", "kg m^2", "moment of inertia about the mass centre",
             in<&Parameters::inertia>, 0, open},
    Quantity{"eccentricity", "e_x", "m", "distance of the mass centre from the geometrical centre",
             in<&Parameters::eccentricity>, 0, closed},
    Quantity{"support_stiffness", "k", "N/m", "radial stiffness of the supports together",
             in<&Parameters::support_stiffness>, 0, closed},
    Quantity{"support_damping", "d", "N s/m", "radial damping of the supports together",
             in<&Parameters::support_damping>, 0, closed},
    Quantity{"gravity", "g", "m/s^2",
             "acceleration due to gravity (the ring is centred on the loaded position of rest)",
             in<&Parameters::gravity>, 0, closed},
    Quantity{"torque", "M_mot", "N m", "torque of the motor until it is switched off",
             in<&Parameters::torque>, 0, closed},
    Quantity{"motor_off_hz", "f_max", "Hz", "rotation speed at which the motor is switched off",
             in<&Parameters::motor_off_Hz>, 0, closed},
    Quantity{"contact_stiffness", "k_t", "N/m", "stiffness of the contact zone",
             in<&Parameters::contact_stiffness>, 0, open},
    Quantity{"contact_damping", "d_t", "N s/m", "damping of the contact zone",
             in<&Parameters::contact_damping>, 0, closed},
    Quantity{"contact_exponent", "n", "",
             "exponent of the contact's elastic force in the indentation; 1: linear, 1.5: Hertz",
             in<&Parameters::contact_exponent>, 1, closed, 3},
    Quantity{"reference_indentation", "Delta_0", "m",
             "indentation at which the elastic force is k_t Delta_0, unless contact_exponent is 1",
             in<&Parameters::reference_indentation>, 0, closed},
    Quantity{"friction", "mu", "", "coefficient of Coulomb friction between rotor and ring",
             in<&Parameters::friction>, 0, closed},
    Quantity{"rotor_radius", "r", "m", "radius of the rotor", in<&Parameters::rotor_radius>, 0,
             open},
    Quantity{"stator_radius", "r_a", "m", "radius of the stator's contact ring",
             in<&Parameters::stator_radius>, 0, open},
    Quantity{"unbalance_factor", "k_u", "", "factor by which the mass loss raises the eccentricity",
             in<&Parameters::unbalance_factor>, 1, closed},
    Quantity{"mass_loss_time", "t_1", "s", "instant of the mass loss",
             in<&Parameters::mass_loss_time>, 0, closed},
    Quantity{"start_speed_hz", "", "Hz",
             "speed at which the run starts, in steady response to the unbalance; 0: at rest",
             in<&Scenario::start_speed_Hz>, 0, closed},
    Quantity{"until", "", "s", "end of the run", in<&Scenario::until>, 0, open},
    Quantity{"tolerance", "", "", "event: error allowed in a step, relative to each phase's scale",
             in<&Scenario::tolerance>, 1e-15, closed, 1e-3},
    Quantity{"step_run_up", "h", "s", "rk4: step until the mass loss or the first contact",
             in<&Scenario::step_run_up>, 0, open},
    Quantity{"step_rub", "h", "s", "rk4: step from then on", in<&Scenario::step_rub>, 0, open},
};

template <class... Parts>
void require(bool fulfilled, fmt::format_string<const Parts&...> message, const Parts&... parts) {
  if (!fulfilled) throw std::invalid_argument(fmt::format(message, parts...));
}

}  // namespace

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
  return part;
}

std::span<const Quantity> quantities() { return all_quantities; }

std::string Quantity::text(const Scenario& scenario) const {
  return fmt::format("{} = {}{}{}", name, of(scenario), unit.empty() ? "" : " ", unit);
}

bool Quantity::allows(double value) const {
  return std::isfinite(value) && (least_allowed ? value >= least : value > least) &&
         value <= greatest;
}

std::string Quantity::range() const {
  if (std::isinf(least))
    return fmt::format("a finite number{}{}", unit.empty() ? "" : " of ", unit);
  return fmt::format("a finite number {} {}{}{}{}", least_allowed ? "not below" : "greater than",
                     least,
                     std::isfinite(greatest) ? fmt::format(" and not above {}", greatest) : "",
                     unit.empty() ? "" : " ", unit);
}

void check_numbers(const Scenario& scenario) {
  for (const Quantity& quantity : quantities()) {
    const double value = quantity.of(scenario);
    if (!quantity.allows(value))
      throw std::invalid_argument(
          fmt::format("{} = {}: must be {}", quantity.name, value, quantity.range()));
  }
  const Parameters& p = scenario.parameters;
  require(p.stator_radius > p.rotor_radius,
          "stator_radius = {} m and rotor_radius = {} m: the ring must be larger than the rotor",
          p.stator_radius, p.rotor_radius);
  require(p.eccentricity < p.rotor_radius,
          "eccentricity = {} m: must be smaller than rotor_radius = {} m", p.eccentricity,
          p.rotor_radius);
  require(p.contact_exponent == 1 || p.reference_indentation > 0,
          "contact_exponent = {} and reference_indentation = {} m: the indentation at which "
          "contact_stiffness holds must be greater than 0 m",
          p.contact_exponent, p.reference_indentation);
  if (scenario.method == Method::rk4) {
    constexpr double most_steps = 1e10;
    const auto require_few = [&](std::string_view name, double step) {
      require(scenario.until / step <= most_steps,
              "{} = {} s and until = {} s: there must be at most {} steps", name, step,
              scenario.until, most_steps);
    };
    require_few("step_run_up", scenario.step_run_up);
    require_few("step_rub", scenario.step_rub);
    require(scenario.step_run_up <= scenario.until,
            "step_run_up = {} s: must not be longer than the run, until = {} s",
            scenario.step_run_up, scenario.until);
  }
  require(p.drive == Drive::motor || scenario.start_speed_Hz > 0,
          "drive = constant_speed and start_speed_hz = {} Hz: the speed must be greater than 0",
          scenario.start_speed_Hz);
  if (scenario.start)
    require(
        std::hypot(scenario.start->x, scenario.start->y) < p.stator_radius,
        "start_x = {} m and start_y = {} m: must be nearer the centre than the ring's radius, {} m",
        scenario.start->x, scenario.start->y, p.stator_radius);
  const MassLoss<double> loss(p);
  require(
      !scenario.loses_mass() || loss.after.inertia > 0,
      "inertia = {} kg m^2: would be {:.6g} kg m^2 after the loss of {:.6g} kg at rotor_radius = "
      "{} m, and must be greater than 0 then; mass = {} kg, eccentricity = {} m, "
      "unbalance_factor = {}",
      p.inertia, loss.after.inertia, loss.lost_mass, p.rotor_radius, p.mass, p.eccentricity,
      p.unbalance_factor);
}

}  // namespace rotor
