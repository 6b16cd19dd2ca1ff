/// What a phase says of its event functions beforehand is true: where it says that one stays
/// positive over a step, nothing is looked for.
#include <gtest/gtest.h>

#include "model/phases/rub.hpp"
#include "verification/support/random_scenarios.hpp"

namespace rotor {
namespace {

using Unknowns = ContactChart<double>::Unknowns;

// Over steps of no length, at any state in rolling, with eccentricities beyond the rim as well.
TEST(RollingBounds, SayOnlyOfARimThatIsHeldThatItIs) {
  RandomScenarios random(5);
  std::mt19937_64 engine(6);
  std::uniform_real_distribution<double> any(-1, 1);
  int held = 0, slipping = 0, held_beyond = 0;
  for (int n = 0; n < 40000; ++n) {
    const Scenario scenario = random.scenario();
    RotorSystem<double> rotor(scenario.parameters, scenario.equations);
    const Ring<double>& ring = rotor.ring;
    const bool beyond = n % 2 == 0;
    if (beyond) rotor.body.eccentricity = ring.rotor_radius * (1 + any(engine) / 2);
    const double rho = ring.clearance * (1 + 0.1 * std::abs(any(engine)));
    const double direction = 3 * any(engine), speed = random.speed();
    const State<double> q = {
        rho * std::cos(direction), rho * std::sin(direction), 3 * any(engine), 0, 0, speed};
    const ContactChart<double> chart(rotor, q);
    Unknowns x = chart.without_slip(chart.unknowns(q));
    x[3] = any(engine);
    const Rolling<double> phase(rotor, chart);
    Point<double, Unknowns> at{0, x, {}};
    phase(x, at.rates, 0);
    if (phase.event_bounds(at, at)[1].stays_positive) {
      ++held;
      held_beyond += rotor.body.eccentricity > ring.rotor_radius;
      EXPECT_GE(phase.guard(1, x), 0) << n;
    } else {
      slipping += phase.guard(1, x) < 0;
    }
  }
  // The bound serves, and there were rims to be wrong about.
  EXPECT_GT(held, 1000);
  EXPECT_GT(slipping, 1000);
  EXPECT_EQ(held_beyond, 0);
}

}  // namespace
}  // namespace rotor
