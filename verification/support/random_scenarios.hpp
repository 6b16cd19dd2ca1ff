/// Random rotors and mass losses, most parameters uniform in their logarithm over decades.
#pragma once

#include <cmath>
#include <random>

#include "model/mechanics/mass_loss.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

class RandomScenarios {
 public:
  explicit RandomScenarios(unsigned seed) : random_(seed) {}

  /// A rotor that has just lost its mass.
  Scenario scenario() {
    Scenario scenario;
    Parameters& p = scenario.parameters;
    do {
      draw(p);
    } while (MassLoss<double>(p).after.inertia <= 0);  // as any input is checked
    p.loses_mass = false;                              // the runs start just after it
    scenario.equations = one_in(2) ? Equations::published : Equations::consistent;
    scenario.tolerance = 1e-9;
    return scenario;
  }

  /// Of such a rotor, rad/s.
  double speed() { return one_in(20) ? 0 : two_pi * between(0.1, 1000) * (one_in(10) ? -1 : 1); }

 private:
  void draw(Parameters& p) {
    p.rotor_radius = between(0.01, 1);
    p.mass = between(0.1, 1000);
    p.inertia = p.mass * p.rotor_radius * p.rotor_radius * between(0.1, 2);
    p.contact_stiffness = between(1e5, 1e13);
    p.contact_damping = one_in(3) ? 0 : between(1, 1e7);
    p.friction = one_in(3) ? 0 : between(1e-3, 10);
    p.stator_radius = p.rotor_radius + between(1e-6, 1e-2);
    p.eccentricity = one_in(10) ? 0 : between(1e-7, 1e-3);
    p.unbalance_factor = between(1, 5);
    p.support_stiffness = between(1e3, 1e7);
    p.support_damping = one_in(10) ? 0 : between(1, 1e3);
    p.gravity = one_in(4) ? 0 : 9.81;
    p.torque = one_in(2) ? 0 : between(0.01, 10);
    p.motor_off_Hz = between(1, 1000);
  }

  double between(double least, double greatest) {
    return least * std::pow(greatest / least, std::uniform_real_distribution<double>()(random_));
  }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }

  std::mt19937_64 random_;
};

}  // namespace rotor
