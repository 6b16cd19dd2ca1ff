/// Random whole runs, most of them with contact.
#pragma once

#include "verification/support/observers.hpp"
#include "verification/support/random_inputs.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {

/// A rotor at a constant speed on undamped supports that starts near the centre, for up to three
/// turns: near the centre the direction of O turns at any rate.
inline RandomInputs::Rotor drifting_rotor(RandomInputs& inputs) {
  ScenarioSpec fixed;
  fixed.loses_mass = false;
  fixed.equations = Equations::corrected;
  fixed.method = Method::event;
  fixed.drive = Drive::constant_speed;
  fixed.numbers["support_damping"] = 0;
  const auto [drawn, scenario] = inputs.rotor(1, fixed);
  const double clearance = Ring<double>(scenario.parameters).clearance,
               turn_s = 1 / std::max(scenario.start_speed_Hz, 1.);
  const auto signed_between = [&](double least, double greatest) {
    return inputs.between(least, greatest) * (inputs.one_in(2) ? 1 : -1);
  };
  ScenarioSpec start;
  for (const char* of_O : {"start_x", "start_y"})
    start.numbers[of_O] = signed_between(1e-4, 0.1) * clearance;
  for (const char* of_O : {"start_velocity_x", "start_velocity_y"})
    start.numbers[of_O] = signed_between(1e-3, 6) * clearance / turn_s;
  start.numbers["until"] = inputs.between(0.05, 3) * turn_s;
  const ScenarioSpec stated = drawn.overridden_by(start);
  return {stated, scenario_of(stated)};
}

class RandomRuns {
 public:
  /// Runs that take at most so many steps and events.
  explicit RandomRuns(unsigned seed, const ScenarioSpec& fixed = {}, long most_steps = 20'000,
                      long most_events = 400)
      : inputs_(seed), fixed_(fixed), most_steps_(most_steps), most_events_(most_events) {}

  /// Every second one is near the paper's, and every fourth one just grazes or misses the ring.
  RandomInputs::Rotor rotor() {
    for (;; ++kind_) {
      RandomInputs::Rotor drawn = inputs_.rotor(kind_ % 2 == 0 ? 0.3 : 1, fixed_);
      if (kind_ % 4 == 3) graze(drawn);
      Scenario scenario = drawn.scenario;
      scenario.method = Method::event;
      // Fixed steps take as many more as they are shorter than the contact's period.
      if (drawn.scenario.method == Method::rk4 &&
          scenario.until / std::min(scenario.step_rub, scenario.step_run_up) >
              static_cast<double>(most_steps_))
        continue;
      Limited limited(most_steps_);
      try {
        const RunEnd end = run(scenario, limited);
        if (end.stopped || end.counters.located_events > most_events_) continue;
        if (limited.count(Event::touch_down) == 0 && !inputs_.one_in(8)) continue;
      } catch (const std::runtime_error&) {  // the test runs it again, and reports it
      }
      ++kind_;
      return drawn;
    }
  }
  Scenario scenario() { return rotor().scenario; }

 private:
  struct Limited : EventRecorder {
    explicit Limited(long most_steps) : left(most_steps) {}
    bool should_continue(const Progress& /*now*/) override { return --left >= 0; }
    long left;
  };

  /// Makes the clearance about what the rotor reaches.
  void graze(RandomInputs::Rotor& drawn) {
    Scenario wide = drawn.scenario;
    wide.parameters.stator_radius += 100 * wide.parameters.rotor_radius;
    wide.method = Method::event;
    const double furthest = summary_of(wide).peak_displacement_m.value_or(0),
                 off = inputs_.between(1e-10, 1e-2) * (inputs_.one_in(2) ? 1 : -1);
    ScenarioSpec clearance;
    clearance.numbers["clearance"] = furthest * (1 + off);
    try {
      const ScenarioSpec stated = drawn.stated.overridden_by(clearance);
      drawn = {stated, scenario_of(stated)};
    } catch (const std::exception&) {  // would touch at the start
    }
  }

  RandomInputs inputs_;
  ScenarioSpec fixed_;
  long most_steps_, most_events_;
  unsigned kind_ = 0;
};

}  // namespace rotor
