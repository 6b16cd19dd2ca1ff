/// Runs what several scenes ask for, and nothing twice: equal runs are one, and runs that differ
/// only later share the way there.
#pragma once

#include <string>
#include <vector>

#include "model/run/simulation.hpp"

namespace rotor {

/// One run that somebody wants to see.
struct Request {
  Scenario scenario;
  Observer& observer;
  std::string name{};  ///< said before what it throws
};

struct ProductionReport {
  int runs = 0;     ///< integrated after their run-up
  int run_ups = 0;  ///< integrated from t = 0
  double run_up_s = 0;
  double rub_s = 0;  ///< time taken by the runs after their run-up
  Counters cost;
};

/// Runs all requests. Every observer is shown the same, to the bit, as by a run of its own. Throws
/// as `run` does. A monitor, if there is one, watches all runs: where it does not let one go on,
/// none does.
ProductionReport produce(const std::vector<Request>& requests, Observer* monitor = nullptr);

}  // namespace rotor
