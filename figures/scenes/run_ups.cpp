#include "figures/scenes/run_ups.hpp"

#include <algorithm>
#include <limits>

#include "figures/scenes/audience.hpp"

namespace rotor {
namespace {

/// So many departures are kept, some kB each,
constexpr std::size_t most_departures = 2048;
/// that are so many steps apart, and so large a part of the way there.
constexpr long least_steps = 16, parts_of_way = 64;

double time_s(const Departure& departure) { return departure.simulation.instant().time_s; }
long steps(const Departure& departure) { return departure.simulation.counters().steps; }

/// A run-up that nothing ends.
Scenario endless(Scenario run_up) {
  run_up.until = std::numeric_limits<double>::max();
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
    ++departures_;
  }
  for (; departures_ > most_departures && families_.size() > 1; families_.pop_back())
    departures_ -= families_.back().departures.size();
  return families_.front();
}

Departure RunUps::depart(const Scenario& scenario, Observer& monitor, double latest_s) {
  const SummaryObserver fresh(scenario);
  const double until_s =
      std::min(latest_s, std::min(scenario.run_up_end(), fresh.time_of_speed_s()));
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
  if (is_far && !way.simulation.stopped()) {
    departures.insert(later, std::move(way));
    ++departures_;
  }
  departure.simulation = departure.simulation.with(scenario);
  departure.summary = departure.summary.with(scenario);
  return departure;
}

SpeedReached RunUps::time_at_speed(const Scenario& scenario, double speed_Hz,
                                   std::optional<double> until_s, Observer& monitor) {
  const std::vector<Departure>& departures = family(run_up_to_speed(scenario)).departures;
  constexpr double ripple = 0.01;  // the speed rises, but for this
  const auto faster =
      std::find_if(departures.begin() + 1, departures.end(), [&](const Departure& departure) {
        return in_Hz(departure.simulation.instant().state[5]) > (1 - ripple) * speed_Hz;
      });
  const SpeedReached found =
      rotor::time_at_speed((faster - 1)->simulation, scenario, speed_Hz, until_s, monitor);
  if (found.time_s || faster - 1 == departures.begin()) return found;
  // The greatest speed may have been on the way there.
  return rotor::time_at_speed(departures.front().simulation, scenario, speed_Hz, until_s, monitor);
}

}  // namespace rotor
