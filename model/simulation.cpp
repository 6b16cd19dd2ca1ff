#include "model/simulation.hpp"

#include "model/mass_loss.hpp"
#include "model/published_method.hpp"

namespace rotor {
namespace {

Instant separate(const Scenario& scenario, Instant at) {
  const MassLoss<double> loss(scenario.parameters);
  at.state = loss.separate(at.state, scenario.equations);
  at.body = loss.after;
  at.separated = true;
  return at;
}

}  // namespace

Instant start(const Scenario& scenario) { return {.body = Body<double>::of(scenario.parameters)}; }

Instant run_up(const Scenario& scenario, const Instant& from, double until_s,
               const Observer& observer, Work& work) {
  return PublishedMethod(scenario, observer, work).run_up(from, until_s);
}

Instant run(const Scenario& scenario, const Instant& from, const Observer& observer, Work& work) {
  PublishedMethod method(scenario, observer, work);
  Instant at = from;
  if (!at.separated) {
    const double end = run_up_end(scenario);
    at = method.rub(method.run_up(at, end), end);
    if (!scenario.loses_mass()) return at;
    at = separate(scenario, at);
    observer(at);
  }
  return method.rub(at, scenario.until);
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
