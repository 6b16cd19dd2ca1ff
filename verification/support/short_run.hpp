/// A run with contacts that takes milliseconds.
#pragma once

#include "model/digits/digits.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

inline const ShouldContinue always = [](double /*time_s*/) { return true; };

/// From steady motion through the mass loss into contact, and out of it.
inline Scenario short_run(double until_s) {
  Scenario scenario{.equations = Equations::published, .start_speed_Hz = 150.5, .until = until_s};
  scenario.parameters.mass_loss_time = 1e-3;
  scenario.parameters.motor_off_Hz = 151;
  return scenario;
}

}  // namespace rotor
