/// The synchronous motion that flight subtracts: exactly, and so that little is left that turns.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "model/phases/flight.hpp"
#include "model/run/simulation.hpp"

namespace rotor {
namespace {

using S = long double;

/// A flight at a speed in rad/s whose synchronous motion is complete.
struct Run : testing::TestWithParam<Equations> {
  Run() : rotor(Parameters{}, GetParam()) {}

  FlightChart<S> chart(const S& speed) const {
    FlightChart<S> laid(rotor, {-1.5e-4L, 0, 0, 0, 0, speed});
    std::array<S, 6> turned_far = {0, 0, 40, 0, 0, 0};
    laid.recentre(turned_far);
    return laid;
  }

  RotorSystem<S> rotor;
};

// Whatever is subtracted, the rates of the unknowns are those of the paper's coordinates, Eq. (3).
// Numerical differentiation over 1e-6 of a radian tells some 1e-11 of the largest rates.
TEST_P(Run, IsSubtractedExactly) {
  for (const S speed : {S(100), S(300), S(900)}) {
    const FlightChart<S> chart = this->chart(speed);
    const FreeFlight<S> phase(rotor, chart);
    for (int n = 0; n < 20;
         ++n) {  // on and off the synchronous motion, far beyond its speed as well
      const S u = std::sin(S(n)), v = std::cos(S(3 * n)), h = 1e-6L / speed;
      const std::array<S, 6> x = {1e-4L * u, -2e-4L * v, 6 * v,
                                  0.01L * v, 0.02L * u,  speed / 20 * u};
      std::array<S, 6> rates;
      phase(x, rates, 0);
      const auto state_at = [&](const S& time) {
        std::array<S, 6> moved = x;
        for (std::size_t i = 0; i < 6; ++i) moved[i] += time * rates[i];
        return chart.state(moved);
      };
      const State<S> q = state_at(0), before = state_at(-h), after = state_at(h);
      const Motion<S> m = RotatingFrame<S>::motion(rotor.body, q);
      const State<S> exact =
          RotatingFrame<S>::rates(m, q, acceleration(rotor.body, m, rotor.loads(m)));
      const State<S> largest = {0.1L, 0.1L, speed, 100, 100, 40};
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_LT(std::abs((after[i] - before[i]) / (2 * h) - exact[i]), 1e-9L * largest[i])
            << speed << ' ' << n << ' ' << i;
    }
  }
}

// The axes follow a rotor that has turned far, in either sense; the motion stays the same.
TEST_P(Run, IsSeenFromAxesThatFollowTheRotor) {
  for (const S speed : {S(5), S(-5), S(300), S(-300)})
    for (const S angle : {S(-1e4), S(-33), S(-31), S(31), S(33), S(1e4)}) {
      const State<S> q = {-1.5e-4L, 1e-5L, 0.3L, 0.01L, 0.02L, speed};
      FlightChart<S> chart(rotor, q);
      std::array<S, 6> x = chart.unknowns(q);
      chart.recentre(x);
      x[2] += angle;
      const State<S> before = chart.state(x);
      EXPECT_EQ(chart.recentre(x), std::abs(angle) > 32) << speed << ' ' << angle;
      if (std::abs(angle) > 32) {
        EXPECT_LT(std::abs(x[2]), 1) << speed << ' ' << angle;
      }
      const State<S> after = chart.state(x);
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_LT(std::abs(after[i] - before[i]), 1e-14L * (1 + std::abs(before[i])))
            << speed << ' ' << angle << ' ' << i;
    }
}

/// The part of a function of the angle that turns n times with it.
template <class Function>
double harmonic(int n, const Function& f) {
  constexpr int points = 16;
  std::array<S, 2> sum{};
  for (int k = 0; k < points; ++k) {
    const S angle = 2 * std::numbers::pi_v<S> * k / points;
    sum[0] += f(angle) * std::cos(n * angle) * 2 / points;
    sum[1] += f(angle) * std::sin(n * angle) * 2 / points;
  }
  return static_cast<double>(std::hypot(sum[0], sum[1]));
}

// Half a per cent above the speed that it was worked out for, C standing where the ripple lets it.
TEST_P(Run, LeavesNothingThatTurnsAboveTheTolerance) {
  for (const S speed : {S(700), S(900)}) {
    const FlightChart<S> chart = this->chart(speed);
    const FreeFlight<S> phase(rotor, chart);
    const auto rates = [&](const S& angle, const std::array<S, 2>& rest) {
      std::array<S, 6> result;
      phase({rest[0], rest[1], angle, 0, 0, speed / 200}, result, 0);
      return result;
    };
    std::array<S, 2> rest{};  // where the springs balance what is left that stands still
    for (int k = 0; k < 16; ++k) {
      const auto left = rates(2 * std::numbers::pi_v<S> * k / 16, {});
      rest[0] += left[3] / 16 * rotor.body.mass / rotor.supports.springs.force(S(1));
      rest[1] += left[4] / 16 * rotor.body.mass / rotor.supports.springs.force(S(1));
    }
    // Of the default tolerance 1e-11, in the scales of flight: clearance / 300, speed / 5000.
    const S length = 1e-11L * 3e-3L / 300;
    const std::array<S, 6> allowed = {length * speed,         length * speed,
                                      1e-11L * speed,         length * speed * speed,
                                      length * speed * speed, 1e-11L * speed * speed / 5000};
    for (int n = 1; n <= 3; ++n)
      for (std::size_t i = 0; i < 6; ++i)
        EXPECT_LT(harmonic(n, [&](const S& angle) { return rates(angle, rest)[i]; }),
                  static_cast<double>(allowed[i]))
            << speed << ' ' << n << ' ' << i;
  }
}

INSTANTIATE_TEST_SUITE_P(UpInSpeed, Run,
                         testing::Values(Equations::published, Equations::consistent),
                         [](const auto& equations) {
                           return equations.param == Equations::published ? "Published"
                                                                          : "Consistent";
                         });

/// As far as the steps of the published method tell, which are of fourth order without contact.
void expect_end_of_fixed_steps(Scenario scenario) {
  Observer null_observer;
  const double speed = run(scenario, null_observer).last.state[5];
  scenario.method = Method::rk4;
  scenario.step_run_up = scenario.step_rub = 1e-4;
  EXPECT_NEAR(run(scenario, null_observer).last.state[5] / speed, 1, 1e-9)
      << scenario.start_speed_Hz << ' ' << speed;
}

// Heavy for its inertia, which gravity makes run slow and fast again within a few turns.
TEST(SpeedThatChangesFast, IsThatOfFixedSteps) {
  Scenario scenario{.equations = Equations::published, .until = 1};
  Parameters& p = scenario.parameters;
  p.stator_radius = p.rotor_radius + 0.0152;
  p.eccentricity = 1.7e-4;
  p.torque = 0;
  p.support_stiffness = 280;
  p.support_damping = 0;
  p.inertia = 0.0036;
  p.unbalance_factor = 4.7;
  p.mass_loss_time = 0;
  for (int n = 0; n <= 26; ++n) {
    scenario.start_speed_Hz = 4.465 + 0.01 * n;
    expect_end_of_fixed_steps(scenario);
  }
}

TEST(SpeedThatChangesFast, IsThatOfFixedStepsWithoutSupports) {
  Scenario scenario{.equations = Equations::published, .until = 1};
  Parameters& p = scenario.parameters;
  p.support_stiffness = 0;
  p.eccentricity = 1e-5;
  p.loses_mass = false;
  expect_end_of_fixed_steps(scenario);
}

}  // namespace
}  // namespace rotor
