/// Partial rub. In a ring off centre, once in so many turns: tg-jang03/Vibration_study has it in
/// src/lib/faults/contact.ts, and expects vertical amplitudes and backward peaks of the spectrum in
/// src/figures/figures-p7-3.test.ts. In a centred ring without friction: see BouncingFamily.
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "figures/record/section.hpp"
#include "figures/runs/scene.hpp"
#include "verification/support/newton.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/summary_of.hpp"

namespace rotor {
namespace {

using Complex = std::complex<double>;

/// In clearances and reciprocals of the natural frequency, from the position of rest, with a radius
/// so large that the slip keeps its sign. The problem of rub has it at a speed of 2.8.
Scenario partial_rub(double speed, int turns) {
  Scenario scenario =
      read_scene(ROTOR_REFERENCE_DATA "/problems/partial-rub.toml").runs.at(0).scenario;
  scenario.start_speed_Hz = speed / two_pi;
  scenario.until = turns * two_pi / speed;
  return scenario;
}

/// What the last turns of a run show.
class LastTurns : public Observer {
 public:
  /// Of 2000 turns; at 2.6 it settles after 1500.
  LastTurns(double speed, long turns) : LastTurns(partial_rub(speed, 2000), turns) {}

  bool wants_dense_output(const double& from_s, const double& until_s) const override {
    return section_.wants_dense_output(from_s, until_s);
  }
  void on_step(const DenseOutput& motion) override { section_.on_step(motion); }
  void on_instant(const Instant& at) override {
    touch_downs += at.time_s > from_s_ && at.event == Event::touch_down;
  }
  double threshold(Extreme of, const double& from_s, const double& until_s) const override {
    return of == Extreme::displacement && from_s > from_s_
               ? largest
               : Observer::threshold(of, from_s, until_s);
  }
  void on_maximum(const Maximum& maximum) override { largest = maximum.value; }

  const OrderMeans& order(double multiple) const {
    const auto* const found = std::find_if(orders.begin(), orders.end(), [&](const Order& order) {
      return order.multiple == multiple;
    });
    return section.means.at(static_cast<std::size_t>(found - orders.begin()));
  }
  double vertical(double multiple) const { return order(multiple).peak_to_peak_x(); }

  int touch_downs = 0;
  double largest = 0;
  SectionSummary section;

 private:
  LastTurns(const Scenario& scenario, long turns)
      : section_(scenario, turns, [](auto) {}),
        from_s_(scenario.until - static_cast<double>(turns) / scenario.start_speed_Hz) {
    run(scenario, *this);
    section = section_.summary();
  }

