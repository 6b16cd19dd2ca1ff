/// Runs what several scenes need, and nothing twice: equal runs become one, and runs that differ
/// only later share their beginning.
#pragma once

#include <string>
#include <vector>

#include "model/run/simulation.hpp"

namespace rotor {

/// A run and its observer.
struct Request {
  Scenario scenario;
  Observer& observer;
  std::string name{};  ///< precedes its error messages
};

struct ProductionCost {
  int runs = 0;     ///< integrated after their run-up
  int run_ups = 0;  ///< integrated from the start
  Counters counters;
};

/// Runs all requests. Every observer sees the same, to the bit, as in a separate run. Throws as
/// `run` does. A monitor, if there is one, watches all runs; if it stops one, all stop.
ProductionCost produce(const std::vector<Request>& requests, Observer* monitor = nullptr);

}  // namespace rotor
