/// Events that are easily missed, doubled or misplaced, of a rotor that oscillates along a line.
#include <gtest/gtest.h>

#include <numbers>

#include "model/simulation/event_method.hpp"
#include "verification/support/follow.hpp"

namespace rotor {
namespace {

// A rotor without unbalance, gravity and damping: O oscillates along a line, with the
// eigenfrequency of the supports, and touches the ring if its amplitude exceeds the clearance.
class Oscillation : public testing::Test {
 protected:
  Oscillation() {
    scenario_.parameters.eccentricity = 0;
    scenario_.parameters.gravity = 0;
    scenario_.parameters.support_damping = 0;
    scenario_.parameters.contact_damping = 0;
    scenario_.parameters.torque = 0;
    scenario_.parameters.friction = 0;
    scenario_.parameters.separates = false;
    scenario_.until = 0.2;
  }

  double clearance() const { return Ring<double>(scenario_.parameters).clearance; }
  double frequency() const {
    return std::sqrt(scenario_.parameters.support_stiffness / scenario_.parameters.mass);
  }

  /// From the centre, with the velocity that gives this amplitude.
  Instant with_amplitude(double amplitude) const {
    Instant at = at_rest(scenario_.parameters);
    at.state = {0, 0, 0, 0.6 * amplitude * frequency(), 0.8 * amplitude * frequency(), 0};
    return at;
  }

  EventRecorder run_from(const Instant& at) const {
    EventRecorder run;
    follow(scenario_, at, scenario_.until, run);
    return run;
  }

  Scenario scenario_;
};

TEST_F(Oscillation, TouchesAtTheTimeOfTheClosedForm) {
  const EventRecorder run = run_from(with_amplitude(2 * clearance()));
  const double touch = std::asin(0.5) / frequency();
  const auto contacts = run.events(Event::touch_down);
  ASSERT_FALSE(contacts.empty());
  EXPECT_NEAR(contacts.front().time_s, touch, 1e-13);  // default tolerance over a few steps
  EXPECT_NEAR(contacts.front().motion().displacement.norm(), clearance(), 1e-18);
  EXPECT_GE(contacts.front().motion().displacement.norm() - clearance(), -1e-18);
}

TEST_F(Oscillation, GlancingContactIsMissedByNoStepSize) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    scenario_.tolerance = tolerance;
    // The tolerance of a step is a part of 1/300 of the clearance; hundreds of steps may add up.
    const double margin = tolerance;
    EXPECT_FALSE(
        run_from(with_amplitude(clearance() * (1 + margin))).events(Event::touch_down).empty())
        << tolerance;
    EXPECT_TRUE(run_from(with_amplitude(clearance() * (1 - margin))).events().empty()) << tolerance;
  }
}

TEST_F(Oscillation, ShortContactsBetweenLongFlightsAreAllFound) {
  // Half a period of the supports, 50 ms, between contacts of 0.25 ms: four in 0.2 s.
  const EventRecorder run = run_from(with_amplitude(1.001 * clearance()));
  EXPECT_EQ(run.events(Event::touch_down).size(), 4U);
}

TEST_F(Oscillation, ContactAtTheEndOfARunIsSeenOnce) {
  const Instant first = with_amplitude(2 * clearance());
  const double touch = run_from(first).events(Event::touch_down).front().time_s;
  for (const double end : {touch, std::nextafter(touch, 0), std::nextafter(touch, 1)}) {
    EventRecorder run;
    EventMethod<double> method(scenario_, scenario_.tolerance, first);
    method.advance(end, run);
    method.advance(touch + 1e-4, run);
    EXPECT_EQ(run.events(Event::touch_down).size(), 1U) << end - touch;
  }
}

TEST_F(Oscillation, HeadOnImpactAtZeroSlipGoesStraightToRolling) {
  scenario_.parameters.friction = 0.3;
  Instant first = at_rest(scenario_.parameters);
  first.state[3] = 2 * clearance() * frequency();  // along an axis, where the slip is zero exactly
  const EventRecorder run = run_from(first);
  const auto contacts = run.events(Event::touch_down);
  ASSERT_FALSE(contacts.empty());
  EXPECT_EQ(contacts.front().contact, ContactState::rolling);
}

TEST_F(Oscillation, ImpactsAtASlipOfRoundingSizeDoNotChatter) {
  scenario_.parameters.friction = 0.3;
  scenario_.until = 2;
  const EventRecorder run = run_from(with_amplitude(2 * clearance()));
  // A contact every 16.8 ms, of no more events than touch-down, rolling, break-away, release,
  // clear.
  EXPECT_EQ(run.events(Event::touch_down).size(), 119U);
  EXPECT_LE(run.events().size(), 5 * 119U);
}

TEST_F(Oscillation, MotorOffAndContactAtOneInstantBothHappenOnce) {
  scenario_.parameters.torque = 0.3;
  Instant first = with_amplitude(2 * clearance());
  const Instant touch = run_from(first).events(Event::touch_down).front();
  for (const double shift : {-1e-16, 0., 1e-16}) {
    scenario_.parameters.motor_off_Hz = touch.state[5] / (2 * std::numbers::pi) * (1 + shift);
    scenario_.until = touch.time_s + 1e-4;
    const EventRecorder run = run_from(first);
    EXPECT_EQ(run.events(Event::touch_down).size(), 1U) << shift;
    EXPECT_EQ(run.events(Event::motor_off).size(), 1U) << shift;
  }
}

TEST_F(Oscillation, KeepsItsEnergyThroughElasticImpacts) {
  scenario_.parameters.contact_stiffness = 1e6;
  const Instant first = with_amplitude(2 * clearance());
  const auto energy = [&](const Instant& at) {
    const auto motion = at.motion();
    const double rho = motion.displacement.norm();
    const double indentation = std::max(0., rho - clearance());
    return kinetic_energy(at.body, motion) +
           scenario_.parameters.support_stiffness * rho * rho / 2 +
           scenario_.parameters.contact_stiffness * indentation * indentation / 2;
  };
  const EventRecorder run = run_from(first);
  EXPECT_GT(run.events(Event::touch_down).size(), 3U);
  EXPECT_NEAR(energy(run.last()) / energy(first), 1, 1e-9);
}

}  // namespace
}  // namespace rotor
