/// What a phase says of its event functions and extremes beforehand is true: where it says that one
/// stays positive over a step, or below what an observer wants to see, nothing is looked for.
#include <gtest/gtest.h>

#include <boost/numeric/odeint.hpp>

#include "model/phases/flight.hpp"
#include "verification/support/random_scenarios.hpp"

namespace rotor {
namespace {

using Unknowns = ContactChart<double>::Unknowns;
using FlightPoint = Point<double, FlightChart<double>::Unknowns>;

/// A point of a flight, with its rates.
FlightPoint point_of(const FreeFlight<double>& phase, double time,
                     const FlightChart<double>::Unknowns& x) {
  FlightPoint at{time, x, {}};
  phase(at.x, at.rates, 0);
  return at;
}

/// The same as if nothing had changed some time later.
FlightPoint later(FlightPoint at, double by) {
  at.time += by;
  return at;
}

// Over steps of no length, at any state in rolling, with eccentricities beyond the rim and dampers
// that hold the rotor more than its springs as well.
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
    if (n % 4 == 1) {
      rotor.body.eccentricity = 0.2 * ring.rotor_radius * std::abs(any(engine));
      rotor.supports.damping = 5e3 * std::abs(any(engine));
    }
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

/// A rotor that rolls with the ring indented by a hundredth of the clearance.
struct RollingRotor {
  explicit RollingRotor(double contact_damping)
      : rotor({.contact_damping = contact_damping}, Equations::published) {}

  Unknowns unknowns() const { return chart.without_slip(chart.unknowns(q)); }

