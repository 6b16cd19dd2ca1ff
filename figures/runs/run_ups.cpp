#include "figures/runs/run_ups.hpp"

#include <algorithm>

#include "model/theory/lifting.hpp"

namespace rotor {
namespace {

/// The number of checkpoints that are kept, some kB each,
constexpr std::size_t most_checkpoints = 2048;
/// and their distance, in steps and relative to the time of the checkpoint.
constexpr long least_steps = 4, parts_of_way = 64;

long steps(const RunUpCheckpoint& checkpoint) { return checkpoint.simulation.counters().steps; }

RunUpCheckpoint branched(const Scenario& scenario, const RunUpCheckpoint& run_so_far) {
  RunUpCheckpoint checkpoint = run_so_far;
  checkpoint.simulation = run_so_far.simulation.branch(scenario);
  checkpoint.summary = run_so_far.summary.branch(scenario);
  return checkpoint;
}

/// Such a run depends on the ring from its start on.
bool starts_in_contact(const Scenario& scenario) {
  return scenario.start && start_of(scenario).contact != ContactState::free;
}

/// Of what drives or brakes the rotor until its motor is switched off, N m.
double constant_moment(const Scenario& scenario) {
  return ActingLoads<double>(scenario.parameters, scenario.equations).constant_moment(true);
}

/// Watches a run-up whose motor is switched off at the speed that is looked for. Stops it there, at
/// a contact, or when the monitor does.
class SpeedWatch : public Observer {
 public:
  explicit SpeedWatch(Observer& monitor) : monitor_(monitor) {}

  void on_instant(const Instant& at) override {
    if (reached.time_s || reached.touches) return;
    reached.looked_until_s = at.time_s;
    reached.greatest_Hz = std::max(reached.greatest_Hz, in_Hz(at.state[5]));
    reached.touches = at.touches();
    if (at.event == Event::motor_off) reached.time_s = at.time_s;
  }
  bool should_continue(const Progress& now) override {
    if (reached.time_s || reached.touches) return false;
    reached.greatest_Hz = std::max(reached.greatest_Hz, in_Hz(now.speed));
    return monitor_.should_continue(now);
  }
  bool may_stop_early() const override { return true; }

  SpeedReached reached{};

