/// What single evaluations cost: right-hand sides of each phase, a step, a located event.
#include <benchmark/benchmark.h>

#include "model/event_method.hpp"

namespace rotor {
namespace {

/// A rotor at 150 Hz just after its mass loss, and at 45 Hz pressed 0.5 mm into the ring.
struct Setting {
  Setting()
      : around{MassLoss<double>(p).after, {p, Equations::published}, Ring<double>(p), 1e9, true} {}

  Parameters p;
  Surroundings<double> around;
  State<double> in_flight{-1.5e-5, 0, 0.3, 0, 0.28, 942};
  State<double> in_contact{3.5e-3, 0, 0.3, 0.1, 0.2 - 283 * (3.5e-3 + 0.06), 283};
};

template <class Phase>
void evaluate(benchmark::State& state, const Phase& phase, const State<double>& q) {
  auto x = phase.unknowns(q), rates = x;
  for (auto _ : state) {
    benchmark::DoNotOptimize(x);
    phase(x, rates, 0);
    benchmark::DoNotOptimize(rates);
  }
}

void right_hand_side_in_flight(benchmark::State& state) {
  const Setting s;
  evaluate(state, FreeFlight<double>(s.around, s.in_flight), s.in_flight);
}
void right_hand_side_in_sliding(benchmark::State& state) {
  const Setting s;
  evaluate(state, Sliding<double>(s.around, s.in_contact, 1, false), s.in_contact);
}
void right_hand_side_in_rolling(benchmark::State& state) {
  const Setting s;
  evaluate(state, Rolling<double>(s.around, s.in_contact), s.in_contact);
}

void step_in_rolling(benchmark::State& state) {
  const Setting s;
  const Rolling<double> phase(s.around, s.in_contact);
  Verner87<std::array<double, 6>, double> stepper;
  auto x = phase.unknowns(s.in_contact), rates = x, after = x, errors = x;
  phase(x, rates, 0);
  for (auto _ : state) {
    stepper.do_step(std::cref(phase), x, rates, 0., after, 1e-4, errors);
    benchmark::DoNotOptimize(after);
  }
}

/// From 0.1 ms before the first touch-down to 0.1 ms after it, located to rounding.
void one_touch_down(benchmark::State& state) {
  struct : Observer {
    using Observer::see;
    void see(const Instant&) override {}
  } nobody;
  Scenario scenario;
  Work work;
  EventMethod<double> method(scenario, 1e-10, nobody, work);
  const Setting s;
  Instant at = start(scenario);
  at.body = s.around.body;
  at.separated = true;
  at.state = {2.9e-3, 0, 0, 1, -942 * 2.9e-3, 942};
  for (auto _ : state) benchmark::DoNotOptimize(method.rub(at, 2e-4));
  state.counters["right-hand sides"] =
      static_cast<double>(work.right_hand_sides) / static_cast<double>(state.iterations());
}

BENCHMARK(right_hand_side_in_flight);
BENCHMARK(right_hand_side_in_sliding);
BENCHMARK(right_hand_side_in_rolling);
BENCHMARK(step_in_rolling);
BENCHMARK(one_touch_down);

}  // namespace
}  // namespace rotor

BENCHMARK_MAIN();
