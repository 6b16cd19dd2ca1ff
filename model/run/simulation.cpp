#include "model/run/simulation.hpp"

#include <array>
#include <stdexcept>
#include <variant>

#include "model/methods/event_method.hpp"
#include "model/methods/published_method.hpp"
#include "model/methods/whole_run.hpp"

namespace rotor {
namespace {

using AnyMethod = std::variant<EventMethod<double>, PublishedMethod>;

AnyMethod method_of(const Scenario& scenario, const Instant& from) {
  switch (scenario.method) {
    case Method::event:
      return EventMethod<double>(scenario, scenario.tolerance, from);
    case Method::rk4:
      return PublishedMethod(scenario, from);
  }
  throw std::invalid_argument("unknown method");
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

Simulation& Simulation::operator=(const Simulation& other) {
  if (this != &other) state_ = std::make_unique<State>(*other.state_);
  return *this;
}

void Simulation::run_up(double until_s, Observer& observer) {
  state_->visit([&](auto& method) { method.run_up(until_s, observer); });
}

void Simulation::finish(Observer& observer) {
  finish(std::array{RunEnding{state_->scenario.until, observer}});
}

Counters Simulation::finish(std::span<const RunEnding> endings) {
  return state_->visit([&](auto& method) {
    Scenario& scenario = state_->scenario;
    const MassLoss<double> loss(scenario.parameters);
    const Counters before = method.counters();
    Counters of_branches;
    for (; endings.size() > 1; endings = endings.subspan(1)) {
      ObserverGroup all;
      for (const RunEnding& ending : endings) all.add(ending.observer);
      scenario.until = endings.front().until_s;
      rotor::pass_mass_loss(method, scenario, loss, all);
      if (method.instant().mass_lost) method.approach(scenario.until, all);
      auto branch = method;
      rotor::finish(branch, scenario, loss, endings.front().observer);
      of_branches += branch.counters() - method.counters();
    }
    scenario.until = endings.front().until_s;
    rotor::finish(method, scenario, loss, endings.front().observer);
    return of_branches += method.counters() - before;
  });
}

Simulation Simulation::with(const Scenario& scenario) const {
  Simulation branch = *this;
  branch.state_->scenario = scenario;
  branch.state_->method =
      state_->visit([&](auto& method) -> AnyMethod { return method.with(scenario); });
  return branch;
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
  observer.on_instant(from);
  Simulation simulation(scenario, from);
  simulation.finish(observer);
  return {simulation.instant(), simulation.counters(), simulation.stopped()};
}

}  // namespace rotor
