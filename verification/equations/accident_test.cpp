/// The laws of the accident: at their limits, and against runs in which all their assumptions hold.
#include "model/theory/accident.hpp"

#include <gtest/gtest.h>

#include "figures/results/run_result.hpp"
#include "verification/support/bare.hpp"
#include "verification/support/law.hpp"

namespace rotor {
namespace {

Accident law_of(const Scenario& scenario) {
  return {scenario.parameters, scenario.equations, two_pi * scenario.start_speed_Hz};
}

Summary until_decided(const Scenario& scenario) {
  return complete_run(RunUpCheckpoint(scenario), scenario, StopOn::outcome, nobody).summary;
}

// The rotation is so fast that at the end of the swing O is on the far side of C.
TEST(AccidentLaws, BeginsAtItsContactSpeedFarAboveResonance) {
  for (const auto equations : {Equations::published, Equations::corrected})
    for (const double damping_ratio : {0., 0.3}) {
      Parameters p;
      p.support_stiffness = 1e-2;
      p.eccentricity = 1e-3;
      p.unbalance_factor = 1.001;
      p.support_damping =
          2 * damping_ratio * std::sqrt(p.support_stiffness * MassLoss<double>(p).after.mass);
      p.stator_radius = p.rotor_radius + 3e-3;
      const double speed = Accident(p, equations, 700).contact_speed.value();
      const double clearance = p.stator_radius - p.rotor_radius;
      // At least 1000 turns per swing; the steady response lags by the damping over that number.
      Law("reach of a rotor at its contact speed, over the clearance", 1e-5)
          .expect_left(Accident(p, equations, speed).reach / clearance - 1);
    }
}

// Without unbalance and damping, after a blow along a radius: ever smaller rebounds, until the
// rotor whirls permanently or hardly moves along the ring.
TEST(AccidentLaws, WhirlsAboveItsFrictionAndNotBelow) {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.support_stiffness = Parameters{}.support_stiffness;
  p.contact_stiffness = 1e10;  // a blow lasts for less than a thousandth of a swing
  for (const double zeta : {0.05, 0.3}) {
    p.contact_damping = 2 * zeta * std::sqrt(p.mass * p.contact_stiffness);
    const double friction =
        whirling_friction(p, p.mass, 0.7, swing_after_blow(zeta) * swing_after_blow(zeta));
    const auto rolls = [&](double share) {
      p.friction = share * friction;
      const auto clearance = p.stator_radius - p.rotor_radius;
      const auto run =
          follow_from_state(scenario, {clearance, 0, 0, 0.7, -900 * clearance, 900}, 6);
      return std::ranges::any_of(
          run.events(), [](const Instant& at) { return at.event == Event::rolling_onset; });
    };
    EXPECT_TRUE(rolls(1.03)) << zeta;
    EXPECT_FALSE(rolls(0.97)) << zeta;
  }
}

/// A case in which all assumptions hold: unbalance and clearance are tiny compared with the rotor,
/// so that blows due to the unbalance do not turn it, and there is neither damping nor gravity.
Scenario ideal(double friction, double softness, double kappa) {
  Scenario scenario{.start_speed_Hz = 150, .until = 0.5};
  Parameters& p = scenario.parameters;
  p.torque = p.gravity = p.support_damping = p.mass_loss_time = 0;
  p.eccentricity = 1e-7;
  p.stator_radius = p.rotor_radius + 1e-6;
  p.friction = friction;
  p.inertia = p.mass * p.rotor_radius * p.rotor_radius / kappa;
  const double rate = two_pi * 150 / (1 + kappa) * p.rotor_radius / 1e-6;  // of rigid rolling
  p.contact_stiffness = p.mass * rate * rate / (softness * softness);
  p.contact_damping = 0.1 * std::sqrt(p.mass * p.contact_stiffness);
  return scenario;
}

TEST(AccidentLaws, RollsInARigidRingFromTheSpeedThatTheMomentumLeaves) {
  const Scenario scenario = ideal(0.3, 0.01, 2);
  const double rest = 1. / 3;
  Law("speed at which rolling begins in a rigid ring", 3e-4)  // softness^2, m_u
      .expect_left(until_decided(scenario).rolling_onset_speed_Hz.value() / (150 * rest) - 1);
  EXPECT_NEAR(law_of(scenario).rolling_speed.value() / (two_pi * 150 * rest), 1, 3e-4);
}

// The slower the growth beside the ring's vibration, the better: their ratio is mu * softness.
TEST(AccidentLaws, RollsInASoftRingAsTheLawsSay) {
  for (const double kappa : {2, 10})
    for (const double softness : {0.2, 0.5})
      for (const double friction : {0.1, 0.3}) {
        const Scenario scenario = ideal(friction, softness, kappa);
        const Accident law = law_of(scenario);
        const Summary run = until_decided(scenario);
        Law("speed at which rolling begins in a soft ring", 5e-3)
            .expect_left(run.rolling_onset_speed_Hz.value() * two_pi / law.rolling_speed.value() -
                         1);
        Law("largest force in rolling, soft ring", 1e-2)
            .expect_left(run.peak_force_to_rolling_N.value() / law.rolling_force.value() - 1);
      }
}

}  // namespace
}  // namespace rotor
