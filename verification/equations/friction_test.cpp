/// Contact and friction along the motion of random rotors.
#include <gtest/gtest.h>

#include "model/mechanics/mass_loss.hpp"
#include "verification/support/follow.hpp"
#include "verification/support/random_inputs.hpp"

namespace rotor {
namespace {

/// Checks every instant that it is shown.
class Inspector : public Observer {
 public:
  explicit Inspector(const Scenario& scenario)
      : ring_(scenario.parameters), acting_(scenario.parameters, scenario.equations) {}

  void on_instant(const Instant& at) override {
    if (at.contact != ContactState::sliding && at.contact != ContactState::rolling) return;
    const auto m = at.motion();
    const auto k = ring_.rim_point(m);
    const double normal = ring_.elastic_force(k);
    // Rounding of rho and of the velocities in the spring and the dashpot.
    const double rounding =
        2e-14 *
        ((ring_.law.tangent_stiffness(std::abs(k.indentation)) + acting_.supports.stiffness) *
             k.displacement +
         ring_.law.damping() * (std::abs(k.normal_velocity) + 1));
    EXPECT_LE(normal, rounding);
    if (at.contact == ContactState::rolling) {
      EXPECT_LE(std::abs(k.slip_velocity), 1e-12 * (1 + std::abs(ring_.rotor_radius * m.speed)));
      const double friction = friction_without_slip(at.body, ring_, m, k,
                                                    acting_.loads(at.body, m, at.motor_on), normal);
      EXPECT_LE(std::abs(friction), ring_.friction * -normal * (1 + 1e-9) + 10 * rounding);
    }
    ++seen_;
  }

  bool wants_dense_output(const double&, const double&) const override { return true; }
  void on_step(const DenseOutput& motion) override {
    const double middle_s = (motion.from_s + motion.until_s) / 2;
    const Instant at = motion.at(middle_s);
    on_instant(at);
    if (at.contact != ContactState::sliding) return;
    // Full Coulomb friction, against the slip. The motion shows it to 1e-4 of its size in the
    // interval, plus the rounding of the speed in the difference.
    const double h = (motion.until_s - motion.from_s) / 100;
    const double shown = friction_in(motion, middle_s, h), here = coulomb(at);
    double most = std::numeric_limits<double>::min();  // of mu |F_n|; of |F_n| without friction
    for (const double time_s : {motion.from_s, middle_s, motion.until_s})
      most = std::max(most, -ring_.normal_force(ring_.rim_point(motion.at(time_s).motion())) *
                                (ring_.friction > 0 ? ring_.friction : 1));
    const double rounding =
        1e-15 * std::abs(at.state[5]) / h * at.body.inertia / ring_.rotor_radius;
    worst_friction_ = std::max(worst_friction_, (std::abs(shown - here) - rounding) / most);
  }

  long seen() const { return seen_; }
  /// Largest deviation from Coulomb's friction in sliding, relative to it.
  double worst_friction() const { return worst_friction_; }

 private:
  /// The friction that the motion shows: the moment on the rotor that all other loads do not
  /// explain.
  double friction_in(const DenseOutput& motion, double time_s, double h) const {
    const Instant at = motion.at(time_s);
    const double turning =
        (motion.at(time_s + h).state[5] - motion.at(time_s - h).state[5]) / (2 * h);
    const auto m = at.motion();
    const auto k = ring_.rim_point(m);
    auto loads = acting_.loads(at.body, m, at.motor_on);
    loads += ring_.loads(k, {ring_.normal_force(k), 0});
    return (turning - acceleration(at.body, m, loads).angular) * at.body.inertia /
           ring_.friction_arm(m, k);
  }

  double coulomb(const Instant& at) const {
    const auto k = ring_.rim_point(at.motion());
    return std::copysign(ring_.friction * ring_.normal_force(k), -k.slip_velocity);
  }

  Ring<double> ring_;
  ActingLoads<double> acting_;
  long seen_ = 0;
  double worst_friction_ = 0;
};

TEST(RandomRub, NeverPullsNeverDrivesBySlipAndRollsWithinCoulombsLimit) {
  RandomInputs random(1);
  int rubbed = 0;
  for (int n = 0; n < 100; ++n) {
    SCOPED_TRACE(n);
    Scenario scenario = random.scenario();
    const Parameters& p = scenario.parameters;
    Instant at = at_rest(p);
    at.body = MassLoss<double>(p).after;
    at.mass_lost = true;
    at.motor_on = false;
    const double clearance = p.stator_radius - p.rotor_radius;
    at.state = {0.5 * clearance,
                0.1 * clearance,
                1,
                0.1,
                0.5 + 300 * clearance,
                two_pi * scenario.start_speed_Hz};
    Inspector inspector(scenario);
    scenario.tolerance = 1e-9;
    follow(scenario, at, 0.02, inspector);
    rubbed += inspector.seen() > 0;
    EXPECT_LT(inspector.worst_friction(), 1e-3);
  }
  EXPECT_GT(rubbed, 50);
}

}  // namespace
}  // namespace rotor
