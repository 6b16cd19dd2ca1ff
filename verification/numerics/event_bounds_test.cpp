/// The bounds that a phase gives beforehand for its event functions and extremes are true: if one
/// stays positive over a step, or below what an observer wants to see, it is not searched.
#include <gtest/gtest.h>

#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "model/phases/flight.hpp"
#include "verification/support/random_inputs.hpp"

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

/// The same point some time later, as if nothing had changed.
FlightPoint later(FlightPoint at, double by) {
  at.time += by;
  return at;
}

// Over steps of no length, at any state in rolling, with eccentricities beyond the rim and dampers
// that hold the rotor more than its springs as well.
TEST(RollingBounds, SayOnlyOfARimThatIsHeldThatItIs) {
  RandomInputs random(5);
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
      rotor.acting.supports.damping = 5e3 * std::abs(any(engine));
    }
    const double rho = ring.clearance * (1 + 0.1 * std::abs(any(engine)));
    const double direction = 3 * any(engine), speed = two_pi * scenario.start_speed_Hz;
    const State<double> q = {
        rho * std::cos(direction), rho * std::sin(direction), 3 * any(engine), 0, 0, speed};
    const ContactChart<double> chart(rotor, q);
    Unknowns x = chart.without_slip(chart.unknowns(q));
    x[ContactChart<double>::normal_velocity] = any(engine);
    const Rolling<double> phase(rotor, chart);
    Point<double, Unknowns> at{0, x, {}};
    phase(x, at.rates, 0);
    if (phase.bounds(at, at).events[Rolling<double>::BreakAway()].stays_positive) {
      ++held;
      held_beyond += rotor.body.eccentricity > ring.rotor_radius;
      EXPECT_GE(phase.guard(Rolling<double>::BreakAway(), x), 0) << n;
    } else {
      slipping += phase.guard(Rolling<double>::BreakAway(), x) < 0;
    }
  }
  // The bound is useful, and there were rims for which it could be wrong.
  EXPECT_GT(held, 1000);
  EXPECT_GT(slipping, 1000);
  EXPECT_EQ(held_beyond, 0);
}

// The reserve of friction is the same at both ends of a step; with the slopes there it would be
// below zero in between.
TEST(RollingBounds, SayNothingOfAStepInWhichTheReserveMayDip) {
  const double h = 1e-4, depth = 0.01 * 3e-3, dips = 8 * depth / h;  // by twice of it
  const auto stays = [&](double damping, double velocity, double acceleration) {
    const RotorSystem<double> rotor({.contact_damping = damping}, Equations::published);
    const State<double> q = {rotor.ring.clearance + depth, 0, 0, 0, 0, 300};
    const ContactChart<double> chart(rotor, q);
    const Rolling<double> phase(rotor, chart);
    Point<double, Unknowns> from{0, chart.without_slip(chart.unknowns(q)), {}};
    phase(from.x, from.rates, 0);
    auto to = from;
    to.time = h;
    using enum ContactChart<double>::Unknown;
    for (auto* const end : {&from, &to}) {
      const double sign = end == &from ? -1 : 1;
      end->x[normal_velocity] = end->rates[indentation] = sign * velocity;
      end->rates[normal_velocity] = sign * acceleration;
    }
    return phase.bounds(from, to).events[Rolling<double>::BreakAway()].stays_positive;
  };
  EXPECT_TRUE(stays(0, 0, 0));
  EXPECT_TRUE(stays(0, dips / 100, 0));
  EXPECT_FALSE(stays(0, dips, 0));
  const double damping = 1e4;  // whose force follows the acceleration
  EXPECT_TRUE(stays(damping, 0, 0));
  EXPECT_FALSE(stays(damping, 0, dips * Parameters{}.contact_stiffness / damping));
}

/// Whether a flight has bounds over a step of that length. None may be less than what many small
/// steps of another method reach in between.
bool has_bounds(RotorSystem<double> rotor, const FlightChart<double>& chart,
                const FlightChart<double>::Unknowns& x, double h) {
  const FreeFlight<double> phase(rotor, chart);
  const FlightPoint from = point_of(phase, 0, x);
  FlightPoint to = later(from, h);
  // In steps of a tenth of the fastest decay.
  const int steps = 20 + static_cast<int>(10 * rotor.acting.supports.damping / rotor.body.mass * h);
  boost::numeric::odeint::runge_kutta4<FlightChart<double>::Unknowns> stepper;
  double displacement = 0, bearing_force = 0, speed = 0, bend = 0;
  std::array<double, 3> gaps{};  // the last ones, as touch-down's guard has them
  for (int i = 0; i <= steps; ++i) {
    const auto extremes = phase.extremes(to.x, {});
    displacement = std::max(displacement, std::sqrt(extremes[0].square));
    bearing_force = std::max(bearing_force, std::sqrt(extremes[1].square));
    speed = std::max(speed, std::abs(chart.kinematics(to.x).motion.speed));
    gaps = {gaps[1], gaps[2], phase.guard(FreeFlight<double>::TouchDown(), to.x)};
    if (i > 1) bend = std::max(bend, std::abs(gaps[0] - 2 * gaps[1] + gaps[2]));
    if (i < steps) stepper.do_step(phase, to.x, 0., h / steps);
  }
  phase(to.x, to.rates, 0);
  // The response that the chart may subtract has a pole, which these small steps do not resolve.
  const double critical = rotor.support_frequency();
  for (const double pole : {-critical, critical})
    if ((chart.speed(from.x) - pole) * (chart.speed(to.x) - pole) < 0) return false;
  const double square = rotor.ring.clearance * rotor.ring.clearance, part = h / steps;
  rotor.ring.clearance = 1;  // m, far away
  const auto upper_bounds = phase.bounds(from, to).upper_bounds;
  if (!std::isfinite(upper_bounds[0])) return false;
  constexpr double rounding = 1e-9;
  EXPECT_GE(upper_bounds[0], displacement * (1 - rounding));
  EXPECT_GE(upper_bounds[1], bearing_force * (1 - rounding));
  rotor.ring.clearance = displacement;  // just touched
  EXPECT_GE(*phase.bounds(from, to).events[FreeFlight<double>::TouchDown()].curvature * part * part,
            bend * (1 - rounding) - 1e-15 * square);
  rotor.motor_on = true;
  rotor.motor_off = speed * (1 - rounding) - 1e-18;  // rounding, of a rotor that nothing turns
  EXPECT_FALSE(phase.bounds(from, to).events[FreeFlight<double>::MotorOff()].stays_positive);
  return true;
}

