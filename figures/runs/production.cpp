#include "figures/runs/production.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace rotor {
namespace {

/// Moves the requests whose scenarios are like the first one's to the front. Returns their number.
std::size_t gather(std::span<Request> all, bool (*are_alike)(const Scenario&, const Scenario&)) {
  const Scenario first = all.front().scenario;
  const auto others = std::stable_partition(all.begin(), all.end(), [&](const Request& request) {
    return are_alike(first, request.scenario);
  });
  return static_cast<std::size_t>(others - all.begin());
}

/// Runs of one run-up, in the order in which they leave it.
void produce_family(std::span<Request> requests, Observer& monitor) {
  Simulation run_up(run_up_part(requests.front().scenario));
  for (const Request& request : requests) request.observer->on_instant(run_up.instant());
  while (!requests.empty()) {
    const Request first = requests.front();
    ObserverGroup all = {&monitor}, of_first = {&monitor};
    for (const Request& request : requests) all.add(*request.observer);
    const std::size_t equal = gather(requests, [](const auto& a, const auto& b) { return a == b; });
    for (const Request& request : requests.first(equal)) of_first.add(*request.observer);
    requests = requests.subspan(equal);
    try {
      run_up.run_up(first.scenario.run_up_end(), all);
      run_up.with(first.scenario).finish(of_first);
    } catch (const std::runtime_error& error) {
      if (first.name.empty()) throw;
      throw std::runtime_error(first.name + ": " + error.what());
    }
  }
}

}  // namespace

void produce(std::vector<Request> requests, Observer& monitor) {
  std::stable_sort(requests.begin(), requests.end(), [](const Request& a, const Request& b) {
    return a.scenario.run_up_end() < b.scenario.run_up_end();
  });
  for (std::span<Request> left = requests; !left.empty();) {
    const std::size_t family = gather(left, [](const Scenario& a, const Scenario& b) {
      return run_up_part(a) == run_up_part(b);
    });
    produce_family(left.first(family), monitor);
    left = left.subspan(family);
  }
}

}  // namespace rotor
