/// Runs what several scenes need: runs share the steps that they have in common.
#pragma once

#include <string>
#include <vector>

#include "model/run/simulation.hpp"

namespace rotor {

/// A run and its observer.
struct Request {
  Scenario scenario;
  Observer* observer;
  std::string name{};  ///< precedes its error messages
};

struct ProductionCost {
  int runs = 0;     ///< integrated after their run-up
  int run_ups = 0;  ///< integrated from the start
  Counters counters;
};

/// Runs all requests. Every observer sees the same, to the bit, as in a separate run. Throws as
/// `run` does. The monitor watches all runs; if it stops one, all stop.
ProductionCost produce(std::vector<Request> requests, Observer& monitor);

}  // namespace rotor
