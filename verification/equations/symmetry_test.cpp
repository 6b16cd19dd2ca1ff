/// Symmetries of the equations, through contacts and rolling.
#include <gtest/gtest.h>

#include "model/mechanics/mass_loss.hpp"
#include "verification/support/follow.hpp"

namespace rotor {
namespace {

/// A rub that starts right after the mass loss, motor off.
class Symmetry : public testing::Test {
 protected:
  Symmetry() {
    scenario_.parameters.gravity = 0;
    scenario_.parameters.torque = 0;
    scenario_.tolerance = 1e-12;
  }

  Instant separated() const {
    Instant at = at_rest(scenario_.parameters);
    at.body = MassLoss<double>(scenario_.parameters).after;
    at.separated = true;
    at.motor_on = false;
    at.state = {-0.15e-3, 0, 0, 0, 0.28, 942};
    return at;
  }

  Instant after(double duration_s, const Instant& from) const {
    Observer null_observer;
    return follow(scenario_, from, from.time_s + duration_s, null_observer).last;
  }

  static void expect_equal(const State<double>& a, const State<double>& b, double accuracy) {
    const State<double> scale = {3e-3, 3e-3, 1, 3, 3, 942};
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_NEAR(a[i] / scale[i], b[i] / scale[i], accuracy) << "component " << i;
  }

  Scenario scenario_;
};

// 30 ms include all contacts and the onset of rolling, which multiply errors of 1e-14 by some 1e3.
constexpr double rub_s = 0.03;
constexpr double after_rub = 1e-9;

TEST_F(Symmetry, TurningTheRotorTurnsTheMotionWithIt) {
  Instant turned = separated();
  turned.state[2] += 1.234;
  State<double> expected = after(rub_s, separated()).state;
  expected[2] += 1.234;
  expect_equal(after(rub_s, turned).state, expected, after_rub);
}

TEST_F(Symmetry, MirroringTheRotorMirrorsTheMotion) {
  const auto mirrored = [](Instant at) {
    for (const std::size_t i : {1U, 2U, 4U, 5U}) at.state[i] = -at.state[i];
    return at;
  };
  expect_equal(after(rub_s, mirrored(separated())).state, mirrored(after(rub_s, separated())).state,
               after_rub);
}

TEST_F(Symmetry, WithoutDissipationTimeCanBeReversedThroughContacts) {
  scenario_.parameters.support_damping = 0;
  scenario_.parameters.contact_damping = 0;
  scenario_.parameters.friction = 0;
  const auto reversed = [](Instant at) {
    for (const std::size_t i : {3U, 4U, 5U}) at.state[i] = -at.state[i];
    return at;
  };
  const Instant first = separated();
  const Instant back = reversed(after(rub_s, reversed(after(rub_s, first))));
  EXPECT_GT(std::abs(after(rub_s, first).state[0] - first.state[0]), 1e-4);
  expect_equal(back.state, first.state, after_rub);
}

TEST_F(Symmetry, AChangeOfUnitsChangesNothing) {
  // Powers of two: all numbers are scaled without rounding.
  const double metre = 4, second = 0.5, kilogram = 16;
  const Instant last = after(rub_s, separated());
  Scenario& s = scenario_;
  Parameters& p = s.parameters;
  const double newton = kilogram * metre / (second * second);
  p.mass *= kilogram;
  p.inertia *= kilogram * metre * metre;
  p.eccentricity *= metre;
  p.support_stiffness *= newton / metre;
  p.support_damping *= newton * second / metre;
  p.contact_stiffness *= newton / metre;
  p.contact_damping *= newton * second / metre;
  p.rotor_radius *= metre;
  p.stator_radius *= metre;
  p.motor_off_Hz /= second;
  Instant other = separated();
  other.state = {-0.15e-3 * metre, 0, 0, 0, 0.28 * metre / second, 942 / second};
  const Instant same = after(rub_s * second, other);
  EXPECT_EQ(same.state[0], last.state[0] * metre);
  EXPECT_EQ(same.state[1], last.state[1] * metre);
  EXPECT_EQ(same.state[2], last.state[2]);
  EXPECT_EQ(same.state[3], last.state[3] * metre / second);
  EXPECT_EQ(same.state[4], last.state[4] * metre / second);
  EXPECT_EQ(same.state[5], last.state[5] / second);
}

}  // namespace
}  // namespace rotor
