/// The motion after a mass loss, clear of the ring: the closed form against runs.
#include "model/theory/mass_loss_response.hpp"

#include <gtest/gtest.h>

#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

/// The paper's rotor, which loses its piece in steady response, without motor.
Scenario lost_at(double speed_Hz, Equations equations) {
  Scenario scenario{.equations = equations, .start_speed_Hz = speed_Hz, .until = 0.5};
  scenario.parameters.torque = 0;
  scenario.parameters.mass_loss_time = 0;
  return scenario;
}

MassLossResponse closed_form(const Scenario& scenario) {
  return {scenario.parameters, scenario.equations, two_pi * scenario.start_speed_Hz};
}

struct MassLossResponseOf : testing::TestWithParam<Equations> {};

TEST_P(MassLossResponseOf, AHeavyRotorIsItsMotion) {
  for (const double speed_Hz : {6., 14., 60., 150.}) {
    Scenario scenario = lost_at(speed_Hz, GetParam());
    Parameters& p = scenario.parameters;
    p.inertia = 1e9;  // keeps the speed
    p.gravity = 0;
    p.stator_radius = 0.08;
    const EventRecorder events = recorded(scenario);
    const Vector<double> q(events.last().state[0], events.last().state[1]);
    const Vector<double> O = in_stator_frame(q, events.last().state[2]);
    const auto expected = closed_form(scenario).position(scenario.until);
    EXPECT_GT(std::abs(expected), 1e-4);
    EXPECT_NEAR(O.x(), expected.real(), 1e-12) << speed_Hz;  // of some mm; the run's tolerance
    EXPECT_NEAR(O.y(), expected.imag(), 1e-12) << speed_Hz;
  }
}

TEST_P(MassLossResponseOf, AHeavyRotorTouchesTheRingWhenItDoes) {
  Scenario scenario = lost_at(150, GetParam());
  scenario.parameters.inertia = 1e9;
  scenario.parameters.gravity = 0;
  const EventRecorder events = recorded(scenario);
  const Instant& touch = events.first(Event::touch_down);
  const auto response = closed_form(scenario);
  const double t = response.first_contact().value();
  EXPECT_NEAR(touch.time_s, t, 1e-12);
  const double normal_velocity = (response.velocity(t) * std::conj(response.position(t))).real() /
                                 std::abs(response.position(t));
  const auto k = Ring<double>(scenario.parameters).rim_point(touch.motion());
  EXPECT_NEAR(k.normal_velocity, normal_velocity, 1e-9);
}

TEST_P(MassLossResponseOf, ThePapersRotorHasItsGreatestDisplacementBelowItsBound) {
  for (const double speed_Hz : {20., 45., 90., 150.}) {
    Scenario scenario = lost_at(speed_Hz, GetParam());
    scenario.parameters.stator_radius = 0.08;
    scenario.until = 3;
    const auto response = closed_form(scenario);
    // The speed, and gravity's moment on it, change by less than a thousandth.
    EXPECT_NEAR(summary_of(scenario).peak_displacement_m.value() / response.greatest(), 1, 2e-3)
        << speed_Hz;
    EXPECT_LE(response.greatest(), response.bound());
    EXPECT_GT(response.bound(), response.steady());
  }
}

TEST_P(MassLossResponseOf, ThePapersRotorTouchesTheRingFromItsSpeedOn) {
  double clear = 30, touching = 120;  // Hz, above the zone of resonance
  while (touching - clear > 1e-6) {
    const double middle = (clear + touching) / 2;
    (closed_form(lost_at(middle, GetParam())).first_contact() ? touching : clear) = middle;
  }
  // 51.80 and 94.29 Hz. The simulated borders lie at most 2.1e-4 above them.
  EXPECT_NEAR(touching, GetParam() == Equations::published ? 51.8006 : 94.2855, 1e-4);
  EXPECT_EQ(summary_of(lost_at(touching, GetParam())).touch_downs, 0);
  EXPECT_GT(summary_of(lost_at(touching * (1 + 2.5e-4), GetParam())).touch_downs, 0);
}

// The faster of rotation and vibration determines how densely the motion is sampled.
TEST_P(MassLossResponseOf, ARotorHasItsGreatestDisplacementBelowItsCriticalSpeedToo) {
  for (const double speed_Hz : {1., 2., 6.}) {
    const MassLossResponse response = closed_form(lost_at(speed_Hz, GetParam()));
    double greatest = 0;
    for (double t = 0; t < 3; t += 1e-4)
      greatest = std::max(greatest, std::abs(response.position(t)));
    EXPECT_NEAR(response.greatest() / greatest, 1, 2e-5) << speed_Hz;
  }
}

// A vibration that does not decay may never reach its bound: the search must end.
TEST_P(MassLossResponseOf, ARotorWithoutDampingHasAnEndToo) {
  Scenario scenario = lost_at(60, GetParam());
  scenario.parameters.support_damping = 0;
  const MassLossResponse undamped = closed_form(scenario);
  EXPECT_LT(undamped.greatest(), undamped.bound() * (1 + 1e-9));
  EXPECT_GT(undamped.greatest(), 0.99 * undamped.bound());
  scenario.parameters.stator_radius =
      scenario.parameters.rotor_radius + undamped.bound() * (1 - 1e-12);
  EXPECT_FALSE(closed_form(scenario).first_contact());
}

// The displacement falls at first, but the first sample is not a peak.
TEST_P(MassLossResponseOf, ARotorThatLosesLittleHardlyGoesFurther) {
  for (const double speed_Hz : {40., 60., 150.}) {
    Scenario scenario = lost_at(speed_Hz, GetParam());
    scenario.parameters.unbalance_factor = 1.02;
    const MassLossResponse response = closed_form(scenario);
    EXPECT_LE(response.greatest(), response.bound()) << speed_Hz;
    EXPECT_GT(response.greatest(), response.steady()) << speed_Hz;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, MassLossResponseOf,
                         testing::Values(Equations::published, Equations::corrected),
                         [](const auto& set) {
                           return set.param == Equations::published ? "Published" : "Corrected";
                         });

// There is no free vibration without stiffness, or with critical damping.
TEST(MassLossResponse, IsOfSupportsThatVibrate) {
  const auto of = [](double stiffness, double damping) {
    Parameters p;
    p.mass = 5;
    p.unbalance_factor = 1;
    p.support_stiffness = stiffness;
    p.support_damping = damping;
    return MassLossResponse(p, Equations::corrected, 600).bound();
  };
  EXPECT_THROW(of(0, 0), std::domain_error);
  EXPECT_THROW(of(500, 100), std::domain_error);
  EXPECT_THROW(of(500, 101), std::domain_error);
  EXPECT_GT(of(500, 99.9), 0);
}

}  // namespace
}  // namespace rotor
