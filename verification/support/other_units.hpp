/// Other units, by powers of two, so that all numbers are scaled without rounding. The units make
/// all forces tiny numbers, so that any comparison with a fixed number would show.
#pragma once

#include "model/scenario/scenario.hpp"

namespace rotor {

constexpr double metre = 4, second = 0x1p-20, kilogram = 0x1p-80;
constexpr double newton = kilogram * metre / (second * second);

inline Parameters in_other_units(Parameters p) {
  p.mass *= kilogram;
  p.inertia *= kilogram * metre * metre;
  p.eccentricity *= metre;
  p.support_stiffness *= newton / metre;
  p.support_damping *= newton * second / metre;
  p.gravity *= metre / (second * second);
  p.contact_stiffness *= newton / metre;
  p.contact_damping *= newton * second / metre;
  p.reference_indentation *= metre;
  p.rotor_radius *= metre;
  p.stator_radius *= metre;
  p.motor_off_Hz /= second;
  p.torque *= newton * metre;
  p.mass_loss_time *= second;
  return p;
}

inline Scenario in_other_units(Scenario scenario) {
  scenario.parameters = in_other_units(scenario.parameters);
  scenario.start_speed_Hz /= second;
  scenario.until *= second;
  return scenario;
}

inline State<double> in_other_units(const State<double>& q) {
  return {q[0] * metre,          q[1] * metre,          q[2],
          q[3] * metre / second, q[4] * metre / second, q[5] / second};
}

}  // namespace rotor
