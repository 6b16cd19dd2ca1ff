/// A ring that is not centred on the position of rest.
#include <gtest/gtest.h>

#include <cmath>

#include "model/results/energy.hpp"
#include "model/theory/accident.hpp"
#include "verification/support/balance.hpp"
#include "verification/support/dense_maxima.hpp"
#include "verification/support/law.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// The paper's rotor without gravity, which is no force by itself, in a ring that is off centre.
Scenario off_centre(double x, double y, double start_Hz = 0) {
  Scenario scenario{.start_speed_Hz = start_Hz};
  Parameters& p = scenario.parameters;
  p.ring_offset_x = x;
  p.ring_offset_y = y;
  p.gravity = 0;
  p.mass_loss_time = 0.01;
  scenario.until = 0.04;
  scenario.tolerance = 1e-13;
  return scenario;
}

// Clear of the ring it moves about its position of rest as in a centred ring, also through its
// mass loss, while it vibrates and when its vibration has died out.
TEST(RingOffset, ShiftsAMotionThatIsClearOfTheRing) {
  const double x = 0.7e-3, y = -1.1e-3;
  Law law("an offset shifts a free motion, of the clearance", 1e-10);  // 400 turns of 1e-13 a step
  for (const double start_Hz : {0., 30., 150.})
    for (const double loss_s : {0.3, 2.9}) {
      Scenario shifted = off_centre(x, y, start_Hz);
      shifted.parameters.mass_loss_time = loss_s;
      shifted.parameters.gravity = 9.81;
      shifted.parameters.stator_radius = 0.2;
      shifted.until = 3;
      Scenario centred = shifted;
      centred.parameters.ring_offset_x = centred.parameters.ring_offset_y = 0;
      const Instant a = run(shifted, nobody).last, b = run(centred, nobody).last;
      const Vector<double> off = in_stator_frame(a.motion().displacement, a.state[2]) -
                                 in_stator_frame(b.motion().displacement, b.state[2]);
      law.expect_left((off + Vector<double>(x, y)).norm() / 3e-3);
      law.expect_left(a.state[5] / b.state[5] - 1);
    }
}

// Without gravity nothing but the ring tells one direction from another.
TEST(RingOffset, TurnsTheMotionWithIt) {
  const auto motion = [](double angle, double rotor_angle) {
    const Scenario scenario = off_centre(1e-3 * std::cos(angle), 1e-3 * std::sin(angle), 150);
    Instant at = start_of(scenario);
    at.state[2] = rotor_angle;
    const Vector<double> rest = Supports<double>(scenario.parameters).rest,
                         in_axes = in_stator_frame(rest, -rotor_angle),
                         rate = -at.state[5] * quarter_turn(in_axes);
    at.state = {in_axes.x(), in_axes.y() + 2e-3, rotor_angle, rate.x(), rate.y(), at.state[5]};
    SummaryObserver summary(scenario);
    run(scenario, at, summary);
    return summary.summary();
  };
  const Summary one = motion(0.3, 0.1), other = motion(2.3, 2.1);
  EXPECT_GT(one.touch_downs, 2);
  EXPECT_EQ(one.touch_downs, other.touch_downs);
  // 10 contacts multiply errors of 1e-13 by some 1e4.
  EXPECT_NEAR(*other.peak_normal_force_N / *one.peak_normal_force_N, 1, 1e-8);
  EXPECT_NEAR(other.peak_bearing_force_N / one.peak_bearing_force_N, 1, 1e-8);
  EXPECT_NEAR(other.final_speed_Hz / one.final_speed_Hz, 1, 1e-8);
}

TEST(RingOffset, BalancesEnergyAndAngularMomentumInAnAccident) {
  for (const Drive drive : {Drive::motor, Drive::constant_speed}) {
    Scenario scenario = off_centre(0.8e-3, 1.2e-3, 150);
    scenario.parameters.drive = drive;
    scenario.parameters.gravity = 9.81;
    BalanceObserver balance(scenario);
    EnergyObserver energy(scenario);
    SummaryObserver summary(scenario);
    ObserverGroup all{&balance, &energy, &summary};
    run(scenario, all);
    EXPECT_GT(summary.summary().touch_downs, 2);
    Law law("balances in a ring off centre, of the greatest", 1e-11);
    law.expect_left(balance.energy_residual());
    law.expect_left(balance.angular_momentum_residual());
    const EnergyBalance& by_cause = energy.balance();
    law.expect_left(by_cause.residual() / std::max(by_cause.initial, by_cause.work.drive));
  }
}

