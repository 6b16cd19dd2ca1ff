/// Closed forms of the response to an unbalance, each to the accuracy of the integrator.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <complex>

#include "verification/support/bare.hpp"
#include "verification/support/law.hpp"

namespace rotor {
namespace {

TEST(SteadyUnbalance, HasTheAmplitudeAndThePhaseLagOfTheJeffcottRotor) {
  // Free vibration has decayed to exp(-6 d / 2m) = 2e-16.
  Law law("steady response to unbalance", 1e-11);
  for (const double ratio : {0.5, 0.95, 1.05, 3., 15.}) {  // of speed to eigenfrequency
    Scenario scenario = bare();
    Parameters& p = scenario.parameters;
    p.support_stiffness = 20e3;
    p.support_damping = 60;
    p.eccentricity = 0.15e-3;
    p.inertia = 1e9;  // keeps the speed
    p.stator_radius = 0.07;
    const double w_n = std::sqrt(p.support_stiffness / p.mass), w = ratio * w_n;
    const EventRecorder run = follow_from_state(scenario, {0, 0, 0, 0, 0, w}, 6);
    // In the rotating axes: (k - m w^2 + i d w) q = m e w^2. Behind the unbalance: negative angle.
    const std::complex<double> expected =
        p.mass * p.eccentricity * w * w /
        std::complex<double>(p.support_stiffness - p.mass * w * w, p.support_damping * w);
    EXPECT_LT(std::arg(expected), 0);
    law.expect_left((run.last().state[0] - expected.real()) / std::abs(expected));
    law.expect_left((run.last().state[1] - expected.imag()) / std::abs(expected));
  }
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
  const EventRecorder run = follow_from_state(scenario, {0, 0, 0, 0, 0, 0}, end, true);
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
  const auto O = in_stator_frame({run.last().state[0], run.last().state[1]}, run.last().state[2]);
  EXPECT_GT(std::abs(centre), 1e-5);
  Law law("run-up through resonance by Duhamel's integral, m", 1e-13);
  law.expect_left(O.x() - centre.real());  // of 7e-5 m: a hundred steps of 1e-15 m
  law.expect_left(O.y() - centre.imag());
}

}  // namespace
}  // namespace rotor
