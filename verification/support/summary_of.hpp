/// Summaries of runs.
#pragma once

#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"

namespace rotor {

/// Of a scenario's run from rest.
inline Summary summary_of(const Scenario& scenario) {
  SummaryObserver observer(scenario);
  run(scenario, observer);
  return observer.summary();
}

inline Summary summary_until(double until_s, Scenario scenario) {
  scenario.until = until_s;
  return summary_of(scenario);
}

}  // namespace rotor
