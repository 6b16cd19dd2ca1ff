/// Partial rub in a ring off centre, once in so many turns. Source: tg-jang03/Vibration_study,
/// which has the case in src/lib/faults/contact.ts, and two vertical amplitudes in
/// src/figures/figures-p7-3.test.ts.
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "figures/record/section.hpp"
#include "figures/runs/scene.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

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

}  // namespace
}  // namespace rotor
