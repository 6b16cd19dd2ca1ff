/// The numbers of a scenario: their names, units and bounds, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/simulation/scenario.hpp"

namespace rotor {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
enum Bound { open, closed };

/// The list of numbers, written out anew.
struct Expected {
  const char *name, *symbol, *unit;
  double& (*member)(Scenario&);
  double least;
  Bound bound;
  double greatest;
};

#define MEMBER(of) [](Scenario& s) -> double& { return s.of; }
const std::vector<Expected>& expected_quantities() {
  static const std::vector<Expected> all = {
      {"mass", "m", "kg", MEMBER(parameters.mass), 0, open, infinite},
      {"inertia", "I_C", "kg m^2", MEMBER(parameters.inertia), 0, open, infinite},
      {"eccentricity", "e_x", "m", MEMBER(parameters.eccentricity), 0, closed, infinite},
      {"support_stiffness", "k", "N/m", MEMBER(parameters.support_stiffness), 0, closed, infinite},
      {"support_damping", "d", "N s/m", MEMBER(parameters.support_damping), 0, closed, infinite},
      {"gravity", "g", "m/s^2", MEMBER(parameters.gravity), 0, closed, infinite},
      {"torque", "M_mot", "N m", MEMBER(parameters.torque), 0, closed, infinite},
      {"motor_off_hz", "f_max", "Hz", MEMBER(parameters.motor_off_Hz), 0, closed, infinite},
      {"contact_stiffness", "k_t", "N/m", MEMBER(parameters.contact_stiffness), 0, open, infinite},
      {"contact_damping", "d_t", "N s/m", MEMBER(parameters.contact_damping), 0, closed, infinite},
      {"friction", "mu", "", MEMBER(parameters.friction), 0, closed, infinite},
      {"rotor_radius", "r", "m", MEMBER(parameters.rotor_radius), 0, open, infinite},
      {"stator_radius", "r_a", "m", MEMBER(parameters.stator_radius), 0, open, infinite},
      {"unbalance_factor", "k_u", "", MEMBER(parameters.unbalance_factor), 1, closed, infinite},
      {"separation_time", "t_1", "s", MEMBER(parameters.separation_time), 0, closed, infinite},
      {"start_speed_hz", "", "Hz", MEMBER(start_speed_Hz), 0, closed, infinite},
      {"until", "", "s", MEMBER(until), 0, open, infinite},
      {"tolerance", "", "", MEMBER(tolerance), 1e-15, closed, 1e-3},
      {"step_run_up", "h", "s", MEMBER(step_run_up), 0, open, infinite},
      {"step_rub", "h", "s", MEMBER(step_rub), 0, open, infinite},
  };
  return all;
}
#undef MEMBER

TEST(Quantities, AreTheseWithTheseNamesUnitsAndBounds) {
  ASSERT_EQ(quantities().size(), expected_quantities().size());
  for (std::size_t i = 0; i < quantities().size(); ++i) {
    const Quantity& ours = quantities()[i];
    const Expected& expected = expected_quantities()[i];
    EXPECT_EQ(ours.name, expected.name);
    EXPECT_EQ(ours.symbol, expected.symbol) << ours.name;
    EXPECT_EQ(ours.unit, expected.unit) << ours.name;
    Scenario scenario;
    EXPECT_EQ(&ours.in(scenario), &expected.member(scenario)) << ours.name;
    expected.member(scenario) = 0.125;
    EXPECT_EQ(ours.of(scenario), 0.125) << ours.name;
    EXPECT_EQ(ours.allows(expected.least), expected.bound == closed) << ours.name;
    EXPECT_FALSE(ours.allows(std::nextafter(expected.least, -infinite))) << ours.name;
    EXPECT_TRUE(ours.allows(std::nextafter(expected.least, infinite))) << ours.name;
    const bool has_greatest = expected.greatest < infinite;
    EXPECT_TRUE(ours.allows(has_greatest ? expected.greatest : 1e300)) << ours.name;
    EXPECT_FALSE(ours.allows(std::nextafter(expected.greatest, infinite))) << ours.name;
    EXPECT_FALSE(ours.allows(std::nan(""))) << ours.name;
  }
}

std::string refusal(const std::function<void(Scenario&)>& change) {
  Scenario scenario;
  change(scenario);
  try {
    check(scenario);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Check, RefusesEveryNumberOutsideItsBoundsAndNamesIt) {
  EXPECT_EQ(refusal([](Scenario&) {}), "");
  for (const Expected& expected : expected_quantities()) {
    const auto with = [&](double value) {
      return refusal([&](Scenario& s) { expected.member(s) = value; });
    };
    const std::string begin = std::string(expected.name) + " = ";
    EXPECT_TRUE(with(expected.least - 1).starts_with(begin)) << with(expected.least - 1);
    EXPECT_TRUE(with(infinite).starts_with(begin)) << expected.name;
    EXPECT_NE(with(-1).find(std::string(" must be a finite number ") +
                            (expected.bound == closed ? "not below" : "greater than")),
              std::string::npos)
        << with(-1);
    EXPECT_NE(with(-1).find(expected.unit), std::string::npos);
  }
}

// Of each pair of numbers, the last that is allowed and the first that is not.
TEST(Check, RefusesNumbersThatContradictEachOther) {
  const auto allows = [](const auto& change) { return refusal(change).empty(); };
  EXPECT_FALSE(allows([](Scenario& s) { s.parameters.stator_radius = 0.06; }));
  EXPECT_TRUE(allows([](Scenario& s) { s.parameters.stator_radius = 0.0600001; }));
  // The inertia left by the loss, which only a loss within the run needs.
  const auto light = [](Scenario& s) {
    s.parameters.inertia = 8e-5;
    s.until = 29.2;
  };
  EXPECT_NE(refusal(light).find("unbalance_factor = 3: the moment of inertia left"),
            std::string::npos);
  EXPECT_TRUE(allows([&](Scenario& s) {
    light(s);
    s.until = 29;
  }));
  EXPECT_TRUE(allows([&](Scenario& s) {
    light(s);
    s.parameters.separates = false;
  }));
  EXPECT_FALSE(allows([](Scenario& s) {
    s.parameters.rotor_radius = 1e-4;
    s.parameters.eccentricity = 1e-4;
    s.parameters.separates = false;
  }));
  EXPECT_TRUE(allows([](Scenario& s) {
    s.parameters.rotor_radius = 1.01e-4;
    s.parameters.eccentricity = 1e-4;
    s.parameters.separates = false;
  }));
  // In steady response at resonance the rotor would touch the ring.
  EXPECT_FALSE(allows([](Scenario& s) {
    s.start_speed_Hz = 10.06;
    s.parameters.support_damping = 1;
  }));
  // Steps of rk4: not longer than the run, and 1e10 at most, whichever step it is.
  for (const bool by_rk4 : {false, true}) {
    const auto with = [&](double until, double run_up, double rub) {
      return allows([&](Scenario& s) {
        s.method = by_rk4 ? Method::rk4 : Method::event;
        s.until = until;
        s.step_run_up = run_up;
        s.step_rub = rub;
      });
    };
    EXPECT_TRUE(with(1, 1, 1e-5));
    EXPECT_EQ(with(1, 1.001, 1e-5), !by_rk4);
    EXPECT_TRUE(with(1, 1.01e-10, 1e-5));
    EXPECT_EQ(with(1, 0.99e-10, 1e-5), !by_rk4);
    EXPECT_TRUE(with(1, 1e-3, 1.01e-10));
    EXPECT_EQ(with(1, 1e-3, 0.99e-10), !by_rk4);
  }
}

}  // namespace
}  // namespace rotor
