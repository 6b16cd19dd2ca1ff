/// Where whirl can last: closed forms against runs of single and of many rotors.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "figures/sweep/sweep.hpp"
#include "model/results/summary.hpp"
#include "model/theory/whirl.hpp"
#include "verification/support/bare.hpp"

namespace rotor {
namespace {

/// Supports, but neither gravity nor motor; the ring lets radial motion settle.
Scenario supported() {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.support_stiffness = Parameters{}.support_stiffness;
  p.support_damping = Parameters{}.support_damping;
  p.contact_damping = 0.2 * std::sqrt(p.contact_stiffness * p.mass);
  return scenario;
}

/// In contact with the ring, from a polar state of O.
Instant pressed(const Scenario& scenario, ContactState contact, double rho, double whirl,
                double speed) {
  Instant at = at_rest(scenario.parameters);
  at.motor_on = false;
  at.contact = contact;
  at.state = {rho, 0, 0, 0, (whirl - speed) * rho, speed};
  return at;
}

struct BackwardRolling : testing::Test {
  static constexpr double speed = 300;  // rad/s
  Scenario scenario = supported();

  EventRecorder rolled(double duration_s) const {
    const Whirl whirl(scenario.parameters);
    const double rate = whirl.rolling_rate(speed);
    const Parameters& p = scenario.parameters;
    const double rho = p.rotor_radius * speed / rate;
    Instant at = pressed(scenario, ContactState::rolling, rho, -rate, speed);
    // As fast as it shrinks where friction slows it down: r w' = (1 + s) rho Omega'.
    const double s = whirl.shrinking(rate);
    const double pressure = at.body.mass * rate * rate - p.support_stiffness;
    const double slowing =
        whirl.rolling_friction(speed) * pressure * rho * p.rotor_radius / at.body.inertia;
    at.state[3] = -s * p.rotor_radius * slowing / ((1 + s) * rate);
    EventRecorder run;
    follow(scenario, at, duration_s, run);
    return run;
  }
};

TEST_F(BackwardRolling, GoesOnAtTheClosedFormsRateWithoutDampers) {
  scenario.parameters.support_damping = 0;
  scenario.parameters.friction = 1;
  const Instant last = rolled(0.05).last();
  ASSERT_EQ(last.contact, ContactState::rolling);
  const double rho =
      scenario.parameters.rotor_radius * speed / Whirl(scenario.parameters).rolling_rate(speed);
  EXPECT_NEAR(std::hypot(last.state[0], last.state[1]), rho, 1e-12);  // of 3.7 mm
  EXPECT_NEAR(last.state[5] / speed, 1, 1e-10);
}

TEST_F(BackwardRolling, NeedsTheFrictionOfTheClosedForm) {
  scenario.parameters.support_damping = 200;  // so that friction has work to do
  const double least = Whirl(scenario.parameters).rolling_friction(speed);
  EXPECT_GT(least, 2e-3);
  // The start is not exactly the settled motion, and the force oscillates by 2 %.
  scenario.parameters.friction = 1.03 * least;
  EXPECT_EQ(rolled(1e-3).count(Event::break_away), 0);
  scenario.parameters.friction = 0.97 * least;
  EXPECT_GT(rolled(1e-3).count(Event::break_away), 0);
}

/// Forward rub, with C at the place for the largest possible friction.
struct SynchronousRub : testing::Test {
  static constexpr double speed = 900, duration_s = 0.1;  // beyond the limit O falls behind in less

