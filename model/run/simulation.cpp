#include "model/run/simulation.hpp"

#include <variant>

#include "model/methods/event_method.hpp"
#include "model/methods/published_method.hpp"
#include "model/methods/whole_run.hpp"
#include "model/results/summary.hpp"

namespace rotor {

template class SynchronousMotion<double>;
template class FlightChart<double>;
template class EventMethod<double>;
template class BasicOutcomeWatch<double>;
template class BasicSummaryObserver<double>;

namespace {

using AnyMethod = std::variant<EventMethod<double>, PublishedMethod>;

AnyMethod method_of(const Scenario& scenario, const Instant& from) {
  if (scenario.method == Method::rk4) return PublishedMethod(scenario, from);
  return EventMethod<double>(scenario, scenario.tolerance, from);
}

}  // namespace

struct Simulation::State {
  Scenario scenario;
  AnyMethod method;

  template <class Action>
  decltype(auto) visit(const Action& action) {
    return std::visit(action, method);
  }
};

Simulation::Simulation(const Scenario& scenario) : Simulation(scenario, start_of(scenario)) {}
Simulation::Simulation(const Scenario& scenario, const Instant& from)
    : state_(new State{scenario, method_of(scenario, from)}) {}
Simulation::Simulation(const Simulation& other) : state_(new State(*other.state_)) {}
Simulation::Simulation(Simulation&& other) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::run_up(double until_s, Observer& observer) {
  state_->visit([&](auto& method) { method.run_up(until_s, observer); });
}

void Simulation::run_to_end(Observer& observer) {
  const MassLoss<double> loss(state_->scenario.parameters);
  state_->visit([&](auto& method) { rotor::run_to_end(method, state_->scenario, loss, observer); });
}

Simulation Simulation::branch(const Scenario& scenario) const {
  Simulation other = *this;
  other.state_->scenario = scenario;
  other.state_->method =
      state_->visit([&](auto& method) -> AnyMethod { return method.branch(scenario); });
  return other;
}

const Instant& Simulation::instant() const {
  return state_->visit([](auto& method) -> const Instant& { return method.instant(); });
}

const Counters& Simulation::counters() const {
  return state_->visit([](auto& method) -> const Counters& { return method.counters(); });
}

bool Simulation::stopped() const {
  return state_->visit([](auto& method) { return method.stopped(); });
}

RunEnd run(const Scenario& scenario, Observer& observer) {
  return run(scenario, start_of(scenario), observer);
}

RunEnd run(const Scenario& scenario, const Instant& from, Observer& observer) {
  Simulation simulation(scenario, from);
  observer.on_instant(simulation.instant());
  simulation.run_to_end(observer);
  return {simulation.instant(), simulation.counters(), simulation.stopped()};
}

}  // namespace rotor
