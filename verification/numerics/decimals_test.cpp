/// The digits of a run are those of the decimals as stated.
#include <gtest/gtest.h>

#include "figures/runs/run_ups.hpp"
#include "model/digits/digits.hpp"
#include "model/digits/quad.hpp"
#include "model/mechanics/contact.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

/// In quadruple precision; the finer computation has a hundredth of the tolerance.
Comparison exactly(const ScenarioSpec& spec) {
  return compare(Precision::quadruple, scenario_of(spec), 1e-17, always).value();
}

TEST(Decimals, AreReadInThePrecisionThatIsUsed) {
  EXPECT_LT(abs(as_typed<Quad>(0.1) * 10 - 1), 1e-33);
  EXPECT_LT(std::abs(as_typed<long double>(0.1) * 10 - 1), 1e-18L);
  EXPECT_EQ(as_typed<double>(0.1), 0.1);
}

// 49280.4052682 N by an independent program in quadruple precision. The doubles nearest to the
// inputs give 49280.4045635 N: contacts multiply the difference by 3e9. The finer
// computation leaves some 1e-19 times that.
TEST(Decimals, MakeTheForceThatAnotherProgramFinds) {
  ScenarioSpec spec;
  spec.equations = Equations::published;
  spec.numbers = {{"friction", 0.06}, {"until", 29.25}};
  EXPECT_NEAR(exactly(spec).values.peak_normal_force_N.value(), 49280.4052682, 1e-4);
}

// By the clearance or the ring's radius, by the speed or the time of the mass loss; and the lost
// mass is what was stated.
TEST(Decimals, MakeTheSameRunHoweverARotorIsStated) {
  ScenarioSpec one, other;
  one.numbers = {{"start_speed_Hz", 140.}, {"clearance", 1e-3}, {"mass_loss_speed_Hz", 140.5},
                 {"lost_mass", 0.01},      {"until", 0.15},     {"friction", 0.1}};
  other.numbers = one.numbers;
  other.numbers.erase("clearance");
  other.numbers.emplace("stator_radius", 0.061);
  const Comparison a = exactly(one), b = exactly(other);
  // A clearance that is off by the rounding of a double radius moves the force by 9e-12.
  EXPECT_NEAR(*a.values.peak_normal_force_N / *b.values.peak_normal_force_N, 1, 1e-13);
  EXPECT_GT(a.values.touch_downs, 1);
  EXPECT_NEAR(a.values.speed_at_mass_loss_Hz.value(), 140.5, 1e-13);
  EXPECT_NEAR(a.values.lost_mass_kg.value(), 0.01, 1e-17);
}

// In each precision a clearance and a lost mass are those that were stated, until a number from
// which they follow is set: from then on they are what the numbers say.
TEST(Decimals, HaveOneTruthHoweverTheLibrarySetsThem) {
  Parameters p{.rotor_radius = 0.07};
  p.state_clearance(1e-3);
  p.state_lost_mass(0.01);
  EXPECT_NEAR(Ring<double>(p).clearance, 1e-3, 1e-17);
  EXPECT_LT(abs(Ring<Quad>(p).clearance - as_typed<Quad>(1e-3)), 1e-33);
  EXPECT_NEAR(MassLoss<double>(p).lost_mass, 0.01, 1e-16);
  EXPECT_LT(abs(MassLoss<Quad>(p).lost_mass - as_typed<Quad>(0.01)), 1e-32);
  p.stator_radius = 0.08;
  p.unbalance_factor = 3;
  Parameters other{.rotor_radius = 0.07, .stator_radius = 0.08};
  EXPECT_EQ(Ring<Quad>(p).clearance, Ring<Quad>(other).clearance);
  EXPECT_EQ(MassLoss<Quad>(p).lost_mass, MassLoss<Quad>(other).lost_mass);
  p.state_clearance(2e-3);
  p.rotor_radius = 0.06;
  EXPECT_NEAR(static_cast<double>(Ring<Quad>(p).clearance), Ring<double>(p).clearance, 1e-15);
  p.eccentricity = 0;
  p.state_lost_mass(0.02);
  EXPECT_NEAR(MassLoss<double>(p).lost_mass, 0.02, 1e-16);
  EXPECT_THROW(p.state_lost_mass(p.mass), ScenarioError);
}

}  // namespace
}  // namespace rotor
