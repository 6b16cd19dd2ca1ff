/// Independent derivations and closed forms, each to the accuracy of the integrator.
#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <complex>
#include <random>

#include "model/event_method.hpp"

namespace rotor {
namespace {

struct Events : Observer {
  using Observer::see;
  void see(const Instant& at) override {
    if (at.event != Event::none) all.push_back(at);
  }
  const Instant& first(Event kind) const { return *std::ranges::find(all, kind, &Instant::event); }
  std::vector<Instant> all;
};

struct Outcome {
  Instant last;
  Events events;
};

/// From an instant on, without mass loss, for some time.
Outcome follow_motion_from(Scenario scenario, const Instant& from, double duration_s) {
  scenario.parameters.separates = false;
  Outcome outcome;
  Work work;
  outcome.last = EventMethod<double>(scenario, 1e-13, outcome.events, work).rub(from, duration_s);
  return outcome;
}

/// The same from a state clear of the ring.
Outcome follow_motion(const Scenario& scenario, const State<double>& state, double duration_s,
                      bool motor_on = false) {
  Instant at = start(scenario);
  at.state = state;
  at.motor_on = motor_on;
  return follow_motion_from(scenario, at, duration_s);
}

/// A scenario without anything but the rotor and the ring.
Scenario bare() {
  Scenario scenario;
  Parameters& p = scenario.parameters;
  p.support_stiffness = p.support_damping = p.gravity = p.torque = p.eccentricity = 0;
  p.friction = p.contact_damping = 0;
  return scenario;
}

// Newton's laws in the stator's frame, written out anew: O at (x, y), mass centre C at distance e
// in the direction of the angle, x downwards.
TEST(NewtonsLaws, GiveTheSameAccelerationsInTheStatorsFrame) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int n = 0; n < 1000; ++n) {
    const Parameters p;
    const Equations equations = n % 2 == 0 ? Equations::published : Equations::consistent;
    const double w = 1000 * draw(random), angle = 10 * draw(random);
    const State<double> q = {3.3e-3 * draw(random), 3.3e-3 * draw(random), angle,
                             10 * draw(random),     10 * draw(random),     w};
    const double c = std::cos(angle), s = std::sin(angle);

    // Position and velocity of O in the stator's frame.
    const double x = c * q[0] - s * q[1], y = s * q[0] + c * q[1];
    const double vx = c * q[3] - s * q[4] - w * y, vy = s * q[3] + c * q[4] + w * x;
    const double rho = std::hypot(x, y), delta = rho + p.rotor_radius - p.stator_radius;
    const double nx = x / rho, ny = y / rho, rate = vx * nx + vy * ny;
    const double slip = -vx * ny + vy * nx + p.rotor_radius * w;
    double pressure = p.contact_stiffness * delta + p.contact_damping * rate;
    if (delta <= 0 || pressure < 0) pressure = 0;
    const double friction = (slip > 0 ? -1 : 1) * p.friction * pressure;

    const double fx =
        -p.support_stiffness * x - p.support_damping * vx - pressure * nx - friction * ny;
    const double fy =
        -p.support_stiffness * y - p.support_damping * vy - pressure * ny + friction * nx;
    const double ex = p.eccentricity * c, ey = p.eccentricity * s;
    // Moments about C: supports and F_n act at O, friction at K.
    const double kx = p.rotor_radius * nx - ex, ky = p.rotor_radius * ny - ey;
    double moment = p.torque;
    const double sx = fx + friction * ny, sy = fy - friction * nx;  // all but friction
    moment += -ex * sy + ey * sx + kx * friction * nx + ky * friction * ny;
    // Gravity's moment about O_a: of the whole weight as printed, of C's offset if balanced.
    moment += -p.mass * p.gravity * (equations == Equations::published ? y + ey : ey);
    const double angular = moment / p.inertia;
    // C's acceleration is that of O with the turn about it.
    const double ox = fx / p.mass + angular * ey + w * w * ex;
    const double oy = fy / p.mass - angular * ex + w * w * ey;

    const Body<double> body = Body<double>::of(p);
    const Supports<double> supports(p, equations);
    const Ring<double> ring(p);
    const auto m = RotatingFrame<double>::motion(body, q);
    auto loads = supports.loads(body, m, true);
    const auto k = ring.rim_point(m);
    const double normal = ring.normal_force(k);
    loads += ring.loads(k, {normal, ring.sliding_friction(normal, k.slip_velocity > 0 ? 1 : -1)});
    const auto a = acceleration(body, m, loads);
    const Vector<double> of_O = in_stator_frame(acceleration_of_centre(a, m), angle);
    // Rounding of the largest term, and that of rho in the stiff spring: 8e8 N/m of 1e-18 m.
    const double accuracy = 1e-12 * (1 + std::abs(ox) + std::abs(oy) + pressure / p.mass) + 5e-9;
    EXPECT_NEAR(of_O.x(), ox, accuracy);
    EXPECT_NEAR(of_O.y(), oy, accuracy);
    EXPECT_NEAR(a.angular, angular, 1e-12 * std::abs(angular) + 100 * accuracy);
  }
}

