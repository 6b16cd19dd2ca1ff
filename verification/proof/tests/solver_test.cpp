/// The prover itself: exactly known values are always enclosed, and errors are noticed.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "verification/proof/rotor.hpp"

namespace proof {
namespace {

/// A body on a line with its time: position, velocity, time, and an end.
struct Line : Flow {
  Term x = tape.state(), v = tape.state(), t = tape.state();

  /// The acceleration and the guard are functions of the body and of a parameter.
  template <class Acceleration, class Guard>
  Line(int end, const Acceleration& acceleration, const Guard& guard) {
    const Term p = tape.parameter();
    states = {x, v, t};
    scale = {1, 1, 1};
    tape.set_rate(x, v);
    tape.set_rate(v, acceleration(*this, p));
    tape.set_rate(t, tape.constant(1));
    guards = {guard(*this), tape.constant(end) - t};
  }
};

const auto spring = [](const Line& z, Term p) { return -p * z.x; };
const auto gravity = [](const Line&, Term p) { return -p; };
const auto height = [](const Line& z) { return z.x; };
const auto none = [](const Line& z) { return z.t.tape->constant(1); };

class Prover : public testing::TestWithParam<long> {
 protected:
  void SetUp() override { Ball::bits = GetParam(); }

  /// At rest at x, with a parameter that differs by `half` from 1 at most.
  static StateSet at(const Ball& x, const Ball& half = Ball::power_of_two(-2 * Ball::bits)) {
    return {{x, 0, 0}, {1}, {half}};
  }
  static std::size_t follow(const Flow& flow, StateSet& set,
                            std::vector<std::size_t> vanishing = {}, Ball step = 0.1) {
    return proof::follow(flow, set, std::move(vanishing), step,
                         [](const Step&, const Ball&, const Ball&) {});
  }
  /// The exact value is inside of a ball that is narrow.
  static void expect_in(const StateSet& set, std::size_t state, const Ball& exact) {
    const Ball ball = set.all()[state][0];
    EXPECT_TRUE(ball.contains(exact.middle())) << ball.to_double() << " " << exact.to_double();
    const Ball rounding = 1e5 * Ball::power_of_two(-Ball::bits);
    EXPECT_TRUE(ball.radius() < rounding) << ball.radius().to_double();
  }
};

TEST_P(Prover, EnclosesAnOscillator) {
  const Line line(10, spring, none);
  StateSet set = at(1);
  EXPECT_EQ(follow(line, set), 1U);
  expect_in(set, 0, cos(Ball(10)));
  expect_in(set, 1, -sin(Ball(10)));
}

// Released from 2 rad it passes the bottom after a quarter of its period, with the speed 2 sin 1.
TEST_P(Prover, EnclosesAPendulum) {
  const Line line(
      10, [](const Line& z, Term) { return -z.x.tape->sine_and_cosine(z.x, z.v).first; }, height);
  StateSet set = at(2);
  EXPECT_EQ(follow(line, set), 0U);
  Ball mean;
  arb_agm(mean.get(), Ball(1).get(), cos(Ball(1)).get(), Ball::bits);
  expect_in(set, 1, -2 * sin(Ball(1)));
  expect_in(set, 2, Ball::pi() / (2 * mean));
}

// From 1/2 m it falls for 1 s at 1 m/s^2. Each rebound is half as fast, each flight half as long.
TEST_P(Prover, EnclosesABouncingBall) {
  const Line line(10, gravity, height);
  Line rebound(10, gravity, height);
  StateSet set = at(0.5);
  std::vector<std::size_t> vanishing;
  Ball time = 1, flight = 1;
  for (int bounce = 0; bounce < 6; ++bounce) {
    EXPECT_EQ(follow(line, set, vanishing), 0U);
    expect_in(set, 1, -flight);
    expect_in(set, 2, time);
    set = set.with(
        set.map(rebound.tape, {rebound.x, -rebound.v / rebound.tape.constant(2), rebound.t}),
        line.scale);
    vanishing = {1};
    time = time + flight;
    flight = flight / 2;
  }
}

// A section needs what is of second order.
TEST_P(Prover, EnclosesAllFallsOfABox) {
  const Line line(10, gravity, height);
  StateSet floor = at(0.5, 0.05);
  follow(line, floor);
  for (const double g : {0.95, 0.97, 1.03, 1.05}) {
    EXPECT_TRUE(floor.all()[1][0].contains(-sqrt(Ball(g)).middle())) << g;
    EXPECT_TRUE(floor.all()[2][0].contains((1 / sqrt(Ball(g))).middle())) << g;
  }
}

// Without it the sum of a short series is off by more than rounding.
TEST_P(Prover, NeedsTheRemainder) {
  const Line line(10, spring, none);
  const StateSet start = at(1);
  const Step step(line, start, 0.25, {.order = 4, .tolerance = 1e-6});
  const StateSet end = step.after(step.length());
  const Ball exact = cos(step.length());
  EXPECT_TRUE(end.all()[0][0].contains(exact.middle()));
  EXPECT_TRUE((exact - end.values[0][0]).size() > 1e-10);
}

// h = t^2/2 - t + 0.4999 is negative for 0.03 s about t = 1, and a step of 2 s ends beyond.
TEST_P(Prover, SeesAGuardVanishWithinAStep) {
  const Ball lowest("0.4999");
  const Line line(
      10, [](const Line& z, Term) { return z.t.tape->constant(0); },
      [&](const Line& z) {
        return z.t * z.t / z.t.tape->constant(2) - z.t + z.t.tape->constant(lowest);
      });
  StateSet set = at(0);
  EXPECT_EQ(follow(line, set, {}, 2), 0U);
  expect_in(set, 2, 1 - sqrt(1 - 2 * lowest));
}

// (t - 1)^2 touches zero, and does not pass it.
TEST_P(Prover, DoesNotDecideWhatOnlyTouches) {
  const Line line(10, spring, [](const Line& z) {
    const Term late = z.t - z.t.tape->constant(1);
    return late * late;
  });
  StateSet set = at(0);
  EXPECT_THROW(follow(line, set), Undecided);
}

INSTANTIATE_TEST_SUITE_P(Bits, Prover, testing::Values(53, 128, 512),
                         [](const auto& bits) { return std::to_string(bits.param); });

/// The table with which `make verify` compares the engine.
Ball second_touch_down_in_table() {
  std::ifstream table(ROTOR_REFERENCE_DATA "/proven.csv");
  for (std::string line, lower, upper; std::getline(table, line);) {
    std::istringstream row(line);
    if (line.find("--start-speed-hz 150 --friction 0.3 --equations published") != line.npos &&
        std::getline(row, lower, ',') && lower == "touch_down_2_s" &&
        std::getline(row, lower, ',') && std::getline(row, upper, ','))
      return hull(Ball(lower), Ball(upper));
  }
  throw std::runtime_error("no second touch-down in the table");
}

// Each wrong sign in the equations moves the second touch-down.
TEST(Rotor, DisagreesWithTheEngineByOneWrongSign) {
  Ball::bits = 64;
  const Ball expected = second_touch_down_in_table();
  const auto agrees = [&](const std::string& input, const std::string& value) {
    const Case of{.inputs = {{"start-speed-hz", "150"}, {input, value}}, .until = "0.015"};
    for (const auto& [quantity, time] : prove(of))
      if (quantity == "touch_down_2_s") return (time - expected).contains(0);
    return false;
  };
  EXPECT_TRUE(agrees("friction", "0.3"));
  EXPECT_FALSE(agrees("support-damping", "-25"));
  EXPECT_FALSE(agrees("gravity", "-9.81"));
  EXPECT_FALSE(agrees("friction", "-0.3"));
}

}  // namespace
}  // namespace proof
