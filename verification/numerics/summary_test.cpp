/// What is gathered along a run: the quantities of its summary.
#include "model/simulation/summary.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <numbers>

#include "figures/scenes/audience.hpp"
#include "model/simulation/simulation.hpp"
#include "model/simulation/start.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

// Koenig's theorem, from the state alone: O moves with the rotating axes, C turns about O.
TEST(Summary, EndsWithTheEnergyOfTranslationAndRotation) {
  Scenario scenario{.until = 29.2};
  SummaryObserver summary(scenario);
  Simulation simulation(scenario);
  simulation.pass_mass_loss(summary);
  simulation.finish(summary);
  const Instant last = simulation.instant();
  const auto& [q1, q2, q3, v1, v2, w] = last.state;
  const double u = v1 - w * q2, v = v2 + w * q1 + w * last.body.eccentricity;
  const double energy = last.body.mass * (u * u + v * v) / 2 + last.body.inertia * w * w / 2;
  EXPECT_GT(last.body.mass * (u * u + v * v) / 2, energy / 20);  // which is to be seen
  EXPECT_NEAR(summary.summary().final_kinetic_energy_J, energy, 1e-12 * energy);  // rounding
}

// Nothing holds it: the mass centre stays where it is, and O circles about it.
TEST(Summary, OfARotorWithoutSupportsHasItsWholeReach) {
  Scenario scenario{.until = 1.5};
  Parameters& p = scenario.parameters;
  p.support_stiffness = p.support_damping = p.gravity = 0;
  p.eccentricity = 2e-3;
  p.separates = false;
  p.stator_radius = p.rotor_radius + 5e-3;
  EXPECT_NEAR(summary_until(1.5, scenario).max_displacement_before_loss_m, 2 * p.eccentricity,
              1e-3 * p.eccentricity);
  p.stator_radius = p.rotor_radius + 3.999e-3;
  EXPECT_GT(summary_until(1.5, scenario).collisions, 0);
}

// What the supports carry is largest where the velocity is as well, far from the displacement's
// maxima if they damp strongly; in flight as in contact.
TEST(Summary, HasTheLargestBearingForceWhereverItOccurs) {
  struct Samples : Observer {
    explicit Samples(const Scenario& scenario)
        : supports(scenario.parameters, scenario.equations) {}
    bool wants_dense_output(const double& /*from_s*/, const double& until_s) const override {
      return until_s > 29.09;
    }
    void on_step(const DenseOutput& step) override {
      for (int n = 0; n <= 64; ++n) {
        const Instant at = step.at(step.from_s + (step.until_s - step.from_s) * n / 64);
        const Motion<double> m = at.motion();
        const Vector<double> force =
            supports.stiffness * m.displacement + supports.damping * m.velocity;
        (at.touches() ? in_contact : in_flight) =
            std::max(at.touches() ? in_contact : in_flight, force.norm());
      }
    }
    Supports<double> supports;
    double in_contact = 0, in_flight = 0;
  };
  int clear = 0;
  for (const double damping : {25., 300., 3000.}) {
    for (const double stator_radius : {0.062, 0.09}) {
      Scenario scenario{.start_speed_Hz = 100};
      scenario.parameters.support_damping = damping;
      scenario.parameters.stator_radius = stator_radius;
      Samples samples(scenario);
      SummaryObserver summary(scenario);
      Audience audience;
      audience.add(summary);
      audience.add(samples);
      run(scenario, audience);
      const double sampled = std::max(samples.in_contact, samples.in_flight);
      clear += samples.in_contact == 0;
      EXPECT_GE(summary.summary().peak_bearing_force_N, sampled * (1 - 1e-9)) << damping;
      EXPECT_LE(summary.summary().peak_bearing_force_N, sampled * (1 + 1e-3)) << damping;
    }
  }
  EXPECT_EQ(clear, 4);
}

TEST(Summary, CountsContactsBeforeAndAfterTheMassLossApart) {
  Scenario scenario;
  scenario.parameters.support_stiffness = 1.2e5;  // hits the ring on its way to the resonance
  scenario.parameters.separation_time = 10;
  scenario.until = 10.25;
  EventRecorder recorder;
  run(scenario, recorder);
  const Summary summary = summary_until(10.25, scenario);
  long before = 0, after = 0;
  for (const Instant& at : recorder.events())
    if (at.event == Event::touch_down) ++(at.separated ? after : before);
  ASSERT_GT(before, 0);
  EXPECT_EQ(summary.collisions_before_loss, before);
  EXPECT_EQ(summary.collisions, before + after);
  EXPECT_GT(summary.max_displacement_before_loss_m, 3e-3);
  EXPECT_GT(summary.peak_normal_force_before_loss_N.value_or(0), 0);
}

