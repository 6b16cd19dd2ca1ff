/// The published method's steps: where they are short, what they show, and how they end. Its
/// results are tested by convergence_test.cpp and by the paper's claims.
#include <gtest/gtest.h>

#include "model/results/summary.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

/// All instants of a run by the published method.
struct Steps : Observer {
  void on_instant(const Instant& at) override { all.push_back(at); }
  std::vector<Instant> all;
};

TEST(PublishedMethod, LosesTheMassOnce) {
  const Scenario scenario{
      .parameters = {.mass_loss_time = 0.29}, .method = Method::rk4, .until = 0.3};
  const EventRecorder recorder = recorded(scenario);
  EXPECT_EQ(recorder.count(Event::mass_loss), 1);
  EXPECT_NE(2900 * scenario.step_run_up, 0.29);  // as steps add up
  EXPECT_EQ(recorder.first(Event::mass_loss).time_s, 0.29);
}

// The whirl counts from the step in which rolling begins, not from the one before; a rim that slips
// in between starts to roll again.
TEST(PublishedMethod, CountsTheWhirlOfTheLastTimeThatItRollsAlone) {
  Scenario scenario{.method = Method::rk4};
  scenario.parameters.loses_mass = false;
  SummaryObserver observer(scenario);
  Instant at = at_rest(scenario.parameters);
  at.state = {3.01e-3, 0, 0, 0, 0, 400};
  using enum ContactState;
  for (const ContactState contact : {free, sliding, rolling, rolling, sliding, rolling, rolling}) {
    at.contact = contact;
    at.time_s += 1;
    observer.on_instant(at);
    observer.should_continue({at.time_s, 400, -at.time_s});
  }
  EXPECT_EQ(observer.summary().whirl_from_s, 6);
  EXPECT_EQ(observer.summary().whirl_until_s, 7);
}

TEST(PublishedMethod, SaysWhereARunDiverges) {
  const Scenario stiff{.parameters = {.contact_stiffness = 1e13}, .method = Method::rk4};
  Steps steps;
  try {
    run(stiff, steps);
    FAIL() << "a step far beyond the limit of stability must not go unnoticed";
  } catch (const std::runtime_error& error) {
    double time_s = 0;
    ASSERT_EQ(std::sscanf(error.what(), "the rk4 run diverged at t = %lf s", &time_s), 1)
        << error.what();
    const double printed = 1e-6;
    EXPECT_NEAR(time_s, steps.all.back().time_s, printed);
  }
}

// The rim may slip either way.
TEST(PublishedMethod, CallsTheRimRollingWhereFrictionStopsItInAStepAlone) {
  for (const double speed : {400., -400.}) {
    Scenario scenario{.method = Method::rk4, .until = 1e-5};
    scenario.parameters.loses_mass = false;
    Instant from = at_rest(scenario.parameters);
    from.state = {3.01e-3, 0, 0, 0, 0, speed};
    from.contact = ContactState::sliding;
    from.event = Event::touch_down;  // has occurred, and must not be shown again
    Steps steps;
    run(scenario, from, steps);
    ASSERT_GT(steps.all.size(), 1U);
    for (std::size_t n = 1; n < steps.all.size(); ++n) {
      EXPECT_EQ(steps.all[n].contact, ContactState::sliding) << speed;
      EXPECT_EQ(steps.all[n].event, Event::none) << speed;
    }
  }
}

// The steps are long until one would touch the ring, and short from there on; the last one stops at
// the end of the run. Each advances the rotor by exactly its length.
TEST(PublishedMethod, TakesShortStepsFromTheFirstContactOnAndEndsOnTime) {
  Scenario scenario{.method = Method::rk4, .step_run_up = 1e-4, .step_rub = 5e-6};
  scenario.parameters.loses_mass = false;
  Instant from = at_rest(scenario.parameters);
  from.state = {2e-3, 0, 0, 1, 0, 400};
  for (const double until_s : {5e-3, 5e-3 + 2e-6, 5e-3 + 4.9999e-6}) {
    scenario.until = until_s;
    Steps steps;
    const RunEnd end = run(scenario, from, steps);
    bool is_short = false;
    long taken = 0;
    for (std::size_t n = 1; n < steps.all.size(); ++n) {
      const Instant &before = steps.all[n - 1], &after = steps.all[n];
      const double step = after.time_s - before.time_s;
      if (step == 0) continue;  // the end is shown again
      ++taken;
      is_short = is_short || step < 0.9e-4;
      EXPECT_NEAR(step, is_short ? 5e-6 : 1e-4, after.time_s == until_s ? 5e-6 : 1e-12) << n;
      EXPECT_NEAR(after.state[2] - before.state[2], step * (before.state[5] + after.state[5]) / 2,
                  1e-3 * step * after.state[5])
          << n;
      EXPECT_TRUE(is_short || after.contact == ContactState::free) << n;
    }
    EXPECT_TRUE(is_short);
    EXPECT_EQ(end.counters.steps, taken);
    EXPECT_EQ(steps.all.back().time_s, until_s);
  }
}

}  // namespace
}  // namespace rotor
