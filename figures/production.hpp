/// Runs what several scenes ask for, each run once: equal runs are shared, and so is the run-up of
/// runs that differ only after it.
#pragma once

#include <vector>

#include "figures/scene.hpp"
#include "model/simulation.hpp"

namespace rotor {

/// One run that somebody wants to see.
struct Request {
  Scenario scenario;
  Observer& observer;
};

struct ProductionReport {
  int runs = 0;     ///< integrated after their run-up
  int run_ups = 0;  ///< integrated from t = 0
  double run_up_s = 0;
  double rub_s = 0;  ///< time taken by the runs after their run-up
  Work work;
};

/// Runs all requests. Every observer sees its whole run, in order, and what follows if others want
/// the same run to last longer. Throws as `run` does.
ProductionReport produce(const std::vector<Request>& requests);

}  // namespace rotor