  /// Whether O keeps its place relative to C at a multiple of the closed form's friction.
  bool lasts(Scenario scenario, double of_limit) const {
    Parameters& p = scenario.parameters;
    p.friction = of_limit * Whirl(p).synchronous_friction(speed);
    const Body<double> body = MassLoss<double>(p).after;
    const double clearance = p.stator_radius - p.rotor_radius;
    const double pressure = body.mass * speed * speed - p.support_stiffness;
    const double slowing = body.mass * p.rotor_radius * clearance / body.inertia;
    const double mu = p.friction * (1 - slowing), phi = std::atan2(1, -mu);
    const double force =
        pressure * clearance + body.mass * speed * speed * body.eccentricity * std::cos(phi);
    const double rho = clearance + force / p.contact_stiffness;
    // In the axes that turn with the rotor, C lies along x: O is behind it by phi, and at rest.
    Instant at = pressed(scenario, ContactState::sliding, rho, speed, speed);
    at.state[0] = rho * std::cos(phi);
    at.state[1] = -rho * std::sin(phi);
    at.body = body;
    at.mass_lost = true;
    bool behind = false;  // O by a quarter turn or more than where it began
    MotionObserver watch(0, duration_s, [&](const DenseOutput& motion) {
      const State<double> q = motion.at(motion.until_s).state;
      behind = behind || q[0] * at.state[0] + q[1] * at.state[1] < 0;
    });
    follow(scenario, at, duration_s, watch);
    return !behind;
  }
};

TEST_F(SynchronousRub, LastsUpToTheClosedFormsFriction) {
  // A driven rotor keeps its speed. A free one does not, and would outrun the limit if the supports
  // took much of its speed.
  for (const auto& [inertia, damping] : {std::pair(1e9, 25.), {1e9, 500.}, {9e-3, 25.}}) {
    Scenario scenario = supported();
    scenario.parameters.inertia = inertia;
    scenario.parameters.support_damping = damping;
    scenario.parameters.eccentricity = Parameters{}.eccentricity;
    EXPECT_TRUE(lasts(scenario, 0.97)) << inertia << ' ' << damping;
    EXPECT_FALSE(lasts(scenario, 1.03)) << inertia << ' ' << damping;
  }
}

// Below the critical speed, about it and above, with C ahead of O by any angle.
TEST(SynchronousFriction, IsTheGreatestThatSomePlaceOfTheMassCentreAllows) {
  std::mt19937_64 lot(3);
  const auto between = [&](double least, double greatest) {
    return least * std::pow(greatest / least, std::uniform_real_distribution<double>()(lot));
  };
  int none = 0, any = 0, limited = 0, below_critical = 0, wide = 0;
  for (int n = 0; n < 400; ++n) {
    Parameters p;
    p.support_damping = between(1, 700);
    const bool is_wide = n % 4 == 0;  // friction that slows the rotor leaves C behind
    p.stator_radius = p.rotor_radius + (is_wide ? between(0.04, 0.2) : between(1e-4, 5e-3));
    if (is_wide) p.eccentricity = between(1e-3, 0.1);
    p.unbalance_factor = is_wide ? 1 : between(1, 8);
    const Body<double> body = MassLoss<double>(p).after;
    const double critical = std::sqrt(p.support_stiffness / body.mass);
    // Of wide rings each second one just below the critical speed.
    const double speed = n % 8 == 0 ? critical * between(0.9, 1) : between(10, 1000);
    const double w2 = speed * speed;
    const double clearance = p.stator_radius - p.rotor_radius;
    double greatest = 0;
    bool is_pressed_in_balance = false;
    constexpr int places = 20'000;
    for (int i = 0; i < places; ++i) {
      const double phi = (is_wide ? 2 : 1) * std::numbers::pi * i / places;
      const double force = (body.mass * w2 - p.support_stiffness) * clearance +
                           body.mass * w2 * body.eccentricity * std::cos(phi);
      const double friction = body.mass * w2 * body.eccentricity * std::sin(phi) -
                              p.support_damping * speed * clearance;
      // The friction slows the rotor down, which brings C ahead.
      const double spared =
          1 - body.mass * p.rotor_radius * clearance / body.inertia;  // of the friction
      if (!(force > 0 && friction * spared >= 0)) continue;
      is_pressed_in_balance = true;
      greatest = std::max(greatest, friction / force / spared);
    }
    const double limit = Whirl(p).synchronous_friction(speed);
    const bool is_below = body.mass * w2 < p.support_stiffness;
    if (!is_pressed_in_balance) {
      ++none;
      EXPECT_EQ(limit, 0) << n;
    } else if (std::isinf(limit)) {
      ++any;
      EXPECT_GT(greatest, 100) << n;
      below_critical += is_below;
    } else {
      ++limited;
      wide += is_wide;
      EXPECT_NEAR(greatest / limit, 1, 1e-3) << n;
    }
  }
  EXPECT_GT(none, 50);
  EXPECT_GT(any, 50);
  EXPECT_GT(limited, 50);
  EXPECT_GT(below_critical, 10);
  EXPECT_GT(wide, 20);
}

}  // namespace
}  // namespace rotor
