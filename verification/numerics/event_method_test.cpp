/// What the event-located method promises to its observers.
#include <gtest/gtest.h>

#include <map>

#include "figures/input/names.hpp"
#include "figures/record/recorder.hpp"
#include "verification/support/follow.hpp"

namespace rotor {
namespace {

TEST(EventMethod, GivesTheSameBitsWhoeverWatches) {
  const Scenario scenario{};
  const RunEnd unwatched = run(scenario, nobody);
  Recorder recorder({.from_s = 29.11, .length_s = 0.05},
                    {find_column("time_s"), find_column("normal_force_N"), find_column("rho_m")},
                    scenario, 1e-4, [](auto) {});
  EXPECT_EQ(run(scenario, recorder).last.state, unwatched.last.state);
  EXPECT_GT(recorder.rows(), 1000);
}

TEST(EventMethod, ShowsBothSidesOfEveryEventAndNoEventTwice) {
  struct : EventRecorder {
    void on_instant(const Instant& at) override {
      EventRecorder::on_instant(at);
      instants.push_back(at);
    }
    std::vector<Instant> instants;
  } recorder;
  run({.parameters = {.friction = 0.08}, .equations = Equations::published}, recorder);
  const auto& seen = recorder.instants;
  double last_event = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].event == Event::none) continue;
    ASSERT_GT(i, 0U);
    EXPECT_EQ(seen[i - 1].time_s, seen[i].time_s) << "before " << name_of(seen[i].event);
    EXPECT_GT(seen[i].time_s, last_event) << name_of(seen[i].event);
    last_event = seen[i].time_s;
  }
  // Each contact is begun once and released once before the next one; the 41st lasts.
  EXPECT_EQ(recorder.count(Event::touch_down), 41);
  EXPECT_EQ(recorder.count(Event::ring_clear), 40);
}

/// What a run that cannot go on says.
std::string refusal(const Scenario& scenario, const Instant& from) {
  try {
    follow(scenario, from, 29, nobody);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(EventMethod, SaysWhereAMotionThatIsNotFiniteEndsIt) {
  const Scenario scenario{};
  Instant at = at_rest(scenario.parameters);
  at.time_s = 1.5;
  at.state[4] = std::numeric_limits<double>::quiet_NaN();
  for (const char* part : {"t = 1.5", "the motion is not finite"})
    EXPECT_NE(refusal(scenario, at).find(part), std::string::npos) << refusal(scenario, at);
}

// Under such a weight it would turn by 10^16 rad in its first second.
TEST(EventMethod, EndsARunThatMakesNoProgress) {
  const Scenario scenario{.parameters = {.gravity = 1e31}};
  const std::string said = refusal(scenario, at_rest(scenario.parameters));
  EXPECT_NE(said.find("no progress"), std::string::npos) << said;
}

// However long the steps are, the guard vanishes at its event, to some rounding errors of the terms
// of which it is the difference.
TEST(EventMethod, LocatesEventsToRoundingAtEveryTolerance) {
  std::map<Event, int> seen;
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9})
    for (const double friction : {0.08, 0.3}) {
      Scenario scenario{.parameters = {.friction = friction},
                        .start_speed_Hz = 149.998,
                        .until = 0.25,
                        .tolerance = tolerance};
      scenario.parameters.mass_loss_time = 1e-3;
      const RotorSystem<double> rotor(scenario.parameters, scenario.equations);
      const Ring<double>& ring = rotor.ring;
      const EventRecorder recorder = recorded(scenario);
      for (const Instant& at : recorder.events()) {
        ++seen[at.event];
        const auto k = ring.rim_point(at.motion());
        const double rim = ring.rotor_radius * std::abs(at.motion().speed);
        const auto is = [&](Event one, Event other) {
          return at.event == one || at.event == other;
        };
        const auto [residual, size] =
            at.event == Event::motor_off
                ? std::pair(at.motion().speed - rotor.motor_off, rotor.motor_off)
            : is(Event::touch_down, Event::ring_clear) ? std::pair(k.indentation, ring.clearance)
            : is(Event::release, Event::renewed_contact)
                ? std::pair(ring.elastic_force(k),
                            ring.law.spring_force(ring.clearance) + ring.law.damping() * rim)
            : is(Event::rolling_onset, Event::slip_reversal) ? std::pair(k.slip_velocity, rim)
                                                             : std::pair(0., 1.);
        EXPECT_LE(std::abs(residual), 1e-13 * size)
            << name_of(at.event) << ' ' << tolerance << ' ' << friction << ' ' << at.time_s;
      }
    }
  for (const Event event : {Event::motor_off, Event::touch_down, Event::ring_clear, Event::release,
                            Event::rolling_onset})
    EXPECT_GE(seen[event], 4) << name_of(event);
}

}  // namespace
}  // namespace rotor
