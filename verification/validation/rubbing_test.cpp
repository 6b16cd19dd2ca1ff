/// Published results on rubbing at constant speed, and on rotors that do not pass their resonance.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

#include "figures/results/run_result.hpp"
#include "model/theory/whirl.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// Without mass loss, at a constant speed.
Scenario held(const Parameters& parameters, double speed, double until_s) {
  Scenario scenario{.parameters = parameters,
                    .equations = Equations::corrected,
                    .start_speed_Hz = speed / two_pi,
                    .until = until_s};
  scenario.parameters.drive = Drive::constant_speed;
  return scenario;
}

/// On the circle of synchronous rub, or so much farther out.
Scenario on_circle(const Parameters& p, double speed, double until_s, double outwards = 0) {
  Scenario scenario = held(p, speed, until_s);
  const double rho = Whirl(p).synchronous_radius(speed, p.friction).value();
  const std::complex<double> i(0, 1);
  const double pressed = p.contact_stiffness * (1 - (p.stator_radius - p.rotor_radius) / rho);
  const std::complex<double> O = p.mass * p.eccentricity * speed * speed /
                                 (p.support_stiffness - p.mass * speed * speed + pressed +
                                  i * (p.support_damping * speed + p.friction * pressed));
  EXPECT_NEAR(std::abs(O) / rho, 1, 1e-11);  // k_t x is a small difference
  const std::complex<double> at = O * (1 + outwards), velocity = i * speed * at;
  scenario.start = Start{at.real(), at.imag(), velocity.real(), velocity.imag()};
  return scenario;
}

/// The largest change of |r_O| from a radius in the first and in the last tenth of a run.
std::array<double, 2> deviations(const Scenario& scenario, double radius) {
  std::array<double, 2> largest{};
  MotionObserver look(0, scenario.until, [&](const DenseOutput& motion) {
    for (int n = 0; n < 8; ++n) {
      const double time_s = motion.from_s + (motion.until_s - motion.from_s) * n / 8;
      const double share = time_s / scenario.until;
      if (share > 0.1 && share < 0.9) continue;
      double& of = largest[share < 0.5 ? 0 : 1];
      of = std::max(of, std::abs(motion.at(time_s).motion().displacement.norm() - radius));
    }
  });
  run(scenario, look);
  return largest;
}

/// Of Jiang and Ulbrich's rotor, with lengths in eccentricities: m = k = 1.
Parameters dimensionless(double friction) {
  return {.mass = 1,
          .eccentricity = 1,
          .support_stiffness = 1,
          .support_damping = 0.1,
          .contact_stiffness = 25,
          .contact_damping = 0,
          .friction = friction,
          .rotor_radius = 21,
          .stator_radius = 22.05,
          .unbalance_factor = 1,
          .loses_mass = false};
}

/// The paper's rotor with the unbalance that it has after its mass loss.
Parameters unbalanced(double ring_damping, double friction) {
  return {.eccentricity = 0.45e-3,
          .contact_damping = ring_damping,
          .friction = friction,
          .unbalance_factor = 1,
          .loses_mass = false};
}

struct Border {
  double speed, stable, whip_from, whip_to;
};
constexpr auto borders = std::to_array<Border>({{0.9, .0606, .145, .146},
                                                {1, .0547, .123, .124},
                                                {1.2, .0461, .095, .096},
                                                {1.5, .0379, .068, .069},
                                                {2, .0305, .045, .046}});

TEST(SynchronousCircle, HasItsBorderOfStabilityWhereJiangAndUlbrichHaveIt) {
  for (const Border& border : borders)
    EXPECT_NEAR(Whirl(dimensionless(0.01)).stable_synchronous_friction(border.speed), border.stable,
                0.5e-4)
        << border.speed;
  Parameters p = unbalanced(4142.96, 0);  // whose circle ends at mu = 0.7424
  p.mass = 5.6656, p.support_stiffness = 35105.3, p.support_damping = 30.6275;
  p.eccentricity = 0.512964e-3, p.contact_stiffness = 1.87337e9, p.stator_radius = 60.869114e-3;
  EXPECT_NEAR(Whirl(p).stable_synchronous_friction(498.3858), 0.7414, 1e-4);
}