  Section section_;
  double from_s_;
};

// The digits are those of two integrators with located events, neither of them this one.
constexpr double as_printed = 0.6e-6;

TEST(PartialRub, TouchesEverySecondTurnAndRepeatsAfter32) {
  const LastTurns found(2.6, 96);
  EXPECT_EQ(found.touch_downs, 48);
  EXPECT_EQ(found.section.repeats_after_turns, 32);
  EXPECT_NEAR(found.vertical(0.5), 1.324204, as_printed);  // 1.32 in the source
  EXPECT_NEAR(found.vertical(1), 0.251036, as_printed);    // 0.25
  EXPECT_NEAR(found.vertical(1.5), 0.041060, as_printed);
  EXPECT_NEAR(found.vertical(2), 0.013504, as_printed);
}

TEST(PartialRub, RepeatsAfterTwoTurns) {
  const LastTurns found(2.8, 6);
  EXPECT_EQ(found.touch_downs, 3);
  EXPECT_EQ(found.section.repeats_after_turns, 2);
  EXPECT_NEAR(found.largest, 1.124000, as_printed);
  EXPECT_NEAR(found.vertical(0.5), 1.610127, as_printed);
  EXPECT_NEAR(found.vertical(1), 0.168665, as_printed);
  EXPECT_NEAR(found.vertical(1.5), 0.083124, as_printed);
  EXPECT_NEAR(found.vertical(2), 0.040837, as_printed);
  EXPECT_NEAR(std::abs(found.order(0.5).forward), 0.398481, as_printed);
  EXPECT_NEAR(std::abs(found.order(0.5).backward), 0.406588, as_printed);
  EXPECT_NEAR(std::abs(found.order(1).forward), 0.132898, as_printed);
  EXPECT_NEAR(std::abs(found.order(1).backward), 0.055646, as_printed);
}

TEST(PartialRub, DiesOutBelowAndAbove) {
  for (const double speed : {2.2, 3.0}) EXPECT_EQ(LastTurns(speed, 96).touch_downs, 0) << speed;
}

/// O along x_a + i y_a at a number of equal intervals.
std::vector<Complex> sampled(Scenario scenario, double from_s, double every_s, int count) {
  std::vector<Complex> z;
  scenario.until = from_s + count * every_s;
  Sampler sampler(from_s, from_s + (count - 0.5) * every_s, every_s,
                  {find_column("x_a_m"), find_column("y_a_m")}, scenario,
                  [&](std::span<const double> row) { z.emplace_back(row[0], row[1]); });
  run(scenario, sampler);
  return z;
}

/// The mean of z exp(-i n angle) over samples n.
template <class Samples>
Complex mean(const Samples& z, double angle) {
  Complex sum = 0;
  double n = 0;
  for (const Complex& at : z) sum += at * std::polar(1., -angle * n++);
  return sum / n;
}

// ---- e = 0.22 c

/// From the position of rest, which is at an angle from e_x; in the source it is a quarter turn
/// back.
Scenario strong_rub(double speed, int turns, double angle = -two_pi / 4) {
  Scenario scenario = partial_rub(speed, turns);
  const Complex rest = std::polar(0.7, angle);
  scenario.parameters.eccentricity = 0.22;
  scenario.parameters.ring_offset_x = -rest.real();
  scenario.parameters.ring_offset_y = -rest.imag();
  scenario.start = Start{rest.real(), rest.imag()};
  return scenario;
}

/// The order of the largest backward component, of the multiples of 1/64 that the source has from
/// 64 points a turn after 300 turns: there over 64 turns, here in the mean square over 16 times as
/// many, as the motion does not repeat.
double backward_peak(const Scenario& scenario) {
  constexpr std::size_t points = 4096, parts = 16;
  const double turn_s = 1 / scenario.start_speed_Hz;
  const auto z = sampled(scenario, 300 * turn_s, turn_s / 64, parts * points);
  std::map<double, double> order_of;
  for (int k = 4; k <= 96; ++k) {
    double power = 0;
    for (std::size_t part = 0; part < parts; ++part)
      power += std::norm(mean(std::span(z).subspan(part * points, points), -two_pi * k / points));
    order_of[power] = -k / 64.;
  }
  return order_of.rbegin()->second;
}

constexpr double two_decimals = 0.5e-2;  // a third of the distance of two orders

TEST(StrongPartialRub, HasItsBackwardPeakWhereTheSourceHasIt) {
  EXPECT_NEAR(backward_peak(strong_rub(2.6, 0)), -0.92, two_decimals);
  EXPECT_NEAR(backward_peak(strong_rub(2.8, 0)), -0.84, two_decimals);
  Scenario bouncing = strong_rub(3, 0);
  bouncing.start = Start{0, 0.9, 2.4, 0.5};
  EXPECT_NEAR(backward_peak(bouncing), -0.78, two_decimals);
}

TEST(StrongPartialRub, EndsInThreeWaysAtThreeTimesTheNaturalFrequency) {
  const Scenario as_there = strong_rub(3, 364);
  EventRecorder newtons;
  EXPECT_TRUE(run_by_newton(as_there, {1e-11, 30, 10'000'000}, newtons));
  for (const EventRecorder& found : {recorded(as_there), newtons}) {
    EXPECT_EQ(found.count(Event::touch_down), 12);
    EXPECT_FALSE(found.last().touches());
  }
  EXPECT_EQ(summary_of(as_there).outcome, Outcome::freed);
  int rolling = 0;
  for (int n = 0; n < 24; ++n)
    rolling += summary_of(strong_rub(3, 364, n * two_pi / 24)).outcome == Outcome::rolling;
  EXPECT_GE(rolling, 18);  // 23; after some fifty impacts rounding decides
}

// ---- without friction

/// In a centred ring without friction the equations in axes that turn with the rotor do not contain
/// the time. A motion that repeats there with a frequency f has the frequencies W - n f in the
/// stator's axes. One is that of forward whirl, w_f = W - q f, one of backward, -w_b = W - p f, so
/// that p (W - w_f) = q (W + w_b); where the ring raises both above w_n, W > (p + q)/(p - q) w_n.
/// Shaw, Champneys and Friswell (Proc. R. Soc. A 472, 2016) trace bouncing to such resonances.
struct BouncingFamily {
  int p, q;
  std::size_t touch_downs;  // in 1/f
  double speed;             // at which the start leads to it
  Start start;
  double forward, backward;  // w_f and w_b there
  double lasts_to;           // when the speed is lowered from there in steps of 0.01

