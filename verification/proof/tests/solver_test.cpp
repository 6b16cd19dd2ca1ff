/// The prover itself: exactly known values are always enclosed, and errors are noticed.
#include <gtest/gtest.h>

#include <fstream>

#include "verification/proof/rotor.hpp"

namespace proof {
namespace {

/// A body on a line, for 10 s: its position, its velocity, the time, and a parameter about 1.
struct Line : Flow {
  Term x = tape.state(), v = tape.state(), t = tape.state(), p;

  Line(const auto& acceleration, const auto& guard,
       const Ball& half = Ball::power_of_two(-2 * Ball::bits)) {
    p = tape.parameter(1, half);
    scale = {1, 1, 1};
    tape.set_rates({v, acceleration(*this), tape.constant(1)});
    guards = {guard(*this), tape.constant(10) - t};
  }
  StateSet at(const Ball& position) const { return {{position, 0, 0}, tape}; }
};

const auto spring = [](Line& z) { return -z.p * z.x; };
const auto gravity = [](Line& z) { return -z.p; };
const auto height = [](Line& z) { return z.x; };

struct Prover : testing::TestWithParam<long> {
  Ball step_length = 0.1;
  void SetUp() override { Ball::bits = GetParam(); }
};

/// The exact value is inside a narrow ball.
void expect_in(const StateSet& set, std::size_t state, const Ball& exact) {
  const Ball ball = set.range(set.values[state]);
  EXPECT_TRUE(ball.contains(exact.middle()));
  EXPECT_TRUE(ball.radius() < 1e5 * Ball::power_of_two(-Ball::bits));
}

TEST_P(Prover, EnclosesAnOscillator) {
  const Line line(spring, [](Line& z) { return z.tape.constant(1); });
  StateSet set = line.at(1);
  // Without its remainder the sum of a short series is off by more than rounding.
  const Step step(line, set, 0.25, 4, 1e-6);
  const StateSet after = step.after(step.length());
  const Ball exact = cos(step.length());
  EXPECT_TRUE(after.range(after.values[0]).contains(exact.middle()));
  EXPECT_TRUE((exact - after.values[0][0]).size() > 1e-10);

  EXPECT_EQ(follow(line, set, step_length), 1U);
  expect_in(set, 0, cos(Ball(10)));
  expect_in(set, 1, -sin(Ball(10)));
}

// Released from 2 rad it passes the bottom after a quarter of its period, with the speed 2 sin 1.
TEST_P(Prover, EnclosesAPendulum) {
  const Line line([](Line& z) { return -z.tape.sine_and_cosine(z.x, z.v).first; }, height);
  StateSet set = line.at(2);
  EXPECT_EQ(follow(line, set, step_length), 0U);
  Ball mean;
  arb_agm(mean.get(), Ball(1).get(), cos(Ball(1)).get(), Ball::bits);
  expect_in(set, 1, -2 * sin(Ball(1)));
  expect_in(set, 2, Ball::pi() / (2 * mean));
}

// From 1/2 m it falls for 1 s at 1 m/s^2. Each rebound is half as fast, each flight half as long.
TEST_P(Prover, EnclosesABouncingBall) {
  const Line line(gravity, height);
  Line up(gravity, height);
  StateSet set = line.at(0.5);
  Ball time = 1, flight = 1;
  for (int bounce = 0; bounce < 6; ++bounce) {
    EXPECT_EQ(follow(line, set, step_length, {bounce > 0 ? 1U : 0U}), 0U);
    expect_in(set, 1, -flight);
    expect_in(set, 2, time);
    set = set.with(set.map({up.x, -up.v / up.tape.constant(2), up.t}), line.scale);
    time = time + flight;
    flight = flight / 2;
  }
}

// A section needs what is of second order.
TEST_P(Prover, EnclosesAllFallsOfABox) {
  const Line line(gravity, height, 0.05);
  StateSet floor = line.at(0.5);
  follow(line, floor, step_length);
  for (const double g : {0.95, 0.97, 1.03, 1.05}) {
    EXPECT_TRUE(floor.range(floor.values[1]).contains(-sqrt(Ball(g)).middle())) << g;
    EXPECT_TRUE(floor.range(floor.values[2]).contains((1 / sqrt(Ball(g))).middle())) << g;
  }
}

// (t - 1)^2 / 2 - x is negative for a moment about t = 1, within a step of 2 s. With x = 0 it
// touches zero, which is not decided to be an event or none.
TEST_P(Prover, SeesAGuardVanishWithinAStepAndDoesNotDecideATouchOrATie) {
  const Line line([](Line& z) { return z.tape.constant(0); },
                  [](Line& z) {
                    const Term late = z.t - z.tape.constant(1);
                    return late * late / z.tape.constant(2) - z.x;
                  });
  StateSet passes = line.at(Ball("0.0001")), touches = line.at(0);
  EXPECT_EQ(follow(line, passes, step_length = 2), 0U);
  expect_in(passes, 2, 1 - sqrt(Ball("0.0002")));
  EXPECT_THROW(follow(line, touches, step_length), Undecided);
  const Line both(spring, [](Line& z) { return z.tape.constant(10) - z.t; });  // as the end
  StateSet at_once = both.at(1);
  EXPECT_THROW(follow(both, at_once, step_length = 2), Undecided);
}

INSTANTIATE_TEST_SUITE_P(Bits, Prover, testing::Values(53, 128, 512),
                         [](const auto& bits) { return std::to_string(bits.param); });

TEST(Series, RefusesInputsAndTermsOfAnotherTape) {
  Line line(spring, height), other(spring, height);
  EXPECT_THROW(Series(line.tape, {{1}, {0}, {0}}, 1, 1), std::logic_error);  // and the parameter?
  EXPECT_THROW(Series(line.tape, {{1, 1}, {0}, {0}, {1}}, 1, 2), std::logic_error);
  EXPECT_THROW(line.x + other.x, std::logic_error);
  EXPECT_THROW(line.tape.state(), std::logic_error);  // behind other terms
  EXPECT_THROW(line.tape.set_rates({line.v}), std::logic_error);
  const StateSet set({1, 0}, Tape());
  EXPECT_THROW(set.range(line.x), std::logic_error);
  EXPECT_THROW(set.with({{1, 0, 0}}, {1}), std::logic_error);
}

// Each wrong sign in the equations moves the second touch-down. In the table, with which
// `make verify` compares the engine, the first is that at 150 Hz in the published equations.
TEST(Rotor, DisagreesWithTheEngineByOneWrongSign) {
  Ball::bits = 64;
  std::ifstream table(ROTOR_REFERENCE_DATA "/proven.csv");
  std::string field, lower, upper;
  while (std::getline(table, field, ',') && !field.ends_with("touch_down_2_s")) continue;
  std::getline(std::getline(table, lower, ','), upper, ',');
  const Ball expected = hull(Ball(lower), Ball(upper));
  const auto agrees = [&](const std::string& name, const std::string& value) {
    Case of;
    of.inputs.at("start-speed-Hz").value = "150";
    of.inputs.at("until").value = "0.015";
    of.inputs.at(name).value = value;
    const auto [quantity, time] = prove(of)[1];
    return quantity == "touch_down_2_s" && (time - expected).contains(0);
  };
  EXPECT_TRUE(agrees("friction", "0.3"));
  EXPECT_FALSE(agrees("support-damping", "-25"));
  EXPECT_FALSE(agrees("gravity", "-9.81"));
  EXPECT_FALSE(agrees("friction", "-0.3"));
}

}  // namespace
}  // namespace proof