TEST(SteadyUnbalance, HasTheAmplitudeAndThePhaseLagOfTheJeffcottRotor) {
  for (const double ratio : {0.5, 0.95, 1.05, 3., 15.}) {  // of speed to eigenfrequency
    Scenario scenario = bare();
    Parameters& p = scenario.parameters;
    p.support_stiffness = 20e3;
    p.support_damping = 60;
    p.eccentricity = 0.15e-3;
    p.inertia = 1e9;  // keeps the speed
    p.stator_radius = 0.07;
    const double w_n = std::sqrt(p.support_stiffness / p.mass), w = ratio * w_n;
    const Outcome outcome = follow_motion(scenario, {0, 0, 0, 0, 0, w}, 6);
    // In the rotating axes: (k - m w^2 + i d w) q = m e w^2. Behind the unbalance: negative angle.
    const std::complex<double> expected =
        p.mass * p.eccentricity * w * w /
        std::complex<double>(p.support_stiffness - p.mass * w * w, p.support_damping * w);
    EXPECT_LT(std::arg(expected), 0);
    // Free vibration has decayed to exp(-6 d / 2m) = 2e-16.
    const double accuracy = 1e-11 * std::abs(expected) + 1e-15;
    EXPECT_NEAR(outcome.last.state[0], expected.real(), accuracy) << ratio;
    EXPECT_NEAR(outcome.last.state[1], expected.imag(), accuracy) << ratio;
  }
}

TEST(SuddenUnbalance, TouchesTheRingWhenTheClosedFormSaysSo) {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.support_stiffness = 20e3;
  p.support_damping = 25;
  p.eccentricity = 0.45e-3;
  p.inertia = 1e9;
  const double w = 900, w_n = std::sqrt(p.support_stiffness / p.mass);
  const double decay = p.support_damping / (2 * p.mass);
  const std::complex<double> i(0, 1);
  const auto steady =
      p.mass * p.eccentricity * w * w /
      std::complex<double>(p.support_stiffness - p.mass * w * w, p.support_damping * w);
  // z = steady e^{iwt} + (A e^{i w_d t} + B e^{-i w_d t}) e^{-decay t}, at rest at the centre
  // first.
  const double w_d = std::sqrt(w_n * w_n - decay * decay);
  const std::complex<double> z0 = -steady, v0 = -i * w * steady;
  const auto a = (v0 - (-decay - i * w_d) * z0) / (2. * i * w_d), b = z0 - a;
  const auto gap = [&](double t) {
    const auto z = steady * std::exp(i * w * t) +
                   (a * std::exp(i * w_d * t) + b * std::exp(-i * w_d * t)) * std::exp(-decay * t);
    return 3e-3 - std::abs(z);
  };
  double before = 0;
  while (gap(before + 1e-5) > 0) before += 1e-5;
  const auto [low, high] = boost::math::tools::bisect(
      gap, before, before + 1e-5, boost::math::tools::eps_tolerance<double>(50));
  // At rest at the centre: the velocity of O is zero.
  const Outcome outcome = follow_motion(scenario, {0, 0, 0, 0, 0, w}, 0.05);
  EXPECT_NEAR(outcome.events.first(Event::touch_down).time_s, (low + high) / 2, 1e-13);
}

