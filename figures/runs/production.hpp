/// Runs what several scenes need: equal runs are one, and others share their run-up.
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

/// Runs all requests. Every observer sees the same, to the bit, as in a separate run. Throws as
/// `run` does. The monitor watches all runs; if it stops one, all stop.
void produce(std::vector<Request> requests, Observer& monitor);

}  // namespace rotor