 private:
  Observer& monitor_;
};

/// Continues a run-up to where the motor's guard finds the speed. The result does not depend on
/// where it is continued, before that.
SpeedReached search(const Simulation& from, Scenario run_up, double speed_Hz,
                    std::optional<double> until_s, Observer& monitor) {
  Parameters& p = run_up.parameters;
  const double start_Hz = in_Hz(from.instant().state[5]);
  constexpr double speed_rounding = 1e-12;
  // Only a start can be over the ring; whether it touches depends on the ring of the first
  // scenario.
  if (from.instant().contact != ContactState::free) return {std::nullopt, 0, start_Hz, true};
  if (start_Hz >= (1 - speed_rounding) * speed_Hz)
    return {from.instant().time_s, 0, start_Hz, false};
  const double moment = constant_moment(run_up);
  if (!(moment > 0) || !from.instant().motor_on) return {std::nullopt, 0, start_Hz, false};
  run_up.until = until_s.value_or(2 * p.inertia * two_pi * speed_Hz / moment);
  p.motor_off_Hz = std::min(p.motor_off_Hz, speed_Hz);
  SpeedWatch watch(monitor);
  from.branch(run_up).run_to_end(watch);
  if (p.motor_off_Hz < speed_Hz) watch.reached.time_s = std::nullopt;
  return watch.reached;
}

}  // namespace

RunUps::Family& RunUps::family(const Scenario& scenario) {
  Scenario run_up = run_up_part(scenario);
  run_up.until = std::numeric_limits<double>::max();
  const auto found = std::find_if(families_.begin(), families_.end(),
                                  [&](const Family& family) { return family.run_up == run_up; });
  if (found != families_.end()) {
    families_.splice(families_.begin(), families_, found);
  } else {
    families_.push_front({run_up, {RunUpCheckpoint(run_up)}});
    ++checkpoints_;
  }
  for (; checkpoints_ > most_checkpoints && families_.size() > 1; families_.pop_back())
    checkpoints_ -= families_.back().checkpoints.size();
  return families_.front();
}

/// Runs from the last checkpoint before a time to that time. Keeps checkpoints far from the others.
RunUpCheckpoint RunUps::follow(std::vector<RunUpCheckpoint>& checkpoints, double until_s,
                               Observer& monitor) {
  const auto later = std::upper_bound(checkpoints.begin() + 1, checkpoints.end(), until_s,
                                      [](double limit_s, const RunUpCheckpoint& checkpoint) {
                                        return limit_s < checkpoint.simulation.instant().time_s;
                                      });
  const RunUpCheckpoint& last = *(later - 1);
  RunUpCheckpoint run_so_far = last;
  ObserverGroup observers = {&monitor, &run_so_far.summary};
  run_so_far.simulation.run_up(until_s, observers);
  const long on_the_way = steps(last) - steps(checkpoints.front());
  const bool is_far = steps(run_so_far) - steps(last) >= least_steps + on_the_way / parts_of_way;
  if (is_far && !run_so_far.simulation.stopped()) {
    checkpoints.insert(later, run_so_far);
    ++checkpoints_;
  }
  return run_so_far;
}

RunUpCheckpoint RunUps::checkpoint_before(const Scenario& scenario, Observer& monitor,
                                          double latest_s) {
  // Later a summary would need the speed at a time that depends on the end of the run.
  const double until_s =
      std::min({latest_s, scenario.run_up_end(), SummaryObserver(scenario).time_of_speed_s()});
  if (!scenario.loses_mass() || !(until_s > 0) || starts_in_contact(scenario))
    return RunUpCheckpoint(scenario);
  return branched(scenario, follow(family(scenario).checkpoints, until_s, monitor));
}

SpeedReached RunUps::time_at_speed(const Scenario& scenario, double speed_Hz,
                                   std::optional<double> until_s, Observer& monitor) {
  constexpr double ripple = 0.01;  // the speed rises, apart from this
  Scenario run_up = scenario;
  run_up.parameters.loses_mass = false;
  run_up.method = Method::event;
  std::vector<RunUpCheckpoint>& checkpoints = family(run_up).checkpoints;
  // Resistance delays the speed: a run that loses its mass there passes this checkpoint, too.
  const Parameters& p = scenario.parameters;
  const double rise_Hz = std::min(speed_Hz, p.motor_off_Hz) - scenario.start_speed_Hz;
  Scenario soonest = scenario;
  soonest.until = (1 - ripple) * p.inertia * two_pi * rise_Hz / constant_moment(scenario);
  const double passed_s = SummaryObserver(soonest).time_of_speed_s();
  if (passed_s > 0 && soonest.until < until_s.value_or(std::numeric_limits<double>::max()))
    follow(checkpoints, passed_s, monitor);
  const auto faster = std::find_if(
      checkpoints.begin() + 1, checkpoints.end(), [&](const RunUpCheckpoint& checkpoint) {
        return in_Hz(checkpoint.simulation.instant().state[5]) > (1 - ripple) * speed_Hz;
      });
  const SpeedReached found = search((faster - 1)->simulation, run_up, speed_Hz, until_s, monitor);
  if (found.time_s || faster - 1 == checkpoints.begin()) return found;
  // The greatest speed may have occurred earlier.
  return search(checkpoints.front().simulation, run_up, speed_Hz, until_s, monitor);
}

Scenario scenario_of(const ScenarioSpec& spec) {
  RunUps none;
  return scenario_of(spec, none);
}

Scenario scenario_of(const ScenarioSpec& spec, RunUps& run_ups) try {
  Scenario scenario = stated_scenario(spec);
  const std::optional<double> stated_Hz = scenario.stated_mass_loss_speed_Hz();
  if (!stated_Hz) return scenario;
  const double speed_Hz = *stated_Hz;
  const Parameters& p = scenario.parameters;
  const bool states_end = spec.numbers.contains("until");
  Interruptible monitor;
  const SpeedReached reached = run_ups.time_at_speed(
      scenario, speed_Hz, states_end ? std::optional(scenario.until) : std::nullopt, monitor);
  if (is_interrupted()) throw Interrupted();
  const bool in_rpm = spec.numbers.contains("mass_loss_speed_rpm");
  const Mention at_loss{"mass_loss_speed_Hz", fmt::format("{} Hz", speed_Hz)};
  if (!reached.time_s && p.torque == 0 && !reached.touches)
    throw ScenarioError({at_loss, ": is not reached from ", mention_of(scenario, "start_speed_Hz"),
                         " with ", mention_of(scenario, "torque")});
  if (!reached.time_s) {
    Message message = {
        at_loss,
        fmt::format(": is not reached{}; up to {:.6g} s the rotor reaches at most {:.6g} {}",
                    reached.touches ? " before the rotor touches the ring" : "",
                    reached.looked_until_s, reached.greatest_Hz * (in_rpm ? 60 : 1),
                    in_rpm ? "rpm" : "Hz")};
    const auto add = [&](std::initializer_list<Message::Part> more) {
      message.parts.insert(message.parts.end(), more);
    };
    if (reached.touches)
      add({"; state mass_loss_time"});
    else if (swings(scenario))
      add({"; ", mention_of(scenario, "torque"),
           fmt::format(" does not lift the unbalance, which takes {:.4g} N m", lifting_torque(p))});
    else if (speed_Hz > p.motor_off_Hz)
      add({"; above ", Mention{"motor_off_Hz"}, " the motor is off"});
    throw ScenarioError(message);
  }
  if (*reached.time_s > 0)
    scenario.state_mass_loss_speed(speed_Hz, *reached.time_s);
  else
    scenario.mass_loss_speed_Hz = {};
  if (!states_end) scenario.until += *reached.time_s;
  return scenario;
} catch (const Interrupted&) {
  throw;
} catch (const ScenarioError& error) {
  throw ScenarioError(as_stated(error.message(), spec));
} catch (const std::exception& error) {  // the run-up to the speed fails
  throw ScenarioError({error.what()});
}

}  // namespace rotor