// In contact it depends on the place along the ring, too.
TEST(RingOffset, LeavesNoLargerBearingForceThanTheLargest) {
  const Scenario rubbing{.parameters = {.mass = 7,
                                        .eccentricity = 0.236e-3,
                                        .support_stiffness = 24300,
                                        .support_damping = 17,
                                        .drive = Drive::constant_speed,
                                        .contact_stiffness = 7e9,
                                        .contact_damping = 2.1e4,
                                        .friction = 0.23,
                                        .rotor_radius = 0.0339,
                                        .stator_radius = 0.0371,
                                        .unbalance_factor = 3.55,
                                        .mass_loss_time = 0,
                                        .ring_offset_x = 0.44e-3,
                                        .ring_offset_y = 0.23e-3},
                         .start_speed_Hz = 159,
                         .until = 0.0425,
                         .tolerance = 1e-8};
  EXPECT_EQ(summary_of(rubbing).outcome, Outcome::rolling);
  EXPECT_EQ(exceeded_maximum(rubbing), "");
}

// Supports that rest beyond the ring press the rotor on it: k (|b| - c - Delta) = k_t Delta.
TEST(RingOffset, PressesARotorThatWouldRestBeyondTheRing) {
  Scenario scenario = off_centre(-3e-3, 4e-3);  // 5 mm, and the clearance is 3 mm
  scenario.start = Start{.x = 1.8e-3, .y = -2.4e-3};
  Parameters& p = scenario.parameters;
  p.torque = 0;
  p.contact_stiffness = 1e6;
  p.support_damping = 500;
  p.loses_mass = false;
  scenario.until = 2;
  SummaryObserver observer(scenario);
  const Instant end = run(scenario, observer).last;
  const double depth = 2e-3 * p.support_stiffness / (p.support_stiffness + p.contact_stiffness);
  const Motion<double> m = end.motion();
  EXPECT_NEAR(m.displacement.norm(), 3e-3 + depth, 1e-12);
  EXPECT_NEAR(end.contact_force(Ring<double>(p), m), p.contact_stiffness * depth, 1e-6);
  EXPECT_NEAR(Supports<double>(p).bearing_force(m).norm(), p.contact_stiffness * depth, 1e-6);
  EXPECT_EQ(observer.summary().outcome, Outcome::rolling);  // at 0 Hz: friction holds it
}

// It turns about its position of rest, at a constant distance.
TEST(RingOffset, LeavesTheSteadyResponseAboutThePositionOfRest) {
  const Scenario scenario = off_centre(0.4e-3, 0.3e-3, 60);
  const Instant start = start_of(scenario);
  const Motion<double> m = start.motion();
  const Supports<double> supports(scenario.parameters);
  const Vector<double> response = supports.unbalance_response(start.body, m.speed) - m.eccentricity;
  EXPECT_NEAR((supports.from_rest(m) - response).norm(), 0, 1e-18);
  EXPECT_NEAR((m.velocity - m.speed * quarter_turn(response)).norm(), 0, 1e-15);
  EXPECT_EQ(at_rest(scenario.parameters).motion().displacement, Vector<double>(-0.4e-3, -0.3e-3));
}

std::string refusal(const Scenario& scenario) {
  try {
    check(scenario);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(RingOffset, IsRefusedWhereItHasNoMeaning) {
  Scenario scenario = off_centre(0, 1e-4, 60);
  EXPECT_EQ(refusal(scenario), "");
  for (const Equations equations :
       {Equations::published, Equations{VelocityJump::once, GravityMoment::whole}}) {
    scenario.equations = equations;
    EXPECT_NE(refusal(scenario).find("ring_offset_y = 0.0001 m and gravity_moment = whole"),
              std::string::npos);
  }
  scenario = off_centre(-3.1e-3, 0);
  EXPECT_NE(refusal(scenario).find("at rest, 0.0031 m from its axis"), std::string::npos);
  // The steady response alone would not touch.
  scenario = off_centre(2.9e-3, 0, 60);
  EXPECT_NE(refusal(scenario).find("in the steady response at that speed"), std::string::npos);
  scenario.start = Start{};
  EXPECT_EQ(refusal(scenario), "");
}

TEST(RingOffset, LeavesTheClosedFormsWithoutAValue) {
  EXPECT_THROW(Accident(off_centre(1e-4, 0).parameters, Equations::corrected, 900),
               std::domain_error);
}

}  // namespace
}  // namespace rotor
