#include "figures/scenes/run_ups.hpp"

#include <algorithm>
#include <limits>

#include "figures/scenes/audience.hpp"

namespace rotor {
namespace {

/// Of so many families the run-ups are kept,
constexpr std::size_t most_families = 32;
/// at places that are so many steps apart, and so large a part of the way there.
constexpr long least_steps = 16, parts_of_way = 64;

double time_s(const Departure& departure) { return departure.simulation.instant().time_s; }
long steps(const Departure& departure) { return departure.simulation.counters().steps; }

/// A run-up that nothing ends.
Scenario endless(Scenario run_up) {
  run_up.until = std::numeric_limits<double>::max();
  run_up.parameters.separates = false;
  return run_up;
}

}  // namespace

Departure::Departure(const Scenario& scenario) : simulation(scenario), summary(scenario) {
  summary.on_instant(simulation.instant());
}

RunUps::Family& RunUps::family(const Scenario& scenario) {
  const Scenario run_up = endless(run_up_part(scenario));
  const auto found = std::find_if(families_.begin(), families_.end(),
                                  [&](const Family& family) { return family.run_up == run_up; });
  if (found != families_.end()) {
    families_.splice(families_.begin(), families_, found);
  } else {
    families_.push_front({run_up, {Departure(run_up)}});
    if (families_.size() > most_families) families_.pop_back();
  }
  return families_.front();
}

Departure RunUps::depart(const Scenario& scenario, Observer& monitor) {
  const SummaryObserver fresh(scenario);
  const double until_s = std::min(scenario.run_up_end(), fresh.time_of_speed_s());
  if (!scenario.loses_mass() || !(until_s > 0)) return Departure(scenario);
  std::vector<Departure>& departures = family(scenario).departures;
  const auto later = std::upper_bound(
      departures.begin() + 1, departures.end(), until_s,
      [](double limit_s, const Departure& departure) { return limit_s < time_s(departure); });
  const Departure& last = *(later - 1);
  Departure way = last;
  Audience audience;
  audience.add(monitor);
  audience.add(way.summary);
  way.simulation.run_up(until_s, audience);
  const bool is_far = steps(way) - steps(last) >= least_steps + steps(last) / parts_of_way;
  Departure departure = way;
  if (is_far && !way.simulation.stopped()) departures.insert(later, std::move(way));
  departure.simulation = departure.simulation.with(scenario);
  departure.summary = departure.summary.with(scenario);
  return departure;
}

}  // namespace rotor
