/// Closed forms of impacts, each to the accuracy of the integrator or of the form.
#include <gtest/gtest.h>

#include <boost/math/special_functions/beta.hpp>

#include "model/results/energy.hpp"
#include "model/results/summary.hpp"
#include "model/scenario/observer.hpp"
#include "model/theory/accident.hpp"
#include "verification/support/bare.hpp"
#include "verification/support/law.hpp"

namespace rotor {
namespace {

class Impact : public testing::TestWithParam<double> {};

// The closed forms of model/theory also hold for an overdamped ring.
TEST_P(Impact, OfSpringAndDashpotHasTheDurationReboundAndForceOfTheClosedForm) {
  const double zeta = GetParam();
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  const double w_0 = std::sqrt(p.contact_stiffness / p.mass), v_0 = 0.7;
  p.contact_damping = 2 * zeta * std::sqrt(p.contact_stiffness * p.mass);
  EventRecorder run;
  SummaryObserver summary(scenario);
  ObserverGroup both{&run, &summary};
  Instant from = at_rest(p);
  from.state = {0, 0, 0, v_0, 0, 0};
  from.motor_on = false;
  follow(scenario, from, 8e-3, both);
  const Instant& touch = run.first(Event::touch_down);
  const Instant& release = run.first(Event::release);
  const double restitution = -release.state[3] / v_0;
  EXPECT_NEAR(touch.time_s, 3e-3 / v_0, 1e-15);
  Law("rebound of a blow by swing_after_blow()", 1e-9)
      .expect_left(restitution - swing_after_blow(zeta) * swing_after_blow(zeta));
  Law("largest force of a blow by impact()", 1e-9)
      .expect_left(*summary.summary().peak_normal_force_N /
                       (p.contact_stiffness * v_0 / w_0 * impact(zeta)) -
                   1);
  if (zeta >= 1) return;
  const double root = std::sqrt(1 - zeta * zeta);
  Law("duration of an impact of spring and dashpot", 1e-10)
      .expect_left((release.time_s - touch.time_s) / (2 * std::acos(zeta) / (w_0 * root)) - 1);
  Law("restitution of an impact of spring and dashpot", 1e-11)
      .expect_left(restitution / std::exp(-2 * zeta * std::acos(zeta) / root) - 1);
}

INSTANTIATE_TEST_SUITE_P(Damping, Impact, testing::Values(0.01, 0.079, 0.3, 0.6, 0.95, 1.2),
                         [](const auto& zeta) {
                           return "Zeta" + std::to_string(static_cast<int>(1000 * zeta.param));
                         });

/// A head-on impact with a ring of another law, with its events, indentation and energy.
struct HeadOn {
  explicit HeadOn(double exponent) {
    p.contact_exponent = exponent;
    p.reference_indentation = reference;
    scenario.parameters.loses_mass = false;
    EventRecorder run;
    SummaryObserver summary(scenario);
    EnergyObserver energy(scenario);
    ObserverGroup all{&run, &summary, &energy};
    Instant from = at_rest(p);
    from.state = {0, 0, 0, velocity, 0, 0};
    from.motor_on = false;
    all.on_instant(from);
    follow(scenario, from, 8e-3, all);
    touch = run.first(Event::touch_down);
    release = run.first(Event::release);
    restitution = -release.state[3] / velocity;
    deepest = summary.summary().peak_displacement_m.value_or(0) - Ring<double>(p).clearance;
    peak_N = *summary.summary().peak_normal_force_N;
    residual = energy.balance().residual() / energy.balance().initial;
  }

  /// Of F = k_t Delta_0 (Delta / Delta_0)^n, which stores that energy.
  double indentation_of(double energy) const {
    const double n = p.contact_exponent;
    return reference *
           std::pow((n + 1) * energy / p.contact_stiffness / reference / reference, 1 / (n + 1));
  }

  static constexpr double velocity = 0.7, reference = 37e-6;
  Scenario scenario = bare();
  Parameters& p = scenario.parameters;
  Instant touch, release;
  double restitution = 0, deepest = 0, peak_N = 0, residual = 0;
};

// F = K Delta^1.5 with the formula of the manual, whatever reference is chosen.
TEST(Impact, IsHertzsForAStiffnessOfKTimesTheRootOfTheReference) {
  constexpr double K = 3e10;  // N/m^1.5
  for (const double reference : {1e-6, 1e-4, 0.01}) {
    const ContactLaw<double> law({.contact_stiffness = K * std::sqrt(reference),
                                  .contact_exponent = 1.5,
                                  .reference_indentation = reference});
    for (const double indentation : {1e-7, 3e-5, 2e-3}) {
      const double force = K * std::pow(indentation, 1.5);
      EXPECT_NEAR(law.spring_force(indentation) / force, 1, 1e-14);  // of some roundings
    }
  }
}

// With these exponents the motion is not smooth at touch-down and release.
TEST(HeadOnImpact, OnAPowerLawHasTheIndentationForceDurationAndReboundOfTheClosedForm) {
  Law law("indentation, force, duration and rebound of an impact on a power law", 1e-10);
  Law balance("energy of an impact on a power law", 1e-10);
  for (const double n : {1.02, 1.25, 1.5, 2., 2.7}) {
    const HeadOn run(n);
    const double energy = run.p.mass * HeadOn::velocity * HeadOn::velocity / 2;
    const double deepest = run.indentation_of(energy);
    const double duration =
        2 * deepest / HeadOn::velocity / (n + 1) * boost::math::beta(1 / (n + 1), 0.5);
    EXPECT_EQ(run.release.contact, ContactState::free) << n;
    law.expect_left(run.deepest / deepest - 1);
    law.expect_left(run.peak_N / ((n + 1) * energy / deepest) - 1);
    law.expect_left((run.release.time_s - run.touch.time_s) / duration - 1);
    law.expect_left(run.restitution - 1);
    balance.expect_left(run.residual);
  }
}

TEST(ContactLaw, IsRefusedByFormulasThatNeedALinearOne) {
  Parameters hertz;
  hertz.contact_exponent = 1.5;
  hertz.reference_indentation = 1e-4;
  EXPECT_THROW(Whirl{hertz}, std::domain_error);
  EXPECT_THROW(Accident(hertz, Equations::published, 900), std::domain_error);
  EXPECT_THROW(ContactLaw<double>(hertz).required_linear(), std::domain_error);
}

/// An oblique impact on a nearly straight wall: the stiffer the ring, the shorter the contact.
struct Oblique {
  Oblique(double slip, double friction, double stiffness) {
    scenario.parameters.friction = friction;
    scenario.parameters.contact_stiffness = stiffness;
    const double r = scenario.parameters.rotor_radius;
    const EventRecorder run =
        follow_from_state(scenario, {0, 0, 0, normal, 0, slip / r}, 3.5e-3 / normal);
    after = run.first(Event::release);  // of a ring without damping, which has sprung back
    touch = run.first(Event::touch_down);
    slip_after = Ring<double>(scenario.parameters).rim_point(after.motion()).slip_velocity;
    rolled = run.count(Event::rolling_onset) > 0;
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

}  // namespace
}  // namespace rotor
