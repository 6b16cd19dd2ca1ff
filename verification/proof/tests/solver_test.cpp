/// The prover itself: what is known exactly is always inside, and what is wrong is noticed.
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "verification/proof/rotor.hpp"

namespace proof {
namespace {

/// Bodies on a line with their time: position, velocity, time, and an end.
struct Line : Flow {
  Term x, v, t;

  /// The acceleration is a function of position and parameters, the guard of position.
  template <class Acceleration, class Guard>
  Line(const Ball& end, int parameters, const Acceleration& acceleration, const Guard& guard)
      : x(tape->state()), v(tape->state()), t(tape->state()) {
    std::vector<Term> p;
    for (int i = 0; i < parameters; ++i) p.push_back(tape->parameter());
    states = {x, v, t};
    rates = {v, acceleration(x, p), tape->constant(1)};
    tape->set_rates(rates);
    guards = {guard(x), tape->constant(end) - t};
  }
};

const auto one = [](Term x) { return x.tape->constant(1); };
const auto itself = [](Term x) { return x; };

class Prover : public testing::TestWithParam<long> {
 protected:
  void SetUp() override {
    Ball::bits = GetParam();
    settings_ = Settings();
    inputs_ = {.centre = {}, .half = {}, .scale = {1, 1, 1}};
  }

  Passage followed(const Flow& flow, const StateSet& from,
                   std::vector<std::size_t> vanishing = {}) {
    Ball step = 0.1;
    return follow(flow, inputs_, from, std::move(vanishing), settings_, step,
                  [](const Step&, const Ball&, const Ball&) {});
  }
  StateSet at(const Row& state) const { return StateSet::at(state, inputs_); }

  /// The exact value is inside of a ball that is narrow.
  static void expect_in(const Ball& ball, const Ball& exact) {
    EXPECT_TRUE(ball.contains(exact.middle())) << ball.to_double() << " " << exact.to_double();
    Ball allowed(1e5);  // of rounding
    arb_mul_2exp_si(allowed.get(), allowed.get(), -Ball::bits);
    EXPECT_TRUE((allowed - ball.radius()).is_positive()) << ball.radius().to_double();
  }