// A strong motor drives a rotor that mostly turns slowly at first, with so little inertia that the
// damping of O takes up to half of its speed in a step.
TEST(FlightBounds, AreNeverLessThanWhatIsReachedInHeavilyDampedFlight) {
  RandomInputs random(7);
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> any(-1, 1);
  int bounded = 0;
  for (int n = 0; n < 3000; ++n) {
    SCOPED_TRACE(n);
    Parameters p = random.scenario().parameters;
    p.eccentricity = 1e-3;
    p.inertia = p.mass * p.eccentricity * p.eccentricity * std::pow(10, 1 + any(engine));
    const double share = std::sqrt(std::abs(any(engine))) / 2;
    const double h = std::pow(10, -5 + any(engine)), turn = 0.3;  // per step, for accuracy
    p.support_damping = share * p.inertia / (p.eccentricity * p.eccentricity * h);
    p.torque = turn * std::abs(any(engine)) * p.inertia / (h * h);
    const RotorSystem<double> rotor(p, Equations::corrected);
    const double rho = rotor.ring.clearance * std::abs(std::pow(any(engine), 5));
    const double velocity = 0.01 * rotor.ring.clearance / h;
    const State<double> q = {rho,
                             0,
                             0,
                             velocity * any(engine),
                             velocity * any(engine),
                             turn / h * std::pow(any(engine), 5)};
    const FlightChart<double> chart(rotor, q);
    bounded += has_bounds(rotor, chart, chart.unknowns(q), h);
  }
  EXPECT_GT(bounded, 1000);
}

// The speed rises and falls with the rotor's weight in each turn, and O swings about the
// synchronous motion that the chart subtracts, or about the steady response: bounds have both in
// them. A chart that was kept while the rotor swung has turned, and its speed has changed.
TEST(FlightBounds, AreNeverLessThanWhatIsReachedAboutTheSynchronousMotion) {
  RandomInputs random(9);
  std::mt19937_64 engine(10);
  std::uniform_real_distribution<double> any(-1, 1);
  int bounded = 0, rippling = 0, kept = 0;
  for (int n = 0; n < 3000; ++n) {
    SCOPED_TRACE(n);
    const Scenario scenario = random.scenario();
    RotorSystem<double> rotor(scenario.parameters, scenario.equations);
    if (n % 3 == 0) rotor.acting.weight.gravity = 0;
    const double speed = two_pi * scenario.start_speed_Hz, e = rotor.body.eccentricity;
    const double swing = 0.1 * rotor.ring.clearance, frequency = rotor.support_frequency(),
                 h = 0.3 / std::max(std::abs(speed), frequency);
    const bool is_kept = n % 4 == 2;
    const Vector<double> at_rest = rotor.acting.supports.rest,
                         rate = -speed * quarter_turn(at_rest);
    FlightChart<double> chart(rotor, {at_rest.x() - e, at_rest.y(), 0, rate.x(), rate.y(), speed});
    FlightChart<double>::Unknowns turned_far = {
        at_rest.x() + (is_kept ? swing : 0), at_rest.y(), 40, 0, 0, 0};
    if (n % 2 == 0) chart.recentre(turned_far);
    kept += is_kept && chart.scale(1, 1, 1)[5] == 0.1 &&
            chart.synchronous_amplitudes(turned_far).displacement > 0;
    if (!std::isfinite(h)) continue;  // without springs and speed
    const Vector<double> rest = chart.deviation(turned_far) - chart.vibration(turned_far);
    const FlightChart<double>::Unknowns x = {rest.x() + swing * any(engine),
                                             rest.y() + swing * any(engine),
                                             3 * any(engine),
                                             swing * frequency * any(engine),
                                             swing * frequency * any(engine),
                                             is_kept ? 0.3 * speed * any(engine) : 0};
    rippling += std::abs(chart.kinematics(x).motion.speed - chart.speed(x)) > 1e-6;
    bounded += has_bounds(rotor, chart, x, h);
  }
  EXPECT_GT(bounded, 1000);
  EXPECT_GT(rippling, 100);
  EXPECT_GT(kept, 100);
}

// Otherwise a motor of 10^10 N m that is off would make each flight a search for contacts.
TEST(FlightBounds, DoNotCountAMotorThatIsOff) {
  RotorSystem<double> rotor({.torque = 1e10}, Equations::corrected);
  const State<double> q = {1e-3, 0, 0, 0.1, 0, 900};
  const auto bounds = [&](bool motor_on) {
    rotor.motor_on = motor_on;
    const FlightChart<double> chart(rotor, q);
    const FreeFlight<double> phase(rotor, chart);
    const FlightPoint from = point_of(phase, 0, chart.unknowns(q));
    return phase.bounds(from, later(from, 1e-3)).upper_bounds[1];
  };
  EXPECT_GT(bounds(true), 1e3 * bounds(false));
}

}  // namespace
}  // namespace rotor
