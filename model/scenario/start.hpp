/// Where a scenario starts.
#pragma once

#include <stdexcept>

#include "model/phases/rotor_system.hpp"
#include "model/scenario/instant.hpp"
#include "model/scenario/scenario.hpp"

namespace rotor {

/// At rest, or in the steady response to the unbalance at the scenario's start speed. Throws
/// std::invalid_argument if the rotor would touch the ring in it.
template <class S = double>
BasicInstant<S> start_of(const Scenario& scenario) {
  BasicInstant<S> start = at_rest<S>(scenario.parameters);
  if (scenario.start_speed_Hz == 0) return start;
  const S speed = RotorSystem<S>::radians_per_turn() * stated<S>(scenario.start_speed_Hz);
  const Supports<S> supports(scenario.parameters, scenario.equations);
  const Vector<S> centre =
      supports.unbalance_response(start.body, speed) - Vector<S>(start.body.eccentricity, S(0));
  if (!(centre.norm() < Ring<S>(scenario.parameters).clearance))
    throw std::invalid_argument(
        "start_speed_hz: the rotor would touch the ring in the steady response at that speed");
  start.state = {centre.x(), centre.y(), S(0), S(0), S(0), speed};
  start.motor_on = scenario.start_speed_Hz < scenario.parameters.motor_off_Hz;
  return start;
}

/// Throws std::invalid_argument if the scenario's numbers or its start are not physical.
inline void check(const Scenario& scenario) {
  check_numbers(scenario);
  static_cast<void>(start_of(scenario));
}

}  // namespace rotor
