/// The audit: where the paper contradicts itself, shown by measurement, in both sets of equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "model/scenario/instant.hpp"
#include "verification/paper/paper_runs.hpp"
#include "verification/paper/readings.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/onset_speed.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

double to_rolling_s(const Summary& s) { return *s.rolling_onset_s - *s.first_contact_s; }

TEST(Audit, TheGravityMomentAsPrintedDoesNotConserveTheEnergyOfAnUndampedUndrivenRotor) {
  const auto drift = [](Equations equations, bool potential_of_the_whole_weight) {
    Scenario scenario{.equations = equations, .until = 2, .tolerance = 1e-12};
    Parameters& p = scenario.parameters;
    p.support_damping = p.torque = 0;
    p.loses_mass = false;
    const auto energy = [&](const Instant& at) {
      const auto m = at.motion();
      const Vector<double> arm = potential_of_the_whole_weight ? m.mass_centre() : m.eccentricity;
      return kinetic_energy(at.body, m) + p.support_stiffness * m.displacement.squaredNorm() / 2 -
             p.mass * p.gravity * arm.dot(m.down);
    };
    Instant first = at_rest(p);
    first.state = {1e-3, 0, 0, 0, 0.02, 20};
    const Instant last = run(scenario, first, nobody).last;
    return std::abs(energy(last) - energy(first)) / energy(first);
  };
  EXPECT_LT(drift(Equations::corrected, false), 1e-11);  // the integrator's accuracy
  EXPECT_GT(drift(Equations::published, false), 1e-4);
  EXPECT_GT(drift(Equations::published, true), 1e-4);
}

// By the turns of O about O_a in either frame, over the first 5 ms of rolling, in which the speed
// falls by 1 Hz.
TEST(Audit, InTheRotatingFrameTheWhirlHasTheFrequencyOfRollingPlusThatOfRotation) {
  PaperRuns runs{{}};
  const auto rolling = runs.high().first_5_ms().value();
  EXPECT_NEAR(rolling.whirl_Hz, 770, 770 * 0.01);
  EXPECT_NEAR(rolling.q1_Hz - rolling.whirl_Hz, in_Hz(runs.high().onset()->state[5]), 1);
}

TEST(Audit, ALossBeforeTheGreatestSwingTouchesTheRing) {
  for (const Equations equations : {Equations::published, Equations::corrected})
    for (const auto& [loss_s, touches] : {std::pair(2.0, true), {2.2, false}}) {  // as the text has
      const Scenario scenario{
          .parameters = {.mass_loss_time = loss_s}, .equations = equations, .until = 6};
      EXPECT_EQ(summary_of(scenario).touch_downs > 10, touches) << loss_s;
    }
}

// With F_n < 0 in contact, Eqs. (21) and (22) give a "magnitude" F_tau < 0, and the two sides of
// Eq. (24), F_tau c_y and -mu F_ny, differ in sign. Condition (23) then reverses whichever was
// taken.
TEST(Audit, TheFrictionOfEq22HasTheOppositeSignOfThatInEq24) {
  const Scenario scenario{.equations = Equations::published, .until = 29.11};
  const EventRecorder seen = recorded(scenario);
  const Instant& at = seen.first(Event::touch_down);
  const Ring<double> ring(scenario.parameters);
  const RimPoint<double> k = ring.rim_point(at.motion());
  const double f_n = ring.touching_force(k), mu = scenario.parameters.friction;
  ASSERT_LT(f_n, -1e3);
  const double f_tau = mu * f_n;                                           // Eq. (22)
  const Vector<double> c = k.normal, left(f_tau * c.y(), -f_tau * c.x()),  // Eq. (24)
      right(-mu * f_n * c.y(), mu * f_n * c.x());
  EXPECT_NEAR((left + right).norm(), 0, 1e-12 * right.norm());
  const Vector<double> slip = k.slip_velocity * k.tangent;
  EXPECT_GT(left.dot(slip), 0);   // drives the rim
  EXPECT_LT(right.dot(slip), 0);  // brakes it, as condition (23) asks for
}

// Places between those of the search, which stops where two grids agree.
TEST(Audit, TheBordersOverAllPlacesOfTheLossHoldOnAnotherGrid) {
  const OnsetSpeeds speeds = onset_speeds_by_place(Equations::published);
  EXPECT_GT(speeds.greatest_Hz - speeds.least_Hz, 4);
  constexpr int places = 20;
  for (int n = 0; n < places; ++n) {
    const double speed_Hz = onset_speed_Hz(Equations::published, (n + 0.25) * two_pi / places);
    EXPECT_GT(speed_Hz, speeds.least_Hz - 0.02) << n;
    EXPECT_LT(speed_Hz, speeds.greatest_Hz + 0.02) << n;
  }
}

TEST(Audit, TheChangesOverAllPlacesOfTheLossHoldOnAnotherGrid) {
  PaperRuns runs{{}};
  const double largest = read_off("elsewhere_time", runs).value();
  const auto to_rolling = [&](double angle) { return to_rolling_s(runs.lost_at(angle)); };
  double on_this_grid = 0;
  constexpr int places = 100;
  for (int n = 0; n < places; ++n)
    on_this_grid = std::max(
        on_this_grid, 100 * std::abs(to_rolling((n + 0.3) * two_pi / places) / to_rolling(0) - 1));
  EXPECT_LE(on_this_grid, 1.01 * largest);
  EXPECT_GT(on_this_grid, 0.9 * largest);
}

TEST(Refined, StopsWhereTwoGridsAgreeAndThrowsIfNoneDo) {
  long finest = 0;
  const auto slow = [&](long points) {
    finest = points;
    return 1 + 1 / static_cast<double>(points);
  };
  EXPECT_NEAR(refined(slow, 2, 0.04), 1, 0.1);
  EXPECT_EQ(finest, 32);  // 1.125 and 1.0625 differ by more, 1.0625 and 1.03 by less
  EXPECT_THROW(refined([](long points) { return static_cast<double>(points); }, 2, 0.01),
               std::runtime_error);
}

// Half and twice are the ends of a range: between them a change is at most 5 % larger.
TEST(Audit, StiffnessAndDampingBetweenHalfAndTwiceChangeNoMoreThanTheEnds) {
  PaperRuns runs{{}};
  for (const char* quantity : {"contact_stiffness", "contact_damping"}) {
    const auto change = [&](double factor) {
      const Summary &as_it_is = runs.high().summary(),
                    &changed = runs.changed(0.3, quantity, factor).summary();
      return std::array{std::abs(*changed.peak_normal_force_N / *as_it_is.peak_normal_force_N - 1),
                        std::abs(to_rolling_s(changed) / to_rolling_s(as_it_is) - 1)};
    };
    const auto half = change(0.5), twice = change(2);
    for (int n = 1; n < 12; ++n)
      for (const std::size_t result : {0U, 1U})
        EXPECT_LE(change(0.5 * std::pow(4, n / 12.))[result],
                  1.05 * std::max(half[result], twice[result]))
            << quantity << ' ' << n;
  }
}

}  // namespace
}  // namespace rotor