// A damper that is strong enough presses hardest as the rim arrives: F_n jumps to -d_t v_n,
// although the indentation there is but rounding, and of either sign.
TEST(Summary, HasTheForceOfTheImpactWhereItIsTheLargest) {
  int gaps = 0;
  for (int n = 0; n < 20; ++n) {
    Scenario scenario{.start_speed_Hz = 140, .until = 0.01};
    Parameters& p = scenario.parameters;
    p.separation_time = 0;
    p.rotor_radius = 0.05;
    p.stator_radius = 0.0525 + 1e-5 * n;
    p.contact_damping = 1e6;
    EventRecorder recorder;
    run(scenario, recorder);
    const Instant& at = recorder.first(Event::touch_down);
    const Motion<double> m = at.motion();
    const double rho = m.displacement.norm();
    gaps += rho <= p.stator_radius - p.rotor_radius;
    const double impact = p.contact_damping * m.displacement.dot(m.velocity) / rho;
    SummaryObserver observer(scenario);
    run(scenario, observer);
    const Summary& summary = observer.summary();
    EXPECT_NEAR(summary.peak_normal_force_N.value_or(0) / impact, 1, 1e-9);
    EXPECT_EQ(summary.peak_time_s, at.time_s);
  }
  EXPECT_GT(gaps, 0);
}

TEST(Summary, AddsUpTheTimeInContact) {
  const Scenario scenario;
  EventRecorder recorder;
  const RunEnd end = run(scenario, recorder);
  double time_s = 0, since_s = -1;
  const auto touches = [](const Instant& at) {
    return at.contact == ContactState::sliding || at.contact == ContactState::rolling;
  };
  for (const Instant& at : recorder.events()) {
    if (since_s >= 0) time_s += at.time_s - since_s;
    since_s = touches(at) ? at.time_s : -1;
  }
  if (since_s >= 0) time_s += end.last.time_s - since_s;
  EXPECT_NEAR(summary_until(29.35, scenario).contact_time_s, time_s, 1e-12);
}

TEST(Summary, SaysWhenRollingEndsAndHowFastTheRotorWhirls) {
  const Summary rolling = summary_until(29.35, {});
  EXPECT_FALSE(rolling.rolling_until_s);
  EXPECT_EQ(rolling.whirl_from_s, rolling.rolling_onset_s);  // whatever the steps are
  // The time integral of the whirl's rate, and what it must be by another method.
  struct Whirl : Observer {
    void on_instant(const Instant& at) override { rolls = at.contact == ContactState::rolling; }
    bool wants_dense_output(const double&, const double&) const override { return rolls; }
    void on_step(const DenseOutput& step) override {
      if (!rolls || step.from_s < from_s) return;
      using Rule = boost::math::quadrature::gauss<double, 15>;
      turns += Rule::integrate(
                   [&](double time_s) {
                     const Motion<double> m = step.at(time_s).motion();
                     return cross(m.displacement, m.velocity) / m.displacement.squaredNorm();
                   },
                   step.from_s, step.until_s) /
               (2 * std::numbers::pi);
      until_s = step.until_s;
    }
    double from_s = 0, until_s = 0, turns = 0;
    bool rolls = false;
  } whirl;
  whirl.from_s = rolling.whirl_from_s.value_or(0);
  run(Scenario{}, whirl);
  EXPECT_LT(whirl.turns, -100);
  EXPECT_EQ(rolling.whirl_until_s, whirl.until_s);
  EXPECT_NEAR(*rolling.whirl_frequency_Hz * (whirl.until_s - whirl.from_s) / whirl.turns, 1, 1e-9);
  Scenario published;
  published.method = Method::rk4;
  EXPECT_NEAR(*summary_until(29.35, published).whirl_frequency_Hz / *rolling.whirl_frequency_Hz, 1,
              0.01);
  Scenario sliding;
  sliding.parameters.friction = 0.08;
  EXPECT_FALSE(summary_until(29.35, sliding).whirl_frequency_Hz);
  const Summary later = summary_until(60, {});
  EXPECT_NEAR(later.rolling_until_s.value_or(0), 30.49, 0.005);
  EXPECT_EQ(later.outcome, Outcome::rolling);
}

// If it comes to roll again, it is the end of that rolling, and none yet.
TEST(Summary, HasTheEndOfTheLastRollingAlone) {
  const Scenario scenario;
  SummaryObserver observer(scenario);
  const auto show = [&](double time_s, ContactState contact) {
    observer.on_instant({.time_s = time_s,
                         .state = {3.01e-3, 0, 0, 0, 0, 300},
                         .body = Body<double>::of(scenario.parameters),
                         .contact = contact});
    return observer.summary().rolling_until_s;
  };
  EXPECT_EQ(show(0.1, ContactState::rolling), std::nullopt);
  EXPECT_EQ(show(0.2, ContactState::sliding), 0.2);
  EXPECT_EQ(show(0.3, ContactState::sliding), 0.2);
  EXPECT_EQ(show(0.4, ContactState::rolling), std::nullopt);
  EXPECT_EQ(show(0.5, ContactState::free), 0.5);
}

// Rolling may begin with a step that ends where it has begun.
TEST(Summary, HasNoFrequencyOfAWhirlOverNoTime) {
  const Scenario scenario;
  SummaryObserver observer(scenario);
  observer.on_instant({.time_s = 0.1,
                       .state = {3.01e-3, 0, 0, 0, 0, 300},
                       .body = Body<double>::of(scenario.parameters),
                       .contact = ContactState::rolling});
  observer.goes_on({0.1, 300, 0});
  observer.goes_on({0.1, 300, 0});
  EXPECT_FALSE(observer.summary().whirl_frequency_Hz.has_value());
  observer.goes_on({0.2, 300, -2 * std::numbers::pi});
  EXPECT_NEAR(observer.summary().whirl_frequency_Hz.value_or(0), -10, 1e-12);
}

}  // namespace
}  // namespace rotor
