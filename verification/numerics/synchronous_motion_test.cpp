/// The synchronous motion that flight subtracts is subtracted exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "model/phases/flight.hpp"
#include "model/run/simulation.hpp"

namespace rotor {
namespace {

using S = long double;

/// A flight at a speed in rad/s. A new chart subtracts the steady response; one that has turned far
/// still does while the rotor swings, and the complete synchronous motion otherwise.
struct Run : testing::TestWithParam<Equations> {
  Run() : rotor(Parameters{}, GetParam()) {}

  FlightChart<S> chart(const S& speed, const std::optional<S>& swing) const {
    FlightChart<S> laid(rotor, {-1.5e-4L, 0, 0, 0, 0, speed});
    if (!swing) return laid;
    std::array<S, 6> turned_far = {*swing, 0, 40, 0, 50 * *swing, 100 * *swing * speed};
    const State<S> before = laid.state(turned_far);
    laid.recentre(turned_far);
    const State<S> after = laid.state(turned_far);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_LE(std::abs(after[i] - before[i]), 1e-15L * (std::abs(before[i]) + 1e-3L)) << *swing;
    return laid;
  }

  RotorSystem<S> rotor;
};

// Whatever is subtracted, the rates of the unknowns are those of the paper's coordinates, Eq. (3).
// Numerical differentiation over 1e-6 of a radian resolves some 1e-11 of the largest rates.
TEST_P(Run, IsSubtractedExactly) {
  for (const auto& [gravity, swing] : std::vector<std::pair<S, std::optional<S>>>{
           {9.81L, {}}, {9.81L, 0}, {9.81L, 1e-3L}, {0, {}}, {0, 0}, {0, 1e-3L}})
    for (const S speed : {S(100), S(300), S(900)}) {
      rotor.acting.weight.gravity = gravity;
      const FlightChart<S> chart = this->chart(speed, swing);
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
              << gravity << ' ' << swing.value_or(-1) << ' ' << speed << ' ' << n << ' ' << i;
      }
    }
}

INSTANTIATE_TEST_SUITE_P(UpInSpeed, Run,
                         testing::Values(Equations::published, Equations::corrected),
                         [](const auto& equations) {
                           return equations.param == Equations::published ? "Published"
                                                                          : "Corrected";
                         });

/// As far as the published method resolves it, which is of fourth order without contact.
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
