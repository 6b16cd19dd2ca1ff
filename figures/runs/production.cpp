#include "figures/runs/production.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <tuple>

namespace rotor {
namespace {

/// A run, and all its observers.
struct Branch {
  Scenario scenario;
  ObserverGroup observers;
  std::string name;
};
using Branches = std::vector<Branch>;

bool differ_in_their_end_alone(Scenario a, const Scenario& b) {
  if (a.run_up_end() != b.run_up_end()) return false;
  a.until = b.until;
  return a == b;
}

/// In the order in which they leave their run-up, then in the order of their ends.
Branches branches(const std::vector<Request>& requests, Observer* monitor) {
  Branches all;
  for (const Request& request : requests) {
    auto branch = std::find_if(all.begin(), all.end(), [&](const Branch& other) {
      return other.scenario == request.scenario;
    });
    if (branch == all.end()) {
      branch = all.emplace(all.end(), Branch{request.scenario, {}, request.name});
      if (monitor) branch->observers.add(*monitor);
    }
    branch->observers.add(request.observer);
  }
  const auto order = [](const Branch& of) {
    return std::tuple(of.scenario.run_up_end(), of.scenario.until);
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Branch& a, const Branch& b) { return order(a) < order(b); });
  return all;
}

/// Removes from the branches those that equal the first one.
template <class Alike>
Branches take(Branches& all, const Alike& alike) {
  const Scenario first = all.front().scenario;
  const auto others = std::stable_partition(
      all.begin(), all.end(), [&](const Branch& branch) { return alike(first, branch.scenario); });
  Branches taken(std::move_iterator(all.begin()), std::move_iterator(others));
  all.erase(all.begin(), others);
  return taken;
}

/// Branches of one run-up.
void produce(Branches branches, ProductionCost& cost) {
  Simulation trunk(run_up_part(branches.front().scenario));
  for (Branch& branch : branches) branch.observers.on_instant(trunk.instant());
  ++cost.run_ups;
  while (!branches.empty()) {
    const Branch first = branches.front();
    try {
      ObserverGroup all;
      for (const Branch& branch : branches) all.add(branch.observers);
      trunk.run_up(first.scenario.run_up_end(), all);
      Branches group = take(branches, differ_in_their_end_alone);
      std::vector<RunEnding> endings;
      for (Branch& branch : group) endings.push_back({branch.scenario.until, branch.observers});
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

ProductionCost produce(const std::vector<Request>& requests, Observer* monitor) {
  ProductionCost cost;
  for (Branches all = branches(requests, monitor); !all.empty();)
    produce(take(all, [](const Scenario& a,
                         const Scenario& b) { return run_up_part(a) == run_up_part(b); }),
            cost);
  return cost;
}

}  // namespace rotor