// The circle is a solution of the engine's equations, too.
TEST(SynchronousCircle, StaysOnItsCircle) {
  for (const double friction : {0.01, 0.05, 0.1})
    for (const double frequency_Hz : {100., 150.}) {
      const Parameters p = unbalanced(1e4, friction);
      const double speed = two_pi * frequency_Hz;
      const Scenario scenario = on_circle(p, speed, 1);
      const double rho = Whirl(p).synchronous_radius(speed, friction).value();
      EXPECT_LT(deviations(scenario, rho)[1], 1e-9 * rho) << friction << ' ' << frequency_Hz;
    }
}

// A disturbance decays below the border and grows above it.
TEST(SynchronousCircle, IsStableBelowTheBorderOnly) {
  const auto expect_border = [](Parameters p, double speed, double until_s) {
    const double border = Whirl(p).stable_synchronous_friction(speed);
    ASSERT_TRUE(std::isfinite(border));
    for (const double factor : {0.95, 1.05}) {
      p.friction = factor * border;
      const double clearance = p.stator_radius - p.rotor_radius;
      const double rho = Whirl(p).synchronous_radius(speed, p.friction).value();
      const double disturbance = 1e-3 * (rho - clearance) / rho;
      const auto [first, last] = deviations(on_circle(p, speed, until_s, disturbance), rho);
      EXPECT_EQ(last < first, factor < 1) << border << ' ' << first << ' ' << last;
    }
  };
  for (const Border& border : borders) expect_border(dimensionless(0), border.speed, 1000);
  for (const double ring_damping : {0., 100., 1000.})
    expect_border(unbalanced(ring_damping, 0), two_pi * 150, 2);
}

// Friction at which that rotor comes to roll backwards within 320 turns of its natural vibration,
// from its circle, from somewhat outside of it, and from rest at the centre.
TEST(DryWhip, BeginsAboveTheBorderOfTheCircle) {
  for (const Border& border : borders)
    for (const double friction : {border.whip_from, border.whip_to})
      for (const double outwards : {0., 1e-2, -1.}) {
        const Scenario scenario = on_circle(dimensionless(friction), border.speed, 2000, outwards);
        EXPECT_EQ(summary_of(scenario).outcome == Outcome::rolling, friction == border.whip_to)
            << border.speed << ' ' << friction << ' ' << outwards;
      }
}

// Whirl that rolls saturates below the natural frequency of rotor, supports and ring together.
TEST(DryWhirl, SaturatesAtTheCoupledNaturalFrequency) {
  double last_Hz = 0;
  for (const auto& [speed_Hz, whirl_Hz] : {std::pair(50., 832.),
                                           {150, 1458},
                                           {400, 1791},
                                           {1000, 1933},
                                           {3000, 1999},
                                           {10000, 2023}}) {
    Scenario scenario{.equations = Equations::corrected, .start_speed_Hz = speed_Hz, .until = 0.5};
    Parameters& p = scenario.parameters;
    p.drive = Drive::constant_speed;
    p.unbalance_factor = 9;
    p.mass_loss_time = 0;
    last_Hz = -summary_of(scenario).whirl_frequency_Hz.value_or(0);
    EXPECT_NEAR(last_Hz, whirl_Hz, 0.5) << speed_Hz;
    const double bound_Hz = in_Hz(natural_frequency(p.support_stiffness + p.contact_stiffness,
                                                    MassLoss<double>(p).after.mass));
    EXPECT_LT(last_Hz, bound_Hz);
    EXPECT_NEAR(bound_Hz, 2033, 0.5);
  }
}

// Sommerfeld's effect: a weak motor does not take the rotor through its resonance.
TEST(LimitedPower, LeavesTheRotorBelowItsResonance) {
  for (const auto& [torque, speed_Hz] :
       {std::pair(0.004, 9.840070360089), {0.0056, 10.033427780885}, {0.0057, 10.071078039440}}) {
    Scenario scenario{.equations = Equations::corrected, .start_speed_Hz = 8, .until = 1000};
    scenario.parameters.gravity = 0;
    scenario.parameters.loses_mass = false;
    scenario.parameters.torque = torque;
    EXPECT_NEAR(summary_of(scenario).final_speed_Hz, speed_Hz, 1e-10) << torque;
    scenario.parameters.torque = 0.0058;
    EXPECT_GT(summary_of(scenario).final_speed_Hz, 11);
  }
}

}  // namespace
}  // namespace rotor