  double least_speed() const { return static_cast<double>(p + q) / (p - q); }
};
const auto families =
    std::to_array<BouncingFamily>({{3, 1, 2, 3.4, {1.5, 0, 0, 3}, 1.614499, 1.956502, 2.53},
                                   {2, 1, 1, 5, {1.5, 0, 0, 3}, 1.591040, 1.817919, 3.59},
                                   {3, 2, 1, 8, {1.2, 0, 0, 2}, 1.553080, 1.670380, 6.53}});

Scenario bouncing(double speed, int turns, const Start& start) {
  Scenario scenario = partial_rub(speed, turns);
  Parameters& p = scenario.parameters;
  p.support_damping = 0.02;
  p.contact_stiffness = 10;
  p.friction = 0;
  p.ring_offset_x = 0;
  scenario.start = start;
  return scenario;
}

/// The end of a run of whole turns, as a start.
Start end_of(const EventRecorder& events) {
  const Newton x = in_stator_axes(events.last().state);
  return {x[0], x[1], x[3], x[4]};
}

EventRecorder settled(const BouncingFamily& family) {
  return recorded(bouncing(family.speed, 2000, family.start));
}

/// The time after which the last touch-downs repeat in the rotor's axes, s.
double period_of(const EventRecorder& events, std::size_t touch_downs) {
  const auto all = events.events(Event::touch_down);
  for (std::size_t n = all.size() - 20; n < all.size(); ++n) {
    const auto &at = all[n].state, &before = all[n - touch_downs].state;
    EXPECT_LT(std::hypot(at[0] - before[0], at[1] - before[1]), 1e-6);
  }
  return all.back().time_s - all[all.size() - 1 - touch_downs].time_s;
}

/// The two n of the largest components with the frequencies W - n f.
std::set<int> largest_components(const Scenario& scenario, double period_s) {
  const auto z = sampled(scenario, 0, period_s / 256, 256);
  std::map<double, int> by_size;
  for (int n = 1; n <= 8; ++n)
    by_size[std::abs(mean(z, two_pi * (scenario.start_speed_Hz * period_s - n) / 256))] = n;
  const auto largest = by_size.rbegin();
  return {largest->second, std::next(largest)->second};
}

// The transient is a decayed 1e-8 of the clearance; frequencies are printed with six decimals.
TEST(Bouncing, RepeatsInTheRotorsAxes) {
  for (const BouncingFamily& family : families) {
    const Scenario scenario = bouncing(family.speed, 100, end_of(settled(family)));
    const double period_s = period_of(recorded(scenario), family.touch_downs);
    EventRecorder newtons;
    EXPECT_TRUE(run_by_newton(scenario, {1e-12, 30, 10'000'000}, newtons));
    EXPECT_NEAR(period_of(newtons, family.touch_downs), period_s, 1e-10);  // differs by 3e-12

    const double f = two_pi / period_s;
    EXPECT_EQ(largest_components(scenario, period_s), std::set({family.p, family.q}));
    EXPECT_NEAR(family.speed - family.q * f, family.forward, as_printed);
    EXPECT_NEAR(family.p * f - family.speed, family.backward, as_printed);
  }
}

TEST(Bouncing, EndsAboveItsLeastSpeed) {
  for (const BouncingFamily& family : families) {
    const double touch_downs_a_turn =
        2. * static_cast<double>(family.touch_downs) / (family.p + family.q);
    EventRecorder found = settled(family);
    double speed = family.speed, share = 1;  // of the touch-downs if w_f were w_b
    while (std::abs(share - 1) < 0.1) {
      speed -= 0.01;
      found = recorded(bouncing(speed, 300, end_of(found)));
      share = static_cast<double>(found.count(Event::touch_down)) / (300 * touch_downs_a_turn);
    }
    EXPECT_NEAR(speed + 0.01, family.lasts_to, 0.015);  // a step and a half
    EXPECT_GT(speed, family.least_speed());
  }
}

}  // namespace
}  // namespace rotor
