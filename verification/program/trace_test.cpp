/// Traces at equal distances, and the columns that say where power and energy go.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <utility>

#include "figures/scenes/columns.hpp"
#include "figures/scenes/recorder.hpp"
#include "model/simulation/energy.hpp"
#include "model/simulation/simulation.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/observers.hpp"

namespace rotor {
namespace {

class Trace : public CommandLine {
 protected:
  /// The numbers of a trace, row by row.
  std::vector<std::vector<double>> numbers(const std::string& arguments) const {
    const Outcome outcome = rotor("run --trace t.csv " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    std::vector<std::vector<double>> all;
    auto rows = rows_of("t.csv");
    rows.erase(rows.begin());
    for (const std::string& row : rows) {
      std::istringstream stream(row.substr(row.find(',') + 1));
      all.emplace_back();
      for (std::string field; std::getline(stream, field, ',');)
        all.back().push_back(std::stod(field));
    }
    return all;
  }
};

// With a trace or without: whose run-up others could share has its events as well.
TEST_F(Trace, OfEventsBeginsBeforeTheMassLoss) {
  const std::string run =
      "run --start-speed-hz 100 --motor-off-hz 101 --separation-time 3 --until 3.01 --events ";
  ASSERT_EQ(rotor(run + "alone.csv").status, 0);
  ASSERT_EQ(rotor(run + "e.csv --trace t.csv").status, 0);
  EXPECT_TRUE(rows_of("alone.csv").at(1).starts_with("motor_off,"));
  EXPECT_EQ(rows_of("alone.csv"), rows_of("e.csv"));
}

TEST_F(Trace, HasARowAtEqualDistancesFromTheFirstToTheLastInstant) {
  const std::string window = "--from 29.1 --until 29.12 --columns time_s,q1_m ";
  const auto rows = numbers(window + "--rows 401");
  ASSERT_EQ(rows.size(), 401U);
  for (std::size_t n = 0; n < rows.size(); ++n)
    EXPECT_NEAR(rows[n][0], 29.1 + 0.02 * static_cast<double>(n) / 400, 1e-14);
  const auto every = numbers(window + "--every 5e-5");
  ASSERT_EQ(every.size(), 401U);
  EXPECT_NEAR(every[200][1], rows[200][1], 1e-15);
  EXPECT_EQ(numbers(window + "--every 6e-5").size(), 334U);  // whose last one is not at the end
}

// Without equal distances rows stand where lines need them: 20 ms of contacts take 643.
TEST_F(Trace, HasNoMoreRowsThanItsCurvesNeed) {
  const auto rows = numbers("--from 29.1 --until 29.12 --columns time_s,rho_m");
  EXPECT_GT(rows.size(), 100U);
  EXPECT_LT(rows.size(), 1300U);
}

// Of the largest force, which is negative in compression, only what is larger is still of interest.
TEST_F(Trace, AsksForMaximaAboveThoseThatItHas) {
  const Scenario scenario;
  Recorder recorder({.from_s = 0, .length_s = 1}, {find_column("normal_force_N")}, scenario, 1e-4,
                    [](auto) {});
  const auto threshold = [&] { return recorder.threshold(Extreme::normal_force, 0.1, 0.2); };
  const auto pressed = [&](double indentation) {
    return Instant{.time_s = 0.1,
                   .state = {3e-3 + indentation, 0, 0, 0, 0, 300},
                   .body = Body<double>::of(scenario.parameters),
                   .contact = ContactState::rolling};
  };
  EXPECT_EQ(threshold(), 0);
  recorder.on_instant(pressed(1e-5));
  EXPECT_NEAR(threshold(), 8000, 1e-6);
  recorder.on_maximum({Extreme::normal_force, 1e4, pressed(1.2e-5)});
  EXPECT_NEAR(threshold(), 9600, 1e-6);
}

// The largest force is shown to the digit wherever in its step the window begins or ends.
TEST_F(Trace, ShowsAMaximumCloseToTheEndsOfItsWindow) {
  const Scenario scenario{.until = 29.11};
  const auto& force = find_column("normal_force_N");
  const auto record = [&](const Window& window) {
    std::pair<double, double> largest{0, 0};  // F_n and its time
    Recorder recorder(window, {find_column("time_s"), force}, scenario, 1e-4, [&](auto row) {
      if (row[1] < largest.first) largest = {row[1], row[0]};
    });
    run(scenario, recorder);
    return largest;
  };
  const auto largest = record({.from_s = 29.1});
  ASSERT_LT(largest.first, -1e4);
  for (const double apart_s : {1e-7, 1e-6, 3e-6}) {
    EXPECT_EQ(record({.from_s = largest.second - apart_s}), largest) << apart_s;
    EXPECT_EQ(record({.from_s = 29.1, .length_s = largest.second + apart_s - 29.1}), largest)
        << apart_s;
  }
}

// Asked directly: a run that ends at the time of a row.
TEST_F(Trace, ShowsTheMotionAtTheTimesThatItNames) {
  const auto rows = numbers(
      "--from 29.1 --until 29.13 --rows 61 --columns "
      "time_s,q1_m,q2_m,q3_rate_rad_per_s,normal_force_N");
  for (const std::size_t n : {7U, 23U, 41U, 58U}) {
    Scenario scenario{.until = rows[n][0]};
    Observer null_observer;
    const Instant at = run(scenario, null_observer).last;
    const Ring<double> ring(scenario.parameters);
    EXPECT_NEAR(rows[n][1], at.state[0], 1e-10) << n;
    EXPECT_NEAR(rows[n][2], at.state[1], 1e-10) << n;
    EXPECT_NEAR(rows[n][3] / at.state[5], 1, 1e-9) << n;
    const double force = at.contact == ContactState::free || at.contact == ContactState::indented
                             ? 0
                             : ring.normal_force(ring.rim_point(at.motion()));
    EXPECT_NEAR(rows[n][4], force, 1e-3 + 1e-6 * std::abs(force)) << n;
  }
}

// The powers add up to what EnergyObserver says, by the trapezoidal rule over fine rows.
TEST_F(Trace, HasThePowersWhoseIntegralsAreTheWorksByCause) {
  const double from = 29.1, until = 29.127;  // before the onset of rolling
  const auto rows = numbers(
      "--from 29.1 --until 29.127 --every 2e-7 --columns "
      "time_s,motor_power_W,support_damping_power_W,friction_power_W,contact_damping_power_W,"
      "support_energy_J,contact_energy_J");
  std::array<double, 4> work{};
  for (std::size_t n = 1; n < rows.size(); ++n)
    for (std::size_t i = 0; i < work.size(); ++i)
      work[i] += (rows[n][i + 1] + rows[n - 1][i + 1]) / 2 * (until - from) /
                 static_cast<double>(rows.size() - 1);
  const Scenario scenario{.until = until};
  EnergyObserver energy(scenario);
  run(scenario, energy);
  const EnergyBalance& balance = energy.balance();
  EXPECT_EQ(work[0], balance.motor);
  // The powers jump at contacts, by up to 3 MW within a row.
  EXPECT_NEAR(work[1], balance.support_damping, 1e-3);
  EXPECT_NEAR(work[2] / balance.friction, 1, 1e-3);
  EXPECT_NEAR(work[3] / balance.contact_damping, 1, 2e-2);
  EXPECT_NEAR(rows.back()[5], balance.support_springs, 1e-9);
  EXPECT_NEAR(rows.back()[6], balance.contact_spring, 1e-6);
}

// Written out anew, from the state alone.
TEST_F(Trace, HasBearingForceWhirlAndDirectionOfTheContact) {
  const auto rows = numbers(
      "--from 29.1 --until 29.2 --rows 50 --columns "
      "time_s,q1_m,q2_m,q3_rad,q1_rate_m_per_s,q2_rate_m_per_s,q3_rate_rad_per_s,bearing_force_N,"
      "whirl_frequency_Hz,contact_angle_rad");
  const double k = 20e3, d = 25, pi = std::acos(-1.);
  for (const auto& row : rows) {
    const double q1 = row[1], q2 = row[2], w = row[6];
    const double v1 = row[4] - w * q2, v2 = row[5] + w * q1;  // relative to the stator
    EXPECT_NEAR(row[7], std::hypot(k * q1 + d * v1, k * q2 + d * v2), 1e-9 * row[7]);
    EXPECT_NEAR(row[8], (q1 * v2 - q2 * v1) / (q1 * q1 + q2 * q2) / (2 * pi),
                1e-9 * std::abs(row[8]));
    const double angle = std::remainder(std::atan2(q2, q1) + row[3] - row[9], 2 * pi);
    EXPECT_NEAR(angle, 0, 1e-9);
  }
}

// From rest, too, where some columns have no value yet.
TEST_F(Trace, HasNoRowTwice) {
  ASSERT_EQ(rotor("run --trace t.csv --no-separation --until 0.01").status, 0);
  const auto rows = rows_of("t.csv");
  ASSERT_GT(rows.size(), 5U);
  for (std::size_t n = 1; n < rows.size(); ++n) EXPECT_NE(rows[n], rows[n - 1]) << n;
}

// Which sums of equal distances may miss by rounding.
TEST_F(Trace, EndsWithTheRun) {
  const auto rows = numbers("--until 29.35 --columns time_s --rows 100001");
  ASSERT_EQ(rows.size(), 100001U);
  EXPECT_EQ(rows.back()[0], 29.35);
}

}  // namespace
}  // namespace rotor
