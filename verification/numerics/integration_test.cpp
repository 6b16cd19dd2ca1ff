/// The integration library without a rotor: the search for zeros of functions with known zeros; the
/// interpolation that it uses; the stepper; steps and events of toy systems.
#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <random>

#include "model/integration/fehlberg.hpp"
#include "model/integration/step.hpp"
#include "model/integration/verner.hpp"
#include "model/mechanics/parameters.hpp"

namespace rotor {
namespace {

constexpr double resolution = 1e-13;

/// Searches f between 0 and 1. `bend` bounds |f''| if given.
template <class F, class Slope>
std::optional<double> crossing(const F& f, const Slope& slope,
                               std::optional<double> bend = std::nullopt) {
  const auto at = [&](double t) { return ValueAndSlope<double>{t, f(t), slope(t)}; };
  return first_crossing(at(0), at(1), resolution, bend, at);
}

// The first zero of a polynomial, on its far side, however small the polynomial is and however near
// its last zero is to the end of the step.
TEST(Crossing, IsTheFirstOfSeveralInOneStep) {
  std::mt19937_64 random(1);
  const auto up_to = [&](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  for (int run = 0; run < 1000; ++run) {
    std::vector<double> zeros = {(10 + up_to(14)) / 100.};
    for (int more = up_to(3); more > 0; --more)
      zeros.push_back(zeros.back() + (10 + up_to(14)) / 100.);
    if (up_to(1) == 0) zeros.push_back(1 - 0.4 * resolution);
    const double size = std::pow(10, -up_to(6)) * (zeros.size() % 2 == 0 ? 1 : -1);
    const auto f = [&](double t) {
      double product = size;
      for (const double zero : zeros) product *= t - zero;
      return product;
    };
    const auto slope = [&](double t) {
      double sum = 0;
      for (std::size_t without = 0; without < zeros.size(); ++without) {
        double product = size;
        for (std::size_t n = 0; n < zeros.size(); ++n)
          if (n != without) product *= t - zeros[n];
        sum += product;
      }
      return sum;
    };
    const auto n = static_cast<double>(zeros.size());
    const double found = crossing(f, slope, n * (n - 1) * std::abs(size)).value_or(-1);
    EXPECT_LE(f(found), 0) << run;
    EXPECT_NEAR(found, zeros.front(), 2 * resolution) << run;
  }
}

TEST(Crossing, IsFoundBetweenOscillationsByTheBoundOfTheCurvature) {
  // Below zero for a hundredth of the step, in the 7th of 16 oscillations; nothing shows at the
  // ends.
  const double k = two_pi * 16;
  const auto f = [&](double t) {
    return 1.02 + std::cos(k * t) - 0.1 * std::exp(-400 * (t - 0.41) * (t - 0.41));
  };
  const auto slope = [&](double t) {
    return -k * std::sin(k * t) + 80 * (t - 0.41) * std::exp(-400 * (t - 0.41) * (t - 0.41));
  };
  const auto zero = crossing(f, slope, k * k + 80);
  ASSERT_TRUE(zero);
  EXPECT_LE(f(*zero), 0);
  EXPECT_GT(f(*zero - 1e-6), 0);
  for (double t = 0; t < *zero - 1e-9; t += 1e-5) ASSERT_GE(f(t), 0) << t;
}

/// Functions that are zero or nearly zero at an end of the step, with their slopes and crossings.
struct NearAnEnd {
  const char* what;
  double (*f)(double);
  double (*slope)(double);
  std::optional<double> zero;
};
constexpr NearAnEnd near_an_end[] = {
    {"has just left zero", [](double t) { return t; }, [](double) { return 1.; }, {}},
    {"leaves zero slowly", [](double t) { return t * t; }, [](double t) { return 2 * t; }, {}},
    {"falls from zero", [](double t) { return -t; }, [](double) { return -1.; }, 0},
    {"leaves zero, its slope there being wrong by rounding, and returns",
     [](double t) { return t * t * (0.5 - t); },
     [](double t) { return t == 0 ? -1e-20 : t * (1 - 3 * t); }, 0.5},
    {"is beyond zero by rounding, leaves it and returns",
     [](double t) { return t * (t - 1e-15) * (0.2 - t); },
     [](double t) { return (2 * t - 1e-15) * (0.2 - t) - t * (t - 1e-15); }, 0.2},
    {"is beyond zero by more than the resolution of a short step, and leaves it",
     [](double t) { return t - 1e-11; },
     [](double) { return 1.; },
     {}},
    {"crosses just after the step",
     [](double t) { return 1 + 1e-15 - t; },
     [](double) { return -1.; },
     {}},
    {"crosses at the step's end", [](double t) { return 1 - 1e-15 - t; },
     [](double) { return -1.; }, 1}};

TEST(Crossing, IsFoundOnceAtTheEndsOfAStep) {
  for (const NearAnEnd& function : near_an_end) {
    const auto found = crossing(function.f, function.slope);
    EXPECT_EQ(found.has_value(), function.zero.has_value()) << function.what;
    EXPECT_NEAR(found.value_or(0), function.zero.value_or(0), 2 * resolution) << function.what;
  }
}

TEST(Crossing, EndsWhereTheFunctionIsNotFinite) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  int evaluations = 0;
  const auto f = [&](double t) { return ++evaluations, ValueAndSlope<double>{t, none, none}; };
  first_crossing<double>({0, 1, -1}, {1, 1, 1}, resolution, std::nullopt, f);
  first_crossing<double>({0, 1, -1}, {1, 1, 1}, resolution, 100., f);
  EXPECT_EQ(evaluations, 2);
}

TEST(Crossing, IsNotSearchedWhereAFunctionLeavesZeroFromBeyondItByRounding) {
  int looks = 0;
  const auto look = [&](double t) { return ++looks, ValueAndSlope<double>{t, t - 1e-17, 1}; };
  EXPECT_FALSE(first_crossing<double>(look(0), look(1), resolution, 1., look));
  EXPECT_EQ(looks, 2);  // at the ends
}

constexpr double gravity = 9.81;

/// A system of two unknowns of size one, with one event and no bounds.
struct Toy {
  using Unknowns = std::array<double, 2>;
  static constexpr std::size_t event_count = 1;
  struct Bounds {
    std::array<EventBound<double>, 1> events{};
  };
  Bounds bounds(const Point<double, Unknowns>&, const Point<double, Unknowns>&) const { return {}; }
  Unknowns scale(const Unknowns&) const { return {1, 1}; }
};

/// A ball that falls to the floor, x = {height, velocity}. Its event: it meets the floor.
struct Ball : Toy {
  void operator()(const Unknowns& x, Unknowns& rates, double /*time*/) const {
    rates = {x[1], -gravity};
  }
  double event(std::size_t, const Unknowns& x) const { return x[0]; }
};

/// A pendulum of unit frequency, x = {angle, rate}. Its event: it changes sides.
struct Pendulum : Toy {
  double side = 1;