  Settings settings_;
  Inputs inputs_;
};

TEST_P(Prover, EnclosesAnOscillator) {
  const Line line(
      10, 0, [](Term x, const auto&) { return -x; }, one);
  const Passage end = followed(line, at({1, 0, 0}));
  EXPECT_EQ(end.guard, 1U);
  expect_in(end.set.hull()[0], cos(Ball(10)));
  expect_in(end.set.hull()[1], -sin(Ball(10)));
}

// Released from 2 rad it passes the bottom after a quarter of its period, with the speed 2 sin 1.
TEST_P(Prover, EnclosesAPendulum) {
  const Line line(
      10, 0, [](Term x, const auto&) { return -SineAndCosine(x).sine; }, itself);
  const Passage bottom = followed(line, at({2, 0, 0}));
  EXPECT_EQ(bottom.guard, 0U);
  Ball mean;
  arb_agm(mean.get(), Ball(1).get(), cos(Ball(1)).get(), Ball::bits);
  expect_in(bottom.set.hull()[1], -2 * sin(Ball(1)));
  expect_in(bottom.set.hull()[2], Ball::pi() / (2 * mean));
}

// From 1/2 m it falls for 1 s at 1 m/s^2. Each rebound is half as fast, each flight half as long.
TEST_P(Prover, EnclosesABouncingBall) {
  const Line line(
      10, 0, [](Term x, const auto&) { return x.tape->constant(-1); }, itself);
  Tape tape;
  const Term x = tape.state(), v = tape.state(), t = tape.state();
  StateSet set = at({0.5, 0, 0});
  std::vector<std::size_t> vanishing;
  Ball time(1), flight(1), speed(-1);
  for (int bounce = 0; bounce < 6; ++bounce) {
    const Passage floor = followed(line, set, vanishing);
    EXPECT_EQ(floor.guard, 0U);
    expect_in(floor.set.hull()[2], time);
    expect_in(floor.set.hull()[1], speed);
    set = map(tape, {x, -v / tape.constant(2), t}, inputs_, floor.set);
    vanishing = {1};
    time += flight;
    flight /= 2;
    speed /= 2;
  }
}

TEST_P(Prover, EnclosesAllOscillatorsOfABox) {
  inputs_.centre = {1};
  inputs_.half = {0.1};
  const Line line(
      1, 1, [](Term x, const auto& p) { return -p[0] * x; }, one);
  const Ball x = followed(line, at({1, 0, 0})).set.hull()[0];
  for (const double stiffness : {0.9, 0.95, 1.0, 1.1})
    EXPECT_TRUE(x.contains(cos(sqrt(Ball(stiffness))).middle())) << stiffness;
  // cos sqrt 0.9 - cos sqrt 1.1 = 0.084, and what is of second order.
  EXPECT_TRUE((Ball(0.06) - x.radius()).is_positive()) << x.radius().to_double();
}

// A section needs what is of second order.
TEST_P(Prover, EnclosesAllFallsOfABox) {
  inputs_.centre = {1};
  inputs_.half = {0.05};
  const Line line(
      10, 1, [](Term, const auto& p) { return -p[0]; }, itself);
  const Row floor = followed(line, at({0.5, 0, 0})).set.hull();
  for (const double gravity : {0.95, 0.97, 1.03, 1.05}) {
    EXPECT_TRUE(floor[1].contains(-sqrt(Ball(gravity)).middle())) << gravity;
    EXPECT_TRUE(floor[2].contains((1 / sqrt(Ball(gravity))).middle())) << gravity;
  }
}

// Without it the sum of a short series lies aside by more than rounding.
TEST_P(Prover, NeedsTheRemainder) {
  settings_.order = 4;
  settings_.tolerance = 1e-6;
  const Line line(
      10, 0, [](Term x, const auto&) { return -x; }, one);
  const Step step(line, inputs_, at({1, 0, 0}), settings_, 0.25);
  const StateSet end = step.after(step.length());
  const Ball exact = cos(step.length());
  EXPECT_TRUE(end.hull()[0].contains(exact.middle()));
  EXPECT_TRUE(((exact - end.centre[0]).size() - 1e-10).is_positive());
}

// x = t^2/2 - t + 0.4999 is negative for 0.03 s about t = 1, and a step of 2 s ends beyond.
TEST_P(Prover, SeesAGuardVanishWithinAStep) {
  const Line line(
      10, 0, [](Term x, const auto&) { return x.tape->constant(1); }, itself);
  const Ball height("0.4999");
  Ball length(2);
  const Passage dip = follow(line, inputs_, at({height, -1, 0}), {}, settings_, length,
                             [](const Step&, const Ball&, const Ball&) {});
  EXPECT_EQ(dip.guard, 0U);
  EXPECT_TRUE(dip.set.hull()[2].contains((1 - sqrt(1 - 2 * height)).middle()));
}

// The same from 1/2: zero is touched, and not passed.
TEST_P(Prover, DoesNotDecideWhatOnlyTouches) {
  const Line line(
      10, 0, [](Term x, const auto&) { return x.tape->constant(1); }, itself);
  EXPECT_THROW(followed(line, at({0.5, -1, 0})), Undecided);
}

INSTANTIATE_TEST_SUITE_P(Bits, Prover, testing::Values(53, 128, 512),
                         [](const auto& bits) { return std::to_string(bits.param); });

/// What the table says of the printed inputs at 150 Hz in the published equations, with which the
/// engine is compared.
Ball in_table(const std::string& quantity) {
  std::ifstream table(ROTOR_REFERENCE_DATA "/proven.csv");
  for (std::string line; std::getline(table, line);) {
    if (!line.starts_with(quantity + ",") ||
        line.find("--start-speed-hz 150 --friction 0.3 --equations published") == std::string::npos)
      continue;
    const std::size_t lower = quantity.size() + 1, upper = line.find(',', lower) + 1;
    return hull(Ball(line.substr(lower, upper - 1 - lower)),
                Ball(line.substr(upper, line.find(',', upper) - upper)));
  }
  ADD_FAILURE() << "no " << quantity;
  return {};
}

// Each sign that is wrong in the equations moves the second touch-down.
TEST(Rotor, DisagreesWithTheEngineByOneWrongSign) {
  Ball::bits = 64;
  const Ball expected = in_table("touch_down_2_s");
  const auto second_touch_down = [](const std::map<std::string, std::string>& changed) {
    Case of{.inputs = {{"start-speed-hz", "150"}}, .until = "0.015"};
    of.inputs.insert(changed.begin(), changed.end());
    Ball time;
    for (const Happening& at : prove(of).happenings)
      if (at.event == "touch_down") time = at.time_s;
    return time;
  };
  EXPECT_TRUE(second_touch_down({}).contains(expected.middle()));
  const std::array<std::pair<const char*, const char*>, 3> wrong = {
      {{"support-damping", "-25"}, {"gravity", "-9.81"}, {"friction", "-0.3"}}};
  for (const auto& [input, value] : wrong)
    EXPECT_FALSE((second_touch_down({{input, value}}) - expected).contains(0)) << input;
}

}  // namespace
}  // namespace proof
