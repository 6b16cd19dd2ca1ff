/// What a run checks of itself: energy, contacts that last, and rings that are indented.
#include "model/methods/run_check.hpp"

#include <gtest/gtest.h>

#include "model/methods/event_method.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

std::string refusal_of(const Scenario& scenario) {
  Observer none;
  try {
    run(scenario, none);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// Friction that drives, and a damper that pushes. Of fixed steps see
// PublishedMethod.SaysWhereARunDiverges.
TEST(RunCheck, RefusesRunsThatNoRotorTakes) {
  Scenario scenario = short_run(0.05);
  scenario.equations = Equations::corrected;  // whose weight brings no energy
  EXPECT_EQ(refusal_of(scenario), "");
  Scenario driven = scenario, pushed = scenario;
  driven.parameters.friction = -0.3;
  pushed.parameters.support_damping = -1e3;
  for (const Scenario& wrong : {driven, pushed})
    EXPECT_NE(refusal_of(wrong).find("the energy grew by "), std::string::npos)
        << refusal_of(wrong);
}

class ContactCheck : public testing::Test {
 protected:
  ContactCheck() {
    rotor.motor_on = false;
    at.contact = ContactState::sliding;
    at.state = {3.1e-3, 0, 0, 0, 0, 900};
    at.time_s = 1;
    check.begin(rotor, at);
    at.time_s = 2;
  }
  Scenario scenario{.equations = Equations::corrected};
  RotorSystem<double> rotor{scenario.parameters, scenario.equations};
  Instant at = at_rest(scenario.parameters);
  RunCheck<double> check{RunCheck<double>::truncation_of(1e-11)};
};

TEST_F(ContactCheck, RefusesAContactAcrossAGap) {
  check.add_step(0.5, 900, 900, -1e-6);
  check.add_step(0.5, 900, 900, 1e-5);
  EXPECT_EQ(check.fault(rotor, at, true), "contact went on across a gap of 1e-06 m");
}
TEST_F(ContactCheck, RefusesContactsOfNoLengthIfTheyRepeat) {
  at.time_s = 1;
  EXPECT_EQ(check.fault(rotor, at, true), std::nullopt);
  for (const bool again : {false, true}) {
    EXPECT_EQ(check.fault(rotor, at, false).has_value(), again);
    for (const ContactState contact : {ContactState::free, ContactState::sliding}) {
      at.contact = contact;
      check.begin(rotor, at);
    }
  }
}

}  // namespace
}  // namespace rotor
