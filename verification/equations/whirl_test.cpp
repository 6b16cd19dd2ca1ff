/// Closed forms of rolling and of sliding whirl.
#include "model/theory/whirl.hpp"

#include <gtest/gtest.h>

#include "verification/support/bare.hpp"
#include "verification/support/law.hpp"

namespace rotor {
namespace {

/// A rotor without unbalance that is pressed against the ring by its own whirl.
State<double> whirling(const Parameters& p, double indentation, double speed, double slip) {
  const double rho = p.stator_radius - p.rotor_radius + indentation;
  const double tangential = slip - p.rotor_radius * speed;
  return {rho, 0, 0, 0, tangential - speed * rho, speed};
}

TEST(RollingInTheRing, SlowsDownWithTheSupportsDampingAtTheClosedFormsRate) {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.friction = 3;
  p.contact_damping = 1e4;
  p.contact_stiffness = 1e11;  // rho stays constant
  p.support_damping = 25;
  const double speed = 200, tangential = p.rotor_radius * speed;
  const double indentation = p.mass * tangential * tangential / 3e-3 / p.contact_stiffness;
  Instant at = at_rest(p);
  at.motor_on = false;
  at.contact = ContactState::rolling;
  at.state = whirling(p, indentation, speed, 0);
  const double duration = 0.2;
  const Instant last = follow(scenario, at, duration, nobody).last;
  ASSERT_EQ(last.contact, ContactState::rolling);
  const double rate = p.support_damping / (p.mass + p.inertia / (p.rotor_radius * p.rotor_radius));
  // Exact for constant rho; it changes by Delta / rho = 1e-3 over the run, and its rate is 5e-3 /
  // s.
  Law("rate at which the supports' damping slows rolling", 5e-3)
      .expect_left(std::log(speed / last.state[5]) / (rate * duration) - 1);
}

/// Dry-friction whirl: a rotor without unbalance, with too much inertia for friction to slow it
/// down, slides around the ring backwards at the rate Omega, opposed only by the supports' damping.
struct SlidingWhirl : testing::Test {
  SlidingWhirl() {
    Parameters& p = scenario.parameters;
    p.support_stiffness = Parameters{}.support_stiffness;
    p.support_damping = 2 * zeta * p.mass * w_n();
    p.contact_stiffness = beta * p.support_stiffness;
    p.contact_damping = 0.2 * std::sqrt(p.contact_stiffness * p.mass);  // radial motion settles
    p.friction = 0.4;
    p.inertia = 1e9;
  }

  double w_n() const {
    return std::sqrt(scenario.parameters.support_stiffness / scenario.parameters.mass);
  }

  /// How a whirl at that rate and indentation ends: rolling if it has grown, released if it dies.
  Event fate(double whirl, double indentation) const {
    const Parameters& p = scenario.parameters;
    const double rho = p.stator_radius - p.rotor_radius + indentation;
    const double speed = 5 * whirl * rho / p.rotor_radius;  // far from rolling
    Instant at = at_rest(p);
    at.motor_on = false;
    at.contact = ContactState::sliding;
    at.state = whirling(p, indentation, speed, p.rotor_radius * speed - whirl * rho);
    EventRecorder run;
    follow(scenario, at, 30, run);
    const auto ends = [](const Instant& i) {
      return i.event == Event::rolling_onset || i.event == Event::release;
    };
    const auto end = std::ranges::find_if(run.events(), ends);
    return end == run.events().end() ? Event::none : end->event;
  }

  static constexpr double zeta = 0.1, beta = 10;
  Scenario scenario = bare();
};

TEST_F(SlidingWhirl, GrowsAboveTheRateOfTheClosedFormAndDiesBelowIt) {
  const Parameters& p = scenario.parameters;
  const double whirl = Whirl(p).separatrix_rate(p.friction);
  // Friction balances damping: mu k_t Delta = d Omega rho.
  const double share = p.support_damping * whirl / (p.friction * p.contact_stiffness);
  const double indentation = (p.stator_radius - p.rotor_radius) * share / (1 - share);
  // A relative deviation of 1e-9 grows by e every 0.15 s or less, to its end within 30 s.
  EXPECT_EQ(fate(whirl * (1 + 1e-9), indentation), Event::rolling_onset);
  EXPECT_EQ(fate(whirl * (1 - 1e-9), indentation), Event::release);
}

TEST_F(SlidingWhirl, NeedsTheFrictionOfTheClosedFormHoweverDeepItBegins) {
  const double whirl = w_n() * std::sqrt(1 + beta);  // of a rotor with negligible clearance
  const double least = Whirl(scenario.parameters).whip_friction(), deep = 100 * 3e-3;
  // The clearance, a hundredth of the indentation, moves the limit by about as much.
  scenario.parameters.friction = 1.05 * least;
  EXPECT_EQ(fate(whirl, deep), Event::rolling_onset);
  scenario.parameters.friction = 0.95 * least;
  EXPECT_EQ(fate(whirl, deep), Event::release);
}

}  // namespace
}  // namespace rotor