TEST(RunUp, ThroughTheCriticalSpeedIsDuhamelsIntegral) {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.support_stiffness = 20e3;
  p.support_damping = 25;
  p.eccentricity = 0.15e-3;
  const double acceleration = 30;
  p.inertia = 1e9;
  p.torque = acceleration * p.inertia;
  p.motor_off_Hz = 1e6;
  const double end = 3;
  const Outcome outcome = follow_motion(scenario, {0, 0, 0, 0, 0, 0}, end, true);
  // C's equation: m c'' + d c' + k c = (k + d d/dt) e exp(i a t^2/2), from c = e at rest; O = c - e
  // exp().
  const double decay = p.support_damping / (2 * p.mass);
  const double w_d = std::sqrt(p.support_stiffness / p.mass - decay * decay);
  const std::complex<double> i(0, 1);
  const auto e = [&](double t) { return p.eccentricity * std::exp(i * acceleration * t * t / 2.); };
  const auto response = [&](double t) {
    return std::exp(-decay * (end - t)) * std::sin(w_d * (end - t)) / (p.mass * w_d) *
           (p.support_stiffness + p.support_damping * i * acceleration * t) * e(t);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const auto part = [&](bool imaginary) {
    return Rule::integrate(
        [&](double t) { return imaginary ? response(t).imag() : response(t).real(); }, 0., end, 12,
        1e-13);
  };
  const std::complex<double> free = p.eccentricity * std::exp(-decay * end) *
                                    (std::cos(w_d * end) + decay / w_d * std::sin(w_d * end));
  const std::complex<double> centre = free + std::complex<double>(part(false), part(true)) - e(end);
  const auto O =
      in_stator_frame({outcome.last.state[0], outcome.last.state[1]}, outcome.last.state[2]);
  EXPECT_GT(std::abs(centre), 1e-5);
  EXPECT_NEAR(O.x(), centre.real(), 1e-13);  // of 7e-5 m: a hundred steps of 1e-15 m
  EXPECT_NEAR(O.y(), centre.imag(), 1e-13);
}

class Impact : public testing::TestWithParam<double> {};

TEST_P(Impact, OfSpringAndDashpotHasTheDurationRestitutionAndDepthOfTheClosedForm) {
  const double zeta = GetParam();
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  const double w_0 = std::sqrt(p.contact_stiffness / p.mass), v_0 = 0.7;
  p.contact_damping = 2 * zeta * std::sqrt(p.contact_stiffness * p.mass);
  const Outcome outcome = follow_motion(scenario, {0, 0, 0, v_0, 0, 0}, 6e-3);
  const Instant& touch = outcome.events.first(Event::touch_down);
  const Instant& release = outcome.events.first(Event::release);
  const double root = std::sqrt(1 - zeta * zeta);
  const double restitution = std::exp(-2 * zeta * std::acos(zeta) / root);
  EXPECT_NEAR(touch.time_s, 3e-3 / v_0, 1e-15);
  EXPECT_NEAR((release.time_s - touch.time_s) / (2 * std::acos(zeta) / (w_0 * root)), 1, 1e-10);
  EXPECT_NEAR(-release.state[3] / v_0 / restitution, 1, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Damping, Impact, testing::Values(0.01, 0.079, 0.3, 0.7, 0.95),
                         [](const auto& zeta) {
                           return "Zeta" + std::to_string(static_cast<int>(1000 * zeta.param));
                         });

/// An oblique impact on a wall that is as straight as a stiff ring is short of contact time.
struct Oblique {
  Oblique(double slip, double friction, double stiffness) {
    scenario.parameters.friction = friction;
    scenario.parameters.contact_stiffness = stiffness;
    const double r = scenario.parameters.rotor_radius;
    const Outcome outcome =
        follow_motion(scenario, {0, 0, 0, normal, 0, slip / r}, 3.5e-3 / normal);
    after = outcome.events.first(Event::ring_clear);
    touch = outcome.events.first(Event::touch_down);
    slip_after = Ring<double>(scenario.parameters).rim_point(after.motion()).slip_velocity;
    rolled = std::ranges::count(outcome.events.all, Event::rolling_onset, &Instant::event) > 0;
  }

  /// I w - m r v_t, which friction cannot change.
  double invariant(const Instant& at) const {
    const Parameters& p = scenario.parameters;
    const auto m = at.motion();
    const auto k = Ring<double>(p).rim_point(m);
    return p.inertia * m.speed - p.mass * p.rotor_radius * k.tangent.dot(m.velocity);
  }

  static constexpr double normal = 0.5;
  Scenario scenario = bare();
  Instant touch, after;
  double slip_after = 0;
  bool rolled = false;
};

TEST(ObliqueImpact, SlidesThroughoutAboveTheClosedFormsSlipAndEndsRollingBelowIt) {
  const Parameters p;
  const double lever = 1 + p.mass * p.rotor_radius * p.rotor_radius / p.inertia, mu = 0.1;
  const double critical = mu * 2 * Oblique::normal * lever;  // restitution 1 without dashpot
  const double stiffness = 1e13;
  const Oblique fast(1.5 * critical, mu, stiffness), slow(0.5 * critical, mu, stiffness);
  EXPECT_FALSE(fast.rolled);
  // The ring's curve turns the normal by v_t t_c / rho: 1e-4 rad of what passes.
  EXPECT_NEAR(fast.slip_after, 0.5 * critical, 1e-3 * critical);
  EXPECT_TRUE(slow.rolled);
  EXPECT_NEAR(slow.slip_after, 0, 1e-3 * critical);
  EXPECT_NEAR(slow.invariant(slow.after) / slow.invariant(slow.touch), 1, 1e-3);
  // The deviation is the contact's duration and shrinks as 1/sqrt(k_t).
  const Oblique soft(1.5 * critical, mu, stiffness / 100);
  EXPECT_LT(std::abs(fast.slip_after - 0.5 * critical),
            0.2 * std::abs(soft.slip_after - 0.5 * critical));
}

/// A rotor without unbalance that is pressed against the ring by its own whirl.
State<double> whirling(const Parameters& p, double indentation, double speed, double slip) {
  const double rho = p.stator_radius - p.rotor_radius + indentation;
  const double tangential = slip - p.rotor_radius * speed;
  return {rho, 0, 0, 0, tangential - speed * rho, speed};
}

TEST(RollingInTheRing, EndsWithTheSpeedThatTheInvariantLeaves) {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.friction = 0.3;
  p.contact_damping = 1e4;
  const double speed = 300, slip = 5;
  const double tangential = slip - p.rotor_radius * speed;
  const double indentation = p.mass * tangential * tangential / 3.3e-3 / p.contact_stiffness;
  const Outcome outcome = follow_motion(scenario, whirling(p, indentation, speed, slip), 0.05);
  ASSERT_EQ(outcome.last.contact, ContactState::rolling);
  // Friction F changes I w by F r and m v_t by F: I w - m r v_t stays as it is until v_t = -r w.
  const double expected = (p.inertia * speed - p.mass * p.rotor_radius * tangential) /
                          (p.inertia + p.mass * p.rotor_radius * p.rotor_radius);
  EXPECT_NEAR(outcome.last.state[5] / expected, 1, 0.02);  // Delta, and v_t Delta' while it settles
}

TEST(RollingInTheRing, SlowsDownWithTheSupportsDampingAtTheClosedFormsRate) {
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  p.friction = 3;
  p.contact_damping = 1e4;
  p.contact_stiffness = 1e11;  // rho stays constant
  p.support_damping = 25;
  const double speed = 200, tangential = p.rotor_radius * speed;
  const double indentation = p.mass * tangential * tangential / 3e-3 / p.contact_stiffness;
  Instant at = start(scenario);
  at.motor_on = false;
  at.contact = ContactState::rolling;
  at.state = whirling(p, indentation, speed, 0);
  const double duration = 0.2;
  const Instant last = follow_motion_from(scenario, at, duration).last;
  ASSERT_EQ(last.contact, ContactState::rolling);
  const double rate = p.support_damping / (p.mass + p.inertia / (p.rotor_radius * p.rotor_radius));
  // Exact for constant rho; it changes by Delta / rho = 1e-3 over the run, and its rate is 5e-3 /
  // s.
  EXPECT_NEAR(std::log(speed / last.state[5]) / (rate * duration), 1, 5e-3);
}

/// Dry-friction whirl: a rotor without unbalance, too heavy to turn for friction to slow it down,
/// that slides around the ring backwards at the rate Omega, held up by the supports' damping alone.
struct SlidingWhirl : testing::Test {
  SlidingWhirl() {
    Parameters& p = scenario.parameters;
    p.support_stiffness = Parameters{}.support_stiffness;
    p.support_damping = 2 * zeta * p.mass * w_n();
    p.contact_stiffness = beta * p.support_stiffness;
    p.contact_damping = 0.2 * std::sqrt(p.contact_stiffness * p.mass);  // radial motion settles
    p.friction = 0.4;
    p.inertia = 1e9;
  }

  double w_n() const {
    return std::sqrt(scenario.parameters.support_stiffness / scenario.parameters.mass);
  }

  /// How a whirl at that rate and indentation ends: rolling if it has grown, released if it dies.
  Event fate(double whirl, double indentation) const {
    const Parameters& p = scenario.parameters;
    const double rho = p.stator_radius - p.rotor_radius + indentation;
    const double speed = 5 * whirl * rho / p.rotor_radius;  // far from rolling
    Instant at = start(scenario);
    at.motor_on = false;
    at.contact = ContactState::sliding;
    at.state = whirling(p, indentation, speed, p.rotor_radius * speed - whirl * rho);
    const Outcome outcome = follow_motion_from(scenario, at, 30);
    const auto ends = [](const Instant& i) {
      return i.event == Event::rolling_onset || i.event == Event::release;
    };
    const auto end = std::ranges::find_if(outcome.events.all, ends);
    return end == outcome.events.all.end() ? Event::none : end->event;
  }

  static constexpr double zeta = 0.1, beta = 100;
  Scenario scenario = bare();
};

TEST_F(SlidingWhirl, GrowsAboveTheRateOfTheClosedFormAndDiesBelowIt) {
  const Parameters& p = scenario.parameters;
  const double whirl = w_n() * (zeta / p.friction + std::hypot(1, zeta / p.friction));
  // Friction balances damping: mu k_t Delta = d Omega rho.
  const double share = p.support_damping * whirl / (p.friction * p.contact_stiffness);
  const double indentation = (p.stator_radius - p.rotor_radius) * share / (1 - share);
  // A relative deviation of 1e-9 grows by e every 0.15 s or less, to its end within 30 s.
  EXPECT_EQ(fate(whirl * (1 + 1e-9), indentation), Event::rolling_onset);
  EXPECT_EQ(fate(whirl * (1 - 1e-9), indentation), Event::release);
}

TEST_F(SlidingWhirl, NeedsTheFrictionOfTheClosedFormHoweverDeepItBegins) {
  const double whirl = w_n() * std::sqrt(1 + beta);  // of a rotor whose clearance does not count
  const double least = 2 * zeta * std::sqrt(1 + beta) / beta, deep = 100 * 3e-3;
  // The clearance, a hundredth of the indentation, moves the limit by about as much.
  scenario.parameters.friction = 1.05 * least;
  EXPECT_EQ(fate(whirl, deep), Event::rolling_onset);
  scenario.parameters.friction = 0.95 * least;
  EXPECT_EQ(fate(whirl, deep), Event::release);
}

}  // namespace
}  // namespace rotor
