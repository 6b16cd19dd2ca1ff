/// Random whole runs: from steady motion through the mass loss to the end of the contacts, or of a
/// limited time.
#pragma once

#include <stdexcept>

#include "model/run/simulation.hpp"
#include "model/scenario/instant.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/random_scenarios.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {

class RandomRuns {
 public:
  explicit RandomRuns(unsigned seed) : rotors_(seed), random_(seed + 1) {}

  /// A run that takes about a second in quadruple precision. A quarter is near the paper's
  /// rotor, a quarter is near it but has enough friction to stick, a quarter just grazes or misses
  /// the ring, and a quarter is arbitrary.
  Scenario scenario() {
    constexpr long most_steps = 300, most_events = 16;
    for (;; ++kind_) {
      try {
        const Scenario drawn = draw();
        check(drawn);
        EventRecorder recorder;
        const RunEnd end = run(drawn, recorder);
        const bool touches = recorder.count(Event::touch_down) > 0;
        if (end.counters.steps > most_steps || end.counters.located_events > most_events) continue;
        if (!touches && kind_ % 4 != 1 && between(0, 8) > 1) continue;
        ++kind_;
        return drawn;
      } catch (const std::exception&) {  // no valid start
      }
    }
  }

 private:
  Scenario draw() {
    Scenario drawn = rotors_.scenario();
    Parameters& p = drawn.parameters;
    const bool sticks = kind_ % 4 == 3, is_ours = kind_ % 4 == 0 || sticks;
    if (is_ours) {
      const auto varied = [&](double& value) { value *= between(0.8, 1.25); };
      p = Parameters{};
      for (double* of : {&p.mass, &p.inertia, &p.eccentricity, &p.support_stiffness, &p.torque,
                         &p.contact_stiffness, &p.contact_damping})
        varied(*of);
      p.friction = sticks ? between(0.5, 3) : between(0.02, 0.4);
    }
    p.loses_mass = true;
    p.mass_loss_time = between(1e-3, 1e-2);
    drawn.start_speed_Hz = is_ours ? between(40, 200) : between(5, 300);
    if (between(0, 4) < 1) p.motor_off_Hz = drawn.start_speed_Hz * (1 + between(1e-6, 1e-3));
    drawn.until = p.mass_loss_time + between(2e-3, sticks ? 2e-2 : 5e-2);
    if (kind_ % 4 == 1) {  // the clearance is about what the rotor reaches after its loss
      Scenario wide = drawn;
      wide.parameters.stator_radius = 100 * p.stator_radius;
      const double furthest = summary_of(wide).max_displacement_m.value_or(0);
      const double off = std::pow(10, -between(2, 10)) * (between(0, 2) < 1 ? 1 : -1);
      p.stator_radius = p.rotor_radius + furthest * (1 + off);
    }
    return drawn;
  }

  double between(double least, double greatest) {
    return std::uniform_real_distribution<double>(least, greatest)(random_);
  }

  RandomScenarios rotors_;
  std::mt19937_64 random_;
  unsigned kind_ = 0;
};

}  // namespace rotor
