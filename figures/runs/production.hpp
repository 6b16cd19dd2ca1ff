/// Runs what several scenes ask for, and nothing twice: equal runs are one, and runs that differ
/// only later share the way there.
#pragma once

#include <string>
#include <vector>

#include "model/run/simulation.hpp"

namespace rotor {

/// A run and who observes it.
struct Request {
  Scenario scenario;
  Observer& observer;
  std::string name{};  ///< precedes the message of what it throws
};

struct ProductionCost {
  int runs = 0;     ///< integrated after their run-up
  int run_ups = 0;  ///< integrated from the start
  Counters counters;
};

/// Runs all requests. Every observer is shown the same, to the bit, as by a separate run. Throws
/// as `run` does. A monitor, if there is one, watches all runs: if it stops one,
/// all stop.
ProductionCost produce(const std::vector<Request>& requests, Observer* monitor = nullptr);

}  // namespace rotor
