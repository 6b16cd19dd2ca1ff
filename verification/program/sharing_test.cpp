/// Runs that share a part give the same results, to the bit, as separate runs.
#include <gtest/gtest.h>

#include <random>

#include "figures/results/run_result.hpp"
#include "figures/runs/run_ups.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

std::string finished(RunUpCheckpoint run_so_far, const Scenario& scenario) {
  run_so_far.simulation.run_to_end(run_so_far.summary);
  return to_json({scenario,
                  run_so_far.summary.summary(),
                  {run_so_far.simulation.instant(), run_so_far.simulation.counters()},
                  {}})
      .dump(1);
}

/// Scenarios that differ in inputs of the run-up, in later ones, or in the time at which they leave
/// the run-up; each input varies.
std::vector<Scenario> scenarios() {
  std::mt19937_64 random(3);
  const auto one_of = [&](auto... values) {
    const std::vector<std::common_type_t<decltype(values)...>> all = {values...};
    return all[random() % all.size()];
  };
  std::vector<Scenario> all;
  for (int n = 0; n < 48; ++n) {
    Scenario scenario{.tolerance = 1e-8};
    Parameters& p = scenario.parameters;
    p.friction = one_of(0.3, 0.1);
    p.unbalance_factor = one_of(3., 2.);
    // The stiffer support lets the rotor touch the ring before the mass loss.
    p.support_stiffness = one_of(5e4, 5e4, 1.2e5);
    p.mass_loss_time = p.support_stiffness > 1e5
                           ? one_of(0.5, 9.4, 9.5)
                           : one_of(0., 0.5, 2.0, 9.4, 19.1, 29.1, 29.2, 29.100001, 28.0);
    p.loses_mass = one_of(true, true, true, true, false);
    scenario.until = p.mass_loss_time + one_of(0.02, 0.05, 0.3);
    scenario.equations = one_of(Equations::published, Equations::corrected);
    if (p.mass_loss_time < 3) scenario.start_speed_Hz = one_of(0, 0, 100);
    if (n % 8 == 0) {
      scenario.method = Method::rk4;
      p.mass_loss_time = one_of(1.0, 2.0, 2.00003);
      scenario.until = p.mass_loss_time + 0.01;
    }
    if (scenario.start_speed_Hz > 0) p.support_stiffness = 5e4;
    if (n % 2 == 0) {
      const Quantity& other = quantities()[static_cast<std::size_t>(n / 2) % quantities().size()];
      if (other.name != "until" && other.allows(0.99 * other.of(scenario)))
        other.in(scenario) *= 0.99;
    }
    all.push_back(scenario);
  }
  return all;
}

// A run-up that a monitor has stopped must not be used, not even by later runs.
TEST(RunUps, ForgetTheWayThatWasInterrupted) {
  RunUps run_ups;
  struct : Observer {
    bool should_continue(const Progress&) override { return --steps_left > 0; }
    long steps_left = 1000;
  } monitor;
  const Scenario scenario{.until = 29.15, .tolerance = 1e-8};
  const RunUpCheckpoint stopped = run_ups.checkpoint_before(scenario, monitor);
  ASSERT_TRUE(stopped.simulation.stopped());
  // It does not continue, and reports that it was cut short.
  const RunResult result = complete_run(stopped, scenario, StopOn::rolling, monitor);
  EXPECT_EQ(result.end.last.time_s, stopped.simulation.instant().time_s);
  EXPECT_TRUE(result.early.interrupted);
  EXPECT_FALSE(result.early.stop_reached);
  EXPECT_EQ(finished(run_ups.checkpoint_before(scenario, nobody), scenario),
            finished(RunUpCheckpoint(scenario), scenario));
}

TEST(RunUps, FindASpeedWhereASearchFromTheStartFindsIt) {
  RunUps run_ups;
  Scenario beyond{.until = 40};  // where the motor is off and the rotor slows down
  beyond.parameters.mass_loss_time = 38;
  run_ups.checkpoint_before(beyond, nobody);
  for (const double speed_Hz : {75., 20., 149.9, 150., 74.99, 2., 11., 151., 200.}) {
    Scenario scenario{.until = 30};
    scenario.parameters.mass_loss_time = 0;
    const auto found = run_ups.time_at_speed(scenario, speed_Hz, std::nullopt, nobody);
    const auto alone = RunUps().time_at_speed(scenario, speed_Hz, std::nullopt, nobody);
    EXPECT_EQ(found.time_s, alone.time_s) << speed_Hz;
    EXPECT_EQ(found.time_s.has_value(), speed_Hz < 151);
    EXPECT_EQ(found.greatest_Hz, alone.greatest_Hz) << speed_Hz;
    Scenario run_up = scenario;
    run_up.parameters.loses_mass = false;
    run_up.parameters.motor_off_Hz = speed_Hz;
    SummaryObserver summary(run_up);
    run(run_up, summary);
    if (found.time_s) {
      EXPECT_EQ(found.time_s, summary.summary().motor_off_s) << speed_Hz;
    }
    scenario.parameters.mass_loss_time = found.time_s.value_or(1);
    run_ups.checkpoint_before(scenario, nobody);  // leaves checkpoints
  }
}

