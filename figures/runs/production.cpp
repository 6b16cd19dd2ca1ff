#include "figures/runs/production.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

#include "figures/runs/observer_group.hpp"

namespace rotor {
namespace {

/// A run, and all who watch it.
struct Branch {
  Scenario scenario;
  ObserverGroup observers;
  std::string name;
};

/// Runs that differ in their end alone, in the order of their ends.
using Group = std::vector<Branch>;

/// Groups with the same run-up, in the order in which they leave it.
struct Family {
  Scenario run_up;
  std::vector<Group> groups;
};

bool differ_in_their_end_alone(Scenario a, const Scenario& b) {
  if (a.run_up_end() != b.run_up_end()) return false;
  a.until = b.until;
  return a == b;
}

/// The element that fulfils a condition. If there is none, it is made.
template <class T, class Condition>
T& find_or_add(std::vector<T>& all, const Condition& condition, const T& otherwise) {
  const auto found = std::find_if(all.begin(), all.end(), condition);
  return found != all.end() ? *found : all.emplace_back(otherwise);
}

std::vector<Family> families(const std::vector<Request>& requests, Observer* monitor) {
  std::vector<Family> all;
  for (const Request& request : requests) {
    const Scenario& scenario = request.scenario;
    const Scenario part = run_up_part(scenario);
    Branch newcomer{scenario, {}, request.name};
    if (monitor) newcomer.observers.add(*monitor);
    Family& family =
        find_or_add(all, [&](const Family& other) { return other.run_up == part; }, {part, {}});
    Group& group = find_or_add(family.groups,
                               [&](const Group& other) {
                                 return differ_in_their_end_alone(other.front().scenario, scenario);
                               },
                               {newcomer});
    Branch& branch = find_or_add(
        group, [&](const Branch& other) { return other.scenario == scenario; }, newcomer);
    branch.observers.add(request.observer);
  }
  for (Family& family : all) {
    for (Group& group : family.groups)
      std::stable_sort(group.begin(), group.end(), [](const Branch& a, const Branch& b) {
        return a.scenario.until < b.scenario.until;
      });
    std::stable_sort(family.groups.begin(), family.groups.end(),
                     [](const Group& a, const Group& b) {
                       return a.front().scenario.run_up_end() < b.front().scenario.run_up_end();
                     });
  }
  return all;
}

class Stopwatch {
 public:
  /// Seconds since the last lap.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(start_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// All who watch the runs of a group from one of them on.
ObserverGroup observers_of(Group::const_iterator from, Group::const_iterator until) {
  ObserverGroup all;
  for (; from != until; ++from) all.add(from->observers);
  return all;
}

/// From the end of the run-up on. What it costs is added.
void finish(Simulation trunk, Group& group, Counters& cost) {
  const Counters before = trunk.counters();
  ObserverGroup all = observers_of(group.begin(), group.end());
  trunk.pass_mass_loss(all);
  for (auto branch = group.begin(); branch != group.end(); ++branch) {
    ObserverGroup remaining = observers_of(branch, group.end());
    if (trunk.instant().mass_lost) trunk.approach(branch->scenario.until, remaining);
    Simulation simulation = trunk.with(branch->scenario);
    simulation.finish(branch->observers);
    cost += simulation.counters() - trunk.counters();
  }
  cost += trunk.counters() - before;
}

void produce(Family& family, ProductionReport& report) {
  Stopwatch stopwatch;
  Simulation trunk(family.run_up);
  for (Group& group : family.groups)
    observers_of(group.begin(), group.end()).on_instant(trunk.instant());
  ++report.run_ups;
  for (auto next = family.groups.begin(); next != family.groups.end(); ++next) {
    ObserverGroup all;  // who has not left the run-up yet watches it
    for (auto group = next; group != family.groups.end(); ++group)
      all.add(observers_of(group->begin(), group->end()));
    const Scenario& scenario = next->front().scenario;
    try {
      trunk.run_up(scenario.run_up_end(), all);
      report.run_up_s += stopwatch.lap();
      finish(trunk.with(scenario), *next, report.cost);
    } catch (const std::runtime_error& error) {
      const std::string& name = next->front().name;
      if (name.empty()) throw;
      throw std::runtime_error(name + ": " + error.what());
    }
    ++report.runs;
    report.rub_s += stopwatch.lap();
  }
  report.cost += trunk.counters();
}

}  // namespace

ProductionReport produce(const std::vector<Request>& requests, Observer* monitor) {
  ProductionReport report;
  for (Family& family : families(requests, monitor)) produce(family, report);
  return report;
}

}  // namespace rotor