  RotorSystem<double> rotor;
  State<double> q = {1.01 * rotor.ring.clearance, 0, 0, 0, 0, 300};
  ContactChart<double> chart{rotor, q};
  Rolling<double> phase{rotor, chart};
};

// What friction can hold beyond what it must, which is at most mu |F_n|, is the same at both ends
// of a step; falling and rising as fast as they say it would be below zero in between.
TEST(RollingBounds, SayNothingOfAStepInWhichTheReserveMayDip) {
  const double h = 1e-4;
  const auto stays = [&](double damping, double velocity, double acceleration) {
    const RollingRotor rolling(damping);
    Point<double, Unknowns> from{0, rolling.unknowns(), {}}, to{h, rolling.unknowns(), {}};
    rolling.phase(from.x, from.rates, 0);
    to.rates = from.rates;
    from.x[3] -= velocity;
    to.x[3] += velocity;
    from.rates[3] = -acceleration;
    to.rates[3] = acceleration;
    return rolling.phase.event_bounds(from, to)[1].stays_positive;
  };
  const RollingRotor rolling(0);
  const double stiffness = rolling.rotor.ring.stiffness, indentation = 0.01 * 3e-3;
  const double dips = 8 * indentation / h;  // by twice all of the reserve
  EXPECT_TRUE(stays(0, 0, 0));
  EXPECT_TRUE(stays(0, dips / 100, 0));
  EXPECT_FALSE(stays(0, dips, 0));
  const double damping = 1e4;  // whose force follows the acceleration
  EXPECT_TRUE(stays(damping, 0, 0));
  EXPECT_FALSE(stays(damping, 0, dips * stiffness / damping));
}

TEST(RollingBounds, TakeTheRotorsTurnIntoWhatCurvesSwingByInAStep) {
  const RollingRotor rolling(0);
  const double h = 1e-5, ring = std::sqrt(8e8 / 5);
  EXPECT_NEAR(rolling.phase.swing(rolling.unknowns(), h), h * (ring + 300), 1e-12);
}

TEST(Bounds, AreThoseOfARotorThatTurnsTheOtherWay) {
  const RotorSystem<double> rotor(Parameters(), Equations::published);
  EXPECT_EQ(rotor.swing(2e4, -300, 1e-3), rotor.swing(2e4, 300, 1e-3));
}

// A rotor that turns faster than it vibrates on the ring: what is seen from the stator swings so,
// too.
TEST(RollingScale, IsThatOfTheFasterOfVibrationAndRotation) {
  const RollingRotor rolling(0);
  Unknowns x = rolling.unknowns();
  const double ring = std::sqrt(8e8 / 5);
  for (const double speed : {300.0, -300.0, 5 * ring, -5 * ring}) {
    x[5] = speed;
    const Unknowns scale = rolling.phase.scale(x);
    EXPECT_NEAR(scale[3] / scale[0], std::max(ring, std::abs(speed)), 1e-9 * ring) << speed;
  }
}

TEST(RubReach, IsThatOfTheEndThatReachesFurther) {
  const RollingRotor rolling(1e4);
  Point<double, Unknowns> here{0, rolling.unknowns(), {}}, there{1e-5, rolling.unknowns(), {}};
  there.x[0] *= 1.01;
  there.x[3] = 0.5;
  rolling.phase(here.x, here.rates, 0);
  rolling.phase(there.x, there.rates, 0);
  const auto forwards = rolling.phase.vibration_reach(here, there);
  EXPECT_EQ(forwards, rolling.phase.vibration_reach(there, here));
  const auto of_here = rolling.phase.vibration_reach(here, here),
             of_there = rolling.phase.vibration_reach(there, there);
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(forwards[i], std::max(of_here[i], of_there[i])) << i;
    EXPECT_NE(of_here[i], of_there[i]) << i;
  }
  // Of the oscillation about its rest that this end tells.
  const Ring<double>& ring = rolling.rotor.ring;
  const double frequency = std::sqrt(ring.stiffness / rolling.rotor.body.mass),
               to_rest = there.rates[3] / (frequency * frequency),
               amplitude = 1.5 * std::hypot(to_rest, there.x[3] / frequency),
               furthest = rolling.chart.rim_point(there.x).displacement + to_rest + amplitude;
  EXPECT_NEAR(of_there[0] / furthest, 1, 1e-12);
  EXPECT_NEAR(of_there[2] / (ring.stiffness * (furthest - ring.clearance) +
                             ring.damping * frequency * amplitude),
              1, 1e-9);
}

// A rotor that hardly turns moves as it would alone on its supports: nothing drives it, whichever
// way it moves.
TEST(FlightBounds, AreThoseOfTheAmplitudeWhereNothingDrives) {
  Parameters p;
  p.eccentricity = p.torque = p.gravity = 0;
  p.support_damping = 1000;
  const RotorSystem<double> rotor(p, Equations::consistent);
  const double frequency = std::sqrt(p.support_stiffness / p.mass), h = 0.1, speed = 0.1;
  for (double direction = 0; direction < 6; direction += 0.7) {
    const State<double> q = {0,   0, 0, speed * std::cos(direction), speed * std::sin(direction),
                             1e-9};
    const FlightChart<double> chart(rotor, q);
    const FreeFlight<double> phase(rotor, chart);
    const FlightPoint from = point_of(phase, 0, chart.unknowns(q)), to = later(from, h);
    const auto bounds = phase.event_bounds(from, to);
    const double acceleration =
        p.support_stiffness / p.mass * speed / frequency + p.support_damping / p.mass * speed;
    const double bend = 2 * (speed * speed + rotor.ring.clearance * acceleration);
    EXPECT_NEAR(*bounds[0].curvature / bend, 1, 0.01) << direction;
    EXPECT_NEAR((*phase.reach(from, to))[1] /
                    (p.support_stiffness * speed / frequency + p.support_damping * speed),
                1, 0.01)
        << direction;
  }
}

// The speed rises and falls with the rotor's weight in each turn; a bound of it has that ripple.
TEST(FlightBounds, TakeTheRippleOfTheSpeedIntoIt) {
  RotorSystem<double> rotor(Parameters{.eccentricity = 1e-3}, Equations::published);
  FlightChart<double> chart(rotor, {-1e-3, 0, 0, 0, 0, 150});
  FlightChart<double>::Unknowns turned_far = {0, 0, 40, 0, 0, 0};
  chart.recentre(turned_far);
  int faster = 0;
  for (double angle = 0; angle < 6; angle += 0.5) {
    const FlightChart<double>::Unknowns x = {0, 0, angle, 0, 0, 0};
    const double speed = chart.kinematics(x).motion.speed;
    faster += speed > chart.speed(x) + 1e-3;
    rotor.motor_off = speed * (1 - 1e-14);
    const FreeFlight<double> phase(rotor, chart);
    const FlightPoint from = point_of(phase, 0, x);
    EXPECT_FALSE(phase.event_bounds(from, later(from, 1e-7))[1].stays_positive) << angle;
  }
  EXPECT_GT(faster, 3);
}

// In free flight without damping, eccentricity or load, O moves to and fro on a line. Over a step
// from one side of its greatest displacement to the other, the bound is that, or little more.
TEST(FlightBounds, AreSharpAboutTheTurningPointOfAnUndampedOscillation) {
  const double frequency = 2000, amplitude = 2.5e-3;  // so that it moves at metres per second
  Parameters p;
  p.eccentricity = p.support_damping = p.torque = p.gravity = 0;
  p.support_stiffness = p.mass * frequency * frequency;
  const RotorSystem<double> rotor(p, Equations::consistent);
  for (const auto& [phase_angle, direction, most] : {std::tuple(0.05, 0., 1.00001),
                                                     {0.3, 0., 1.001},
                                                     {0.5, 0., 1.01},
                                                     {0.3, 1., 1.001},
                                                     {0.3, 1.5, 1.001}}) {
    const double c = std::cos(direction), s = std::sin(direction);
    const auto end = [&](double angle) {
      const double rho = amplitude * std::cos(angle),
                   rate = -amplitude * frequency * std::sin(angle);
      const State<double> q = {rho * c, rho * s, 0, rate * c, rate * s, 0};
      const FlightChart<double> chart(rotor, q);
      return point_of(FreeFlight<double>(rotor, chart), angle / frequency, chart.unknowns(q));
    };
    const FlightChart<double> chart(rotor, State<double>{});
    const auto reach = FreeFlight<double>(rotor, chart).reach(end(-phase_angle), end(phase_angle));
    ASSERT_TRUE(reach);
    EXPECT_GE((*reach)[0], amplitude) << phase_angle;
    EXPECT_LE((*reach)[0], amplitude * most) << phase_angle;
    EXPECT_GE((*reach)[1], amplitude * p.support_stiffness) << phase_angle;
  }
}

// Of a rotor so light at its rim that the damping of O brakes the rotation.
TEST(FlightBounds, AreNoneWhereDampingMayTakeHalfOfTheSpeedInAStep) {
  Parameters p{.inertia = 1e-3, .eccentricity = 1e-3};
  const double h = 1e-4;
  for (const double share : {0.49, 0.51}) {
    p.support_damping = share * p.inertia / (p.eccentricity * p.eccentricity * h);
    const RotorSystem<double> rotor(p, Equations::consistent);
    const State<double> q = {0, 0, 0, 0, 0, 100};
    const FlightChart<double> chart(rotor, q);
    const FreeFlight<double> phase(rotor, chart);
    const FlightPoint from = point_of(phase, 0, chart.unknowns(q));
    EXPECT_EQ(phase.reach(from, later(from, h)).has_value(), share < 0.5) << share;
  }
}

// Over steps in which a strong motor drives a rotor that mostly turns slowly at first, and damping
// takes up to half of its speed, no bound is less than what is reached in between.
TEST(FlightBounds, AreNeverLessThanWhatIsReachedInHeavilyDampedFlight) {
  RandomScenarios random(7);
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> any(-1, 1);
  int bounded = 0;
  for (int n = 0; n < 3000; ++n) {
    Parameters p = random.scenario().parameters;
    p.eccentricity = 1e-3;
    // So light at its rim that the damping of O brakes the rotation.
    p.inertia = p.mass * p.eccentricity * p.eccentricity * std::pow(10, 1 + any(engine));
    const double share = std::sqrt(std::abs(any(engine))) / 2;
    const double h = std::pow(10, -5 + any(engine)), turn = 0.3;  // in a step, as accuracy wants it
    p.support_damping = share * p.inertia / (p.eccentricity * p.eccentricity * h);
    p.torque = turn * std::abs(any(engine)) * p.inertia / (h * h);
    RotorSystem<double> rotor(p, Equations::consistent);
    const double rho = rotor.ring.clearance * std::abs(std::pow(any(engine), 5));
    const double velocity = 0.01 * rotor.ring.clearance / h;
    const State<double> q = {rho,
                             0,
                             0,
                             velocity * any(engine),
                             velocity * any(engine),
                             turn / h * std::pow(any(engine), 5)};
    const FlightChart<double> chart(rotor, q);
    const FreeFlight<double> phase(rotor, chart);
    const FlightPoint from = point_of(phase, 0, chart.unknowns(q));
    FlightPoint to = later(from, h);
    // In steps of a tenth of the fastest decay.
    const int steps = 20 + static_cast<int>(10 * p.support_damping / p.mass * h);
    boost::numeric::odeint::runge_kutta4<FlightChart<double>::Unknowns> stepper;
    double displacement = rho, bearing_force = 0, speed = std::abs(q[5]), bend = 0;
    std::array<double, 3> gaps{};  // the last ones, as touch-down's guard has them
    for (int i = 0; i < steps; ++i) {
      gaps = {gaps[1], gaps[2], phase.guard(0, to.x)};
      if (i > 1) bend = std::max(bend, std::abs(gaps[0] - 2 * gaps[1] + gaps[2]));
      stepper.do_step(phase, to.x, 0., h / steps);
      const auto extremes = phase.extremes(to.x, {});
      displacement = std::max(displacement, extremes[0].value);
      bearing_force = std::max(bearing_force, extremes[1].value);
      speed = std::max(speed, std::abs(chart.speed(to.x)));
    }
    phase(to.x, to.rates, 0);
    const auto reach = phase.reach(from, to);
    if (!reach) continue;
    ++bounded;
    constexpr double rounding = 1e-9;
    EXPECT_GE((*reach)[0], displacement * (1 - rounding)) << n;
    EXPECT_GE((*reach)[1], bearing_force * (1 - rounding)) << n;
    const double square = rotor.ring.clearance * rotor.ring.clearance, part = h / steps;
    EXPECT_GE(*phase.event_bounds(from, to)[0].curvature * part * part,
              bend * (1 - rounding) - 1e-15 * square)
        << n;
    rotor.motor_off = speed * (1 - rounding);
    EXPECT_FALSE(phase.event_bounds(from, to)[1].stays_positive) << n;
  }
  EXPECT_GT(bounded, 1000);
}

}  // namespace
}  // namespace rotor