// A rim without slip, pressed against the ring, sticks to it from the start: so says the run that
// begins there, not the start.
TEST(Start, InRollingIsRollingForTheLibraryTheProgramAndTheDigits) {
  Scenario scenario{.equations = Equations::corrected, .until = 5e-5};
  scenario.start = Start{.x = 3.01e-3};
  scenario.parameters.torque = 0;
  scenario.parameters.loses_mass = false;
  SummaryObserver library(scenario);
  run(scenario, library);
  for (const Summary& summary :
       {library.summary(), complete_run(RunUpCheckpoint(scenario), scenario, {}, nobody).summary,
        compare(Precision::double_, scenario, 1e-9, always)->values}) {
    EXPECT_EQ(summary.rolling_onset_s, 0);
    EXPECT_EQ(summary.whirl_from_s, 0);
  }
}

/// Everything that an observer is shown.
struct Log : Observer {
  explicit Log(bool all_maxima) : wants(all_maxima) {}
  void on_instant(const Instant& at) override { note(at); }
  double threshold(Extreme, const double&, const double&) const override {
    return wants ? 0 : std::numeric_limits<double>::infinity();
  }
  void on_maximum(const Maximum& maximum) override { note(maximum.at); }
  bool wants_dense_output(const double& from_s, const double&) const override {
    return wants && from_s > 29.1;
  }
  void on_step(const DenseOutput& step) override {
    note(step.at(step.from_s + (step.until_s - step.from_s) / 3));
  }
  void note(const Instant& at) {
    seen.push_back(at.time_s);
    seen.insert(seen.end(), at.state.begin(), at.state.end());
    seen.push_back(static_cast<double>(at.contact));
    seen.push_back(static_cast<double>(at.event));
    seen.push_back(at.body.mass);
  }
  static constexpr long numbers = 10;  ///< of an instant
  bool wants;
  std::vector<double> seen;
};

class Steps : public Observer {
 public:
  bool should_continue(const Progress& /*now*/) override { return ++count, true; }
  long count = 0;
};

// In any order, and from any time on.
TEST(RunUps, AreThoseOfRunsOfTheirOwn) {
  std::vector<Scenario> all = scenarios();
  std::mt19937_64 random(4);
  std::shuffle(all.begin(), all.end(), random);
  std::vector<std::string> keys;  // costs differ
  for (const auto& field : summary_fields<double>) keys.emplace_back(field.key);
  RunUps run_ups;
  for (std::size_t n = 0; n < all.size(); ++n) {
    const bool shows_maxima = n % 3 == 0;
    Log alone(shows_maxima), shared(shows_maxima);
    const double latest_s = n % 2 == 0 ? all[n].until : 1 + static_cast<double>(random() % 30);
    RunUpCheckpoint run_so_far = run_ups.checkpoint_before(all[n], shared, latest_s);
    shared.seen.clear();
    const RunResult result = complete_run(std::move(run_so_far), all[n], std::nullopt, shared);
    const RunResult expected = complete_run(RunUpCheckpoint(all[n]), all[n], std::nullopt, alone);
    EXPECT_EQ(to_json(result, &keys), to_json(expected, &keys)) << n;
    ASSERT_LE(shared.seen.size(), alone.seen.size());
    const auto after_first = shared.seen.begin() + Log::numbers;  // where the run continues
    EXPECT_TRUE(std::equal(shared.seen.rbegin(), std::make_reverse_iterator(after_first),
                           alone.seen.rbegin()))
        << n;
  }
}

// Inputs that act only after the mass loss, its time and the end do not separate run-ups.
TEST(RunUps, AreWorkedOutOnceForRunsThatPartLater) {
  RunUps run_ups;
  const auto steps = [&](const Scenario& scenario) {
    Steps monitor;
    run_ups.checkpoint_before(scenario, monitor);
    return monitor.count;
  };
  Scenario scenario{.tolerance = 1e-8};
  const long all = steps(scenario);
  EXPECT_GT(all, 200);
  scenario.until += 0.1;
  EXPECT_LT(steps(scenario), all / 20);
  scenario.parameters.friction = 0.1;
  scenario.parameters.unbalance_factor = 2;
  EXPECT_LT(steps(scenario), all / 20);
  scenario.parameters.mass_loss_time = 28.4;
  EXPECT_LT(steps(scenario), all / 20);
  scenario.parameters.torque = 0.29;
  EXPECT_GT(steps(scenario), all / 3);
  scenario.parameters.torque = 0.28;
  scenario.parameters.mass_loss_time =
      run_ups.time_at_speed(scenario, 140, std::nullopt, nobody).time_s.value();
  EXPECT_LT(steps(scenario), all / 20);  // the search has passed there
}

}  // namespace
}  // namespace rotor
