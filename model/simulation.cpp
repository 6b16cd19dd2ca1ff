#include "model/simulation.hpp"

#include <stdexcept>

#include "model/event_method.hpp"
#include "model/published_method.hpp"

namespace rotor {
Instant start(const Scenario& scenario) { return {.body = Body<double>::of(scenario.parameters)}; }

Instant run_up(const Scenario& scenario, const Instant& from, double until_s, Observer& observer,
               Work& work) {
  switch (scenario.method) {
    case Method::event:
      return EventMethod<double>(scenario, scenario.tolerance, observer, work)
          .run_up(from, until_s);
    case Method::rk4:
      return PublishedMethod(scenario, observer, work).run_up(from, until_s);
  }
  throw std::invalid_argument("unknown method");
}

Instant run(const Scenario& scenario, const Instant& from, Observer& observer, Work& work) {
  switch (scenario.method) {
    case Method::event: {
      EventMethod<double> method(scenario, scenario.tolerance, observer, work);
      return run_by(method, observer, scenario, from);
    }
    case Method::rk4: {
      PublishedMethod method(scenario, observer, work);
      return run_by(method, observer, scenario, from);
    }
  }
  throw std::invalid_argument("unknown method");
}

Scenario run_up_part(const Scenario& scenario) {
  const Scenario standard;
  Scenario part = scenario;
  part.parameters.contact_stiffness = standard.parameters.contact_stiffness;
  part.parameters.contact_damping = standard.parameters.contact_damping;
  part.parameters.friction = standard.parameters.friction;
  part.parameters.unbalance_factor = standard.parameters.unbalance_factor;
  part.parameters.separation_time = standard.parameters.separation_time;
  part.parameters.separates = standard.parameters.separates;
  part.until = standard.until;
  part.step_rub = standard.step_rub;
  return part;
}

double run_up_end(const Scenario& scenario) {
  return scenario.loses_mass() ? scenario.parameters.separation_time : scenario.until;
}

}  // namespace rotor
