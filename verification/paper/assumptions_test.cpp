/// The effect of the paper's ambiguous choices.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "figures/data/read_csv.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

/// The result of a scenario's run that starts with O_a xy turned by an angle.
Summary summary_from(const Scenario& scenario, double angle = 0) {
  SummaryObserver observer(scenario);
  Instant first = at_rest(scenario.parameters);
  first.state[2] = angle;
  run(scenario, first, observer);
  return observer.summary();
}

/// Each ambiguous choice of the paper: a quantity with the choice taken and with the other one.
const std::map<std::string, std::function<std::array<double, 2>()>>& assumptions() {
  static const auto printed = [](const Parameters& p, double until = Scenario().until) {
    return Scenario{.parameters = p, .equations = Equations::published, .until = until};
  };
  static const auto peak = [](const Scenario& s, double angle = 0) {
    return *summary_from(s, angle).peak_normal_force_N / 1e3;
  };
  static const auto motor = [](double mass_loss_time) {
    const Scenario on = printed({.mass_loss_time = mass_loss_time}, mass_loss_time + 0.15);
    Scenario off = on;
    off.parameters.motor_off_Hz = *summary_from(on).speed_at_mass_loss_Hz;
    return std::array{peak(on), peak(off)};
  };
  // Both as printed, and with the mass lost at another time and the ring a little wider.
  static const auto touch_downs = [](double mass_loss_time, double friction, double wider) {
    const Scenario taken = printed({.friction = friction});
    Scenario other = taken;
    other.parameters.mass_loss_time = mass_loss_time;
    other.parameters.stator_radius += wider;
    other.until = mass_loss_time + 0.25;
    return std::array{static_cast<double>(summary_from(taken).touch_downs),
                      static_cast<double>(summary_from(other).touch_downs)};
  };
  static const std::map<std::string, std::function<std::array<double, 2>()>> all = {
      {"motor-at-19.1s", [] { return motor(19.1); }},
      {"motor-at-14.15s", [] { return motor(14.15); }},
      {"initial-angle",
       [] {
         return std::array{peak(printed({})), peak(printed({}), two_pi / 4)};
       }},
      {"rounding-of-t1-at-low-friction", [] { return touch_downs(29.05, 0.08, 0); }},
      {"one-nanometre-at-low-friction", [] { return touch_downs(29.1, 0.08, 1e-9); }},
      {"rounding-of-low-friction",
       [] {
         return std::array{peak(printed({.friction = 0.08})), peak(printed({.friction = 0.0849}))};
       }},
      {"rounding-of-19.1s",
       [] {
         return std::array{peak(printed({.mass_loss_time = 19.1}, 19.3)),
                           peak(printed({.mass_loss_time = 19.05}, 19.3))};
       }},
      {"renewed-contact",
       [] {
         // None, so that a ring which had to be clear first would change nothing.
         double renewed = 0;
         for (const auto& [friction, mass_loss_s] :
              {std::pair(0.3, 29.1), {0.2, 29.1}, {0.08, 29.1}, {0.3, 19.1}, {0.3, 14.15}}) {
           const EventRecorder events = recorded(
               printed({.friction = friction, .mass_loss_time = mass_loss_s}, mass_loss_s + 0.25));
           renewed += static_cast<double>(events.count(Event::renewed_contact));
         }
         return std::array{renewed, 0.};
       }},
      {"speed-at-2.2s",
       [] {
         Scenario taken = printed({.mass_loss_time = 2.2}, 4), other = taken;
         other.parameters.mass_loss_time = 2.23;
         return std::array{1e3 * *summary_from(taken).peak_displacement_m,
                           1e3 * *summary_from(other).peak_displacement_m};
       }},
      {"equilibrium-of-the-lighter-rotor",
       [] {
         const Parameters p;
         return std::array{0.,
                           1e6 * MassLoss<double>(p).lost_mass * p.gravity / p.support_stiffness};
       }},
  };
  return all;
}

TEST(Assumptions, AreAllInTheRegisterWithTheSpreadThatTheyCause) {
  const std::vector<CsvRow> rows = read_csv(ROTOR_REFERENCE_DATA "/assumptions.csv");
  for (const CsvRow& row : rows) {
    const std::string& id = row["id"];
    ASSERT_TRUE(assumptions().contains(id)) << id;
    const auto [taken, other] = assumptions().at(id)();
    // The register gives one decimal of kN and um, three of mm: half the last digit.
    const double half_digit = row["unit"] == "mm" ? 0.0005 : 0.05;
    EXPECT_NEAR(taken, static_cast<double>(row.number("value_taken")), half_digit * 1.001) << id;
    EXPECT_NEAR(other, static_cast<double>(row.number("value_other")), half_digit * 1.001) << id;
  }
  EXPECT_EQ(rows.size(), assumptions().size());
}

}  // namespace
}  // namespace rotor
