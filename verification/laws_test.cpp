/// Laws of mechanics along whole runs, contacts included, and symmetries of the equations.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "figures/scene.hpp"
#include "model/event_method.hpp"
#include "verification/ledger.hpp"

namespace rotor {
namespace {

struct Blind : Observer {
  using Observer::see;
  void see(const Instant&) override {}
};

class Figure : public testing::TestWithParam<int> {};

TEST_P(Figure, ClosesTheBooksOfEnergyAndAngularMomentumInEverySceneAndBothEquationSets) {
  char name[16];
  std::snprintf(name, sizeof name, "fig%02d.toml", GetParam());
  for (SceneRun scene_run : read_scene(std::filesystem::path(ROTOR_SCENES) / name).runs) {
    if (scene_run.scenario.method != Method::event) continue;
    for (const Equations equations : {Equations::published, Equations::consistent}) {
      Scenario& scenario = scene_run.scenario;
      scenario.equations = equations;
      scenario.tolerance = 1e-12;
      Ledger ledger(scenario);
      const Instant first = start(scenario);
      ledger.see(first);
      Work work;
      run(scenario, first, ledger, work);
      // Five times the worst seen, 1.8e-12: the sum of 40,000 steps, each good to 1e-14 or so.
      const double accuracy = 1e-11;
      EXPECT_LT(ledger.energy_defect(), accuracy) << scene_run.name;
      EXPECT_LT(ledger.angular_momentum_defect(), accuracy) << scene_run.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Figure, testing::Range(2, 18),
                         [](const auto& figure) { return "Fig" + std::to_string(figure.param); });

/// A rub that starts right after the mass loss, motor off.
class Symmetry : public testing::Test {
 protected:
  Symmetry() {
    scenario_.parameters.gravity = 0;
    scenario_.parameters.torque = 0;
    scenario_.tolerance = 1e-12;
  }

  Instant separated() const {
    Instant at = start(scenario_);
    at.body = MassLoss<double>(scenario_.parameters).after;
    at.separated = true;
    at.motor_on = false;
    at.state = {-0.15e-3, 0, 0, 0, 0.28, 942};
    return at;
  }

  Instant after(double duration_s, const Instant& from) const {
    Blind blind;
    Work work;
    EventMethod<double> method(scenario_, scenario_.tolerance, blind, work);
    return method.rub(from, from.time_s + duration_s);
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

/// A number between two bounds, evenly in its logarithm.
double between(double least, double greatest) {
  const int part = *rc::gen::inRange(0, 1001);
  return least * std::pow(greatest / least, part / 1000.);
}

/// Checks every instant that it is shown.
class Inspector : public Observer {
 public:
  explicit Inspector(const Scenario& scenario)
      : ring_(scenario.parameters), supports_(scenario.parameters, scenario.equations) {}

  void see(const Instant& at) override {
    if (at.contact != ContactState::sliding && at.contact != ContactState::rolling) return;
    const auto m = at.motion();
    const auto k = ring_.rim_point(m);
    const double normal = ring_.elastic_force(k);
    // Rounding of rho and of the velocities in the spring and the dashpot.
    const double rounding = 1e-14 * (ring_.stiffness * k.displacement +
                                     ring_.damping * (std::abs(k.normal_velocity) + 1));
    RC_ASSERT(normal <= rounding);
    if (at.contact == ContactState::rolling) {
      RC_ASSERT(std::abs(k.slip_velocity) <= 1e-12 * (1 + std::abs(ring_.rotor_radius * m.speed)));
      const double friction = friction_without_slip(
          at.body, ring_, m, k, supports_.loads(at.body, m, at.motor_on), normal);
      RC_ASSERT(std::abs(friction) <= ring_.friction * -normal * (1 + 1e-9) + 10 * rounding);
    }
    ++seen_;
  }

  bool wants_pieces(const double&, const double&) const override { return true; }
  void see(const Piece& piece) override {
    const double middle_s = (piece.from_s + piece.until_s) / 2;
    const Instant at = piece.at(middle_s);
    see(at);
    if (at.contact != ContactState::sliding) return;
    // All of Coulomb's friction, against the slip. The motion shows it to 1e-4 of what it is in the
    // piece, and to the rounding of the speed in the difference.
    const double h = (piece.until_s - piece.from_s) / 100;
    const double shown = friction_in(piece, middle_s, h),
                 least = std::numeric_limits<double>::min();
    const double here = coulomb(at);
    const double most = std::max({std::abs(here), std::abs(coulomb(piece.at(piece.from_s))),
                                  std::abs(coulomb(piece.at(piece.until_s))), least});
    const double rounding =
        1e-15 * std::abs(at.state[5]) / h * at.body.inertia / ring_.rotor_radius;
    worst_friction_ = std::max(worst_friction_, (std::abs(shown - here) - rounding) / most);
  }

  long seen() const { return seen_; }
  /// Largest deviation from Coulomb's friction in sliding, in parts of it.
  double worst_friction() const { return worst_friction_; }

 private:
  /// The friction that the motion shows: what turns the rotor beside all other loads.
  double friction_in(const Piece& piece, double time_s, double h) const {
    const Instant at = piece.at(time_s);
    const double turning =
        (piece.at(time_s + h).state[5] - piece.at(time_s - h).state[5]) / (2 * h);
    const auto m = at.motion();
    const auto k = ring_.rim_point(m);
    auto loads = supports_.loads(at.body, m, at.motor_on);
    loads += ring_.loads(k, {ring_.normal_force(k), 0});
    return (turning - acceleration(at.body, m, loads).angular) /
           friction_mobility(at.body, m, k, ring_.rotor_radius).angular;
  }

  double coulomb(const Instant& at) const {
    const auto k = ring_.rim_point(at.motion());
    return std::copysign(ring_.friction * ring_.normal_force(k), -k.slip_velocity);
  }

  Ring<double> ring_;
  Supports<double> supports_;
  long seen_ = 0;
  double worst_friction_ = 0;
};

RC_GTEST_PROP(RandomRub, NeverPullsNeverDrivesBySlipAndRollsWithinCoulombsLimit, ()) {
  Scenario scenario;
  Parameters& p = scenario.parameters;
  p.friction = between(1e-3, 3);
  p.contact_stiffness = between(1e6, 1e10);
  p.contact_damping = between(1, 1e5);
  p.stator_radius = p.rotor_radius + between(1e-4, 5e-3);
  p.unbalance_factor = between(1.5, 6);
  p.separates = false;
  Instant at = start(scenario);
  at.body = MassLoss<double>(p).after;
  at.separated = true;
  at.motor_on = false;
  const double clearance = p.stator_radius - p.rotor_radius;
  at.state = {0.5 * clearance, 0.1 * clearance, 1, 0.1, 0.5 + 300 * clearance, between(10, 1000)};
  Inspector inspector(scenario);
  Work work;
  EventMethod<double> method(scenario, 1e-9, inspector, work);
  method.rub(at, 0.02);
  RC_PRE(inspector.seen() > 0);
  RC_ASSERT(inspector.worst_friction() < 1e-3);  // worst of 1500 rotors: 1e-4
}

}  // namespace
}  // namespace rotor
