#include "figures/production.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "figures/audience.hpp"

namespace rotor {
namespace {

/// A run, and all who watch it.
struct SharedRun {
  Scenario scenario;
  Audience audience;
};

/// Runs with the same run-up, in the order in which they leave it.
struct Family {
  Scenario run_up;
  std::vector<SharedRun> members;
};

/// Runs that differ in their end alone are one run, up to the latest end.
bool same_but_for_the_end(Scenario a, const Scenario& b) {
  if (run_up_end(a) != run_up_end(b)) return false;
  a.until = b.until;
  return a == b;
}

void add(std::vector<SharedRun>& runs, const Request& request) {
  const auto same = std::ranges::find_if(runs, [&](const SharedRun& run) {
    return same_but_for_the_end(run.scenario, request.scenario);
  });
  if (same == runs.end()) {
    runs.push_back({request.scenario, {}});
    runs.back().audience.add(request.observer);
  } else {
    same->scenario.until = std::max(same->scenario.until, request.scenario.until);
    same->audience.add(request.observer);
  }
}

std::vector<Family> families(const std::vector<Request>& requests) {
  std::vector<Family> all;
  for (const Request& request : requests) {
    const Scenario part = run_up_part(request.scenario);
    auto family = std::ranges::find(all, part, &Family::run_up);
    if (family == all.end()) family = all.insert(all.end(), {part, {}});
    add(family->members, request);
  }
  for (Family& family : all)
    std::ranges::stable_sort(family.members, {},
                             [](const SharedRun& run) { return run_up_end(run.scenario); });
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

void produce(Family& family, ProductionReport& report) {
  Stopwatch stopwatch;
  Instant at = start(family.run_up);
  for (SharedRun& run : family.members) run.audience.see(at);
  ++report.run_ups;

  for (auto next = family.members.begin(); next != family.members.end(); ++next) {
    Audience all;  // who has not left the run-up yet watches it
    std::for_each(next, family.members.end(), [&](const SharedRun& run) { all.add(run.audience); });
    at = run_up(next->scenario, at, run_up_end(next->scenario), all, report.work);
    report.run_up_s += stopwatch.lap();
    run(next->scenario, at, next->audience, report.work);
    ++report.runs;
    report.rub_s += stopwatch.lap();
  }
}

}  // namespace

ProductionReport produce(const std::vector<Request>& requests) {
  ProductionReport report;
  for (Family& family : families(requests)) produce(family, report);
  return report;
}

}  // namespace rotor
