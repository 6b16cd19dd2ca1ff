/// What single evaluations cost: right-hand sides of each phase, a step, a located event.
#include <benchmark/benchmark.h>

#include "model/mechanics/mass_loss.hpp"
#include "model/methods/event_method.hpp"
#include "model/phases/flight.hpp"

namespace rotor {
namespace {

/// A rotor at 150 Hz just after its mass loss, and at 45 Hz pressed 0.5 mm into the ring.
struct Setting {
  Setting() { rotor.body = MassLoss<double>(p).after; }

  Parameters p;
  RotorSystem<double> rotor{p, Equations::published};
  State<double> in_flight{-1.5e-5, 0, 0.3, 0, 0.28, 942};
  State<double> in_contact{3.5e-3, 0, 0.3, 0.1, 0.2 - 283 * (3.5e-3 + 0.06), 283};
  FlightChart<double> flight{rotor, in_flight};
  ContactChart<double> contact{rotor, in_contact};
};

template <class Phase>
void evaluate(benchmark::State& state, const Phase& phase, const State<double>& q) {
  auto x = phase.chart.unknowns(q), rates = x;
  for (auto _ : state) {
    benchmark::DoNotOptimize(x);
    phase(x, rates, 0);
    benchmark::DoNotOptimize(rates);
  }
}

void right_hand_side_in_flight(benchmark::State& state) {
  const Setting s;
  evaluate(state, FreeFlight<double>(s.rotor, s.flight), s.in_flight);
}
void right_hand_side_in_sliding(benchmark::State& state) {
  const Setting s;
  evaluate(state, Sliding<double>(s.rotor, s.contact, 1), s.in_contact);
}
void right_hand_side_in_rolling(benchmark::State& state) {
  const Setting s;
  evaluate(state, Rolling<double>(s.rotor, s.contact), s.in_contact);
}

void step_in_rolling(benchmark::State& state) {
  const Setting s;
  const Rolling<double> phase(s.rotor, s.contact);
  Verner87<std::array<double, 6>, double> stepper;
  auto x = phase.chart.unknowns(s.in_contact), rates = x, after = x, errors = x;
  phase(x, rates, 0);
  for (auto _ : state) {
    stepper.do_step(std::cref(phase), x, rates, 0., after, 1e-4, errors);
    benchmark::DoNotOptimize(after);
  }
}

/// From 0.1 ms before the first touch-down to 0.1 ms after it, located to rounding.
void one_touch_down(benchmark::State& state) {
  const Setting s;
  Instant at = at_rest(s.p);
  at.body = s.rotor.body;
  at.mass_lost = true;
  at.state = {2.9e-3, 0, 0, 1, -942 * 2.9e-3, 942};
  Observer null_observer;
  long right_hand_sides = 0;
  for (auto _ : state) {
    EventMethod<double> method(Scenario{}, 1e-10, at);
    method.advance(2e-4, null_observer);
    right_hand_sides += method.counters().right_hand_sides;
  }
  state.counters["right-hand sides"] =
      static_cast<double>(right_hand_sides) / static_cast<double>(state.iterations());
}

BENCHMARK(right_hand_side_in_flight);
BENCHMARK(right_hand_side_in_sliding);
BENCHMARK(right_hand_side_in_rolling);
BENCHMARK(step_in_rolling);
BENCHMARK(one_touch_down);

}  // namespace
}  // namespace rotor

BENCHMARK_MAIN();
