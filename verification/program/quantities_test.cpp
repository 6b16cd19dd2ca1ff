/// Numbers of a scenario that contradict each other.
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
