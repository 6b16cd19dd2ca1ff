/// Symmetries of the equations, through contacts and rolling.
#include <gtest/gtest.h>

#include "model/mechanics/mass_loss.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/law.hpp"

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

  Instant after_loss() const {
    Instant at = at_rest(scenario_.parameters);
    at.body = MassLoss<double>(scenario_.parameters).after;
    at.mass_lost = true;
    at.motor_on = false;
    at.state = {-0.15e-3, 0, 0, 0, 0.28, 942};
    return at;
  }

  Instant after(double duration_s, const Instant& from) const {
    return follow(scenario_, from, from.time_s + duration_s, nobody).last;
  }

  static void expect_equal(const State<double>& a, const State<double>& b, Law&& law) {
    const State<double> scale = {3e-3, 3e-3, 1, 3, 3, 942};
    for (std::size_t i = 0; i < a.size(); ++i) law.expect_left((a[i] - b[i]) / scale[i]);
  }

  Scenario scenario_;
};

// 30 ms include all contacts and the onset of rolling, which multiply errors of 1e-14 by some 1e3.
constexpr double rub_s = 0.03;
constexpr double after_rub = 1e-9;

TEST_F(Symmetry, TurningTheRotorTurnsTheMotionWithIt) {
  Instant turned = after_loss();
  turned.state[2] += 1.234;
  State<double> expected = after(rub_s, after_loss()).state;
  expected[2] += 1.234;
  expect_equal(after(rub_s, turned).state, expected,
               Law("symmetry: the rotor turned at first, through a rub", after_rub));
}

TEST_F(Symmetry, MirroringTheRotorMirrorsTheMotion) {
  const auto mirrored = [](Instant at) {
    for (const std::size_t i : {1U, 2U, 4U, 5U}) at.state[i] = -at.state[i];
    return at;
  };
  expect_equal(after(rub_s, mirrored(after_loss())).state,
               mirrored(after(rub_s, after_loss())).state,
               Law("symmetry: the rotor mirrored at first, through a rub", after_rub));
}

TEST_F(Symmetry, WithoutDissipationTimeCanBeReversedThroughContacts) {
  scenario_.parameters.support_damping = 0;
  scenario_.parameters.contact_damping = 0;
  scenario_.parameters.friction = 0;
  const auto reversed = [](Instant at) {
    for (const std::size_t i : {3U, 4U, 5U}) at.state[i] = -at.state[i];
    return at;
  };
  const Instant first = after_loss();
  const Instant back = reversed(after(rub_s, reversed(after(rub_s, first))));
  EXPECT_GT(std::abs(after(rub_s, first).state[0] - first.state[0]), 1e-4);
  expect_equal(back.state, first.state,
               Law("time reversed through contacts without dissipation", after_rub));
}

}  // namespace
}  // namespace rotor