  void operator()(const Unknowns& x, Unknowns& rates, double /*time*/) const {
    rates = {x[1], -std::sin(x[0])};
  }
  double event(std::size_t, const Unknowns& x) const { return side * x[0]; }
  static double energy(const Unknowns& x) { return x[1] * x[1] / 2 - std::cos(x[0]); }
};

using State2 = std::array<double, 2>;
using Stepper2 = Verner87<State2, double>;
using Control2 = ErrorControl<double, Stepper2>;
using Point2 = Control2::Point;

/// Odeint's pairs whose last stage is the first of the next step (first same as last). A Step does
/// not take the rates at its end from there.
template <class Odeint>
struct FirstSameAsLast : Odeint {
  template <class System>
  void do_step(System system, const State2& x, const State2& rates, double time, State2& later,
               double length, State2& errors) {
    State2 unused;
    Odeint::do_step(system, x, rates, time, later, unused, length, errors);
  }
};

static_assert(!StepperOf<boost::numeric::odeint::runge_kutta_dopri5<State2>, double>);  // as it is
static_assert(SystemOf<Ball, double> && !SystemOf<Toy, double>);  // a Toy has no rates

template <class Stepper>
struct StepBy : testing::Test {};
using Steppers =
    testing::Types<Stepper2, Fehlberg78<State2, double>,
                   boost::numeric::odeint::runge_kutta_cash_karp54<State2>,
                   FirstSameAsLast<boost::numeric::odeint::runge_kutta_dopri5<State2>>>;
TYPED_TEST_SUITE(StepBy, Steppers);

/// A step of a toy system to the time of its end.
template <class Stepper, class System>
Step<double, Stepper, System> step_of(ErrorControl<double, Stepper>& control, const System& system,
                                      Point2& start, Point2& end) {
  system(start.x, start.rates, 0);
  control.step(system, start, end);
  system(end.x, end.rates, 0);
  return {control, system, start, end};
}

/// Times and states of the events of a toy system. Each step has a given length or ends at its
/// first event, which the caller resets.
template <class Stepper = Stepper2, class System, class Reset>
std::vector<Point2> events_of(System system, Point2::Unknowns x, double length, std::size_t number,
                              const Reset& reset) {
  ErrorControl<double, Stepper> control(1e-14);
  std::vector<Point2> all;
  for (double time = 0; all.size() < number && time < 100;) {
    Point2 start{.x = x}, end{.time = length};
    auto step = step_of(control, system, start, end);
    const auto event = first_event(step);
    Point2 stop = step.stop();
    time += stop.time;
    x = stop.x;
    if (!event) continue;
    stop.time = time;
    all.push_back(stop);
    reset(system, x);
  }
  return all;
}

/// Rounding error of a step of the toy systems: the weights of the pair, up to 123, are rounded.
constexpr double rounding_of_a_step = 123 * std::numeric_limits<double>::epsilon();

TYPED_TEST(StepBy, MeetsTheFloorWhenTheClosedFormSaysSo) {
  const double height = 1, restitution = 0.8;
  const auto bounce = [&](const Ball&, Ball::Unknowns& x) { x = {0, -restitution * x[1]}; };
  // In steps shorter and longer than the flights.
  for (const double length : {0.1, 0.3, 0.9}) {
    const auto bounces = events_of<TypeParam>(Ball{}, {height, 0}, length, 4, bounce);
    ASSERT_EQ(bounces.size(), 4U);
    double fall = std::sqrt(2 * height / gravity), time = fall;
    for (const Point2& at : bounces) {
      EXPECT_NEAR(at.time, time, 100 * rounding_of_a_step) << length;  // of some forty steps
      EXPECT_LE(at.x[0], 0);  // on the far side, and close to it
      EXPECT_GT(at.x[0], -rounding_of_a_step);
      fall *= restitution;
      time += 2 * fall;
    }
  }
}

TEST(Pendulum, KeepsItsEnergyAndItsPeriodThroughEvents) {
  const double amplitude = 2;
  const auto other_side = [](Pendulum& pendulum, const Pendulum::Unknowns&) {
    pendulum.side = -pendulum.side;
  };
  const auto verticals = events_of(Pendulum{}, {amplitude, 0}, 0.05, 8, other_side);
  ASSERT_EQ(verticals.size(), 8U);
  const double period = 4 * boost::math::ellint_1(std::sin(amplitude / 2));
  for (std::size_t n = 0; n < verticals.size(); ++n) {
    const double accuracy = 1000 * rounding_of_a_step;  // of some 700 steps
    EXPECT_NEAR(verticals[n].time / (period * (0.25 + 0.5 * static_cast<double>(n))), 1, accuracy);
    EXPECT_NEAR(Pendulum::energy(verticals[n].x) / Pendulum::energy({amplitude, 0}), 1, accuracy);
  }
}

// A ball is thrown a little higher than a ceiling, by more than a step's error of some 1e-13: the
// search must find the start of the dip, on the far side.
TEST(Step, FindsTheBeginningOfAShallowDip) {
  for (int n = 0; n < 100; ++n) {
    const double depth = std::exp2(-20 - n / 5.), apex_s = 0.2 + n * 1e-4;
    Control2 control(1e-14);
    const Ball ball;
    Point2 start{.x = {depth - gravity * apex_s * apex_s / 2, gravity * apex_s}}, end{.time = 0.5};
    auto step = step_of(control, ball, start, end);
    const auto room = [](const Ball::Unknowns& x) { return -x[0]; };
    const auto dip = step.crossing(room, step.observe(room, start),
                                   step.observe(room, step.dense_output(), apex_s + 0.1), gravity);
    ASSERT_TRUE(dip) << depth;
    EXPECT_LE(room(dip->x), 0) << depth;
    const double half_s = std::sqrt(2 * depth / gravity);
    EXPECT_NEAR(dip->time, apex_s - half_s, 1e-12 / (gravity * half_s)) << depth;
  }
}

// The end of the swing is passed within one step: where the dip begins is far from both ends, and
// the motion there must be as accurate as at the end.
TEST(Step, KeepsTheEnergyWhereADipBegins) {
  Control2 control(1e-14);
  const Pendulum pendulum;
  constexpr double greatest = 1, limit = 0.999, first = 0.9958;
  Point2 start{.x = {first, std::sqrt(2 * (std::cos(first) - std::cos(greatest)))}},
      end{.time = 0.2};
  auto step = step_of(control, pendulum, start, end);
  const auto room = [](const Pendulum::Unknowns& x) { return limit - x[0]; };
  const auto dip = step.crossing(room, step.observe(room, start), step.observe(room, end));
  ASSERT_TRUE(dip);
  EXPECT_NEAR(dip->x[0], limit, rounding_of_a_step);
  EXPECT_NEAR(Pendulum::energy(dip->x) / Pendulum::energy(start.x), 1, rounding_of_a_step);
}

TYPED_TEST(StepBy, HasADenseOutputOfItsOwnOrder) {
  const Pendulum system;
  ErrorControl<double, TypeParam> control(1e-10);
  const auto largest_error = [&](double length) {
    Point2 start{.x = {1, 0.5}}, end{.time = length};
    auto step = step_of(control, system, start, end);
    double largest = 0;
    for (int i = 1; i < 10; ++i) {
      Point2 exact = start;  // by ten short steps to there
      for (int k = 1; k <= 10; ++k) {
        Point2 next{.time = length * i * k / 100};
        control.step(system, exact, next);
        system(next.x, next.rates, 0);
        exact = next;
      }
      largest = std::max(largest, std::abs(step.at(exact.time).x[0] - exact.x[0]));
    }
    return largest;
  };
  constexpr int order = TypeParam::stepper_order_value;  // a constant that Odeint only declares
  EXPECT_GT(std::log2(largest_error(0.25) / largest_error(0.125)) + 0.1, order);
}

// The step after one that was too long has 0.9^order of the allowed error, 0.4 or 0.6, or less by
// the terms of higher order in the long one.
TYPED_TEST(StepBy, HasALengthThatMeetsTheTolerance) {
  const Pendulum system;
  ErrorControl<double, TypeParam> control(1e-10);
  const auto error_in = [&](double length) {
    Point2 start{.x = {1, 0.5}}, end{.time = length};
    system(start.x, start.rates, 0);
    return control.step(system, start, end);
  };
  double length = 1e-3;
  while (error_in(length) < 30) length *= 2;
  const double next = error_in(length * control.step_factor(error_in(length)));
  EXPECT_LT(next, 1);
  EXPECT_GT(next, 0.1);
}

TEST(ErrorControl, CallsAMotionThatIsNotFiniteInfinitelyWrong) {
  Control2 control(1e-10);
  Point2 start{.x = {std::numeric_limits<double>::quiet_NaN(), 0}}, end{.time = 1};
  EXPECT_EQ(control.step(Ball{}, start, end), std::numeric_limits<double>::infinity());
  EXPECT_LT(control.step_factor(std::numeric_limits<double>::infinity()), 1);
}

}  // namespace
}  // namespace rotor
