#include "figures/runs/production.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <stdexcept>
#include <tuple>

namespace rotor {
namespace {

using Requests = std::vector<Request>;

bool differ_in_their_end_alone(const Scenario& a, const Scenario& b) {
  Scenario with_that_end = a;
  with_that_end.until = b.until;
  return a.run_up_end() == b.run_up_end() && with_that_end == b;
}

bool share_their_run_up(const Scenario& a, const Scenario& b) {
  return run_up_part(a) == run_up_part(b);
}

/// Removes the first request, and those whose scenarios are like its own.
Requests take(Requests& all, bool (*are_alike)(const Scenario&, const Scenario&)) {
  const Scenario first = all.front().scenario;
  const auto others = std::stable_partition(all.begin(), all.end(), [&](const Request& request) {
    return are_alike(first, request.scenario);
  });
  Requests taken(std::move_iterator(all.begin()), std::move_iterator(others));
  all.erase(all.begin(), others);
  return taken;
}

/// Runs of one run-up.
void produce(Requests requests, Observer& monitor, ProductionCost& cost) {
  Simulation trunk(run_up_part(requests.front().scenario));
  for (const Request& request : requests) request.observer->on_instant(trunk.instant());
  ++cost.run_ups;
  while (!requests.empty()) {
    const Request first = requests.front();
    try {
      ObserverGroup all = {&monitor};
      for (const Request& request : requests) all.add(*request.observer);
      trunk.run_up(first.scenario.run_up_end(), all);
      std::deque<ObserverGroup> observers;
      std::vector<RunEnding> endings;
      for (const Request& request : take(requests, differ_in_their_end_alone))
        endings.push_back({request.scenario.until,
                           observers.emplace_back(ObserverGroup{&monitor, request.observer})});
      cost.counters += trunk.with(first.scenario).finish(endings);
      ++cost.runs;
    } catch (const std::runtime_error& error) {
      if (first.name.empty()) throw;
      throw std::runtime_error(first.name + ": " + error.what());
    }
  }
  cost.counters += trunk.counters();
}

}  // namespace

ProductionCost produce(Requests requests, Observer& monitor) {
  // In the order in which they leave their run-up, then in the order of their ends.
  const auto order = [](const Request& of) {
    return std::tuple(of.scenario.run_up_end(), of.scenario.until);
  };
  std::stable_sort(requests.begin(), requests.end(),
                   [&](const Request& a, const Request& b) { return order(a) < order(b); });
  ProductionCost cost;
  while (!requests.empty()) produce(take(requests, share_their_run_up), monitor, cost);
  return cost;
}

}  // namespace rotor
