/// Every column and event against independent formulas, in every contact state, and the rows of
/// traces against runs that end there.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <tuple>
#include <utility>

#include "figures/data/read_csv.hpp"
#include "figures/input/names.hpp"
#include "figures/record/columns.hpp"
#include "figures/record/recorder.hpp"
#include "figures/results/event_log.hpp"
#include "model/run/simulation.hpp"
#include "model/scenario/observer.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/command_line.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/short_run.hpp"

namespace rotor {
namespace {

/// Instants of a run, events and a few inside every step.
struct Instants : Observer {
  void on_instant(const Instant& at) override { all.push_back(at); }
  bool wants_dense_output(const double&, const double&) const override { return true; }
  void on_step(const DenseOutput& step) override {
    for (const double part : {0.3, 0.8})
      all.push_back(step.at(step.from_s + part * (step.until_s - step.from_s)));
  }
  std::vector<Instant> all;
};

/// No two numbers of this rotor are equal, and none is the paper's. It strikes the ring at once,
/// slides and rolls.
Scenario of_its_own(Equations equations, Method method) {
  const bool is_centred = equations.gravity_moment == GravityMoment::whole;
  return {.parameters = {.mass = 6,
                         .inertia = 0.011,
                         .eccentricity = 0.4e-3,
                         .support_stiffness = 3e4,
                         .support_damping = 40,
                         .gravity = 9.5,
                         .torque = 7,
                         .motor_off_Hz = 1000,
                         .contact_stiffness = 7e8,
                         .contact_damping = 2e4,
                         .friction = 0.25,
                         .rotor_radius = 0.05,
                         .stator_radius = 0.0525,
                         .unbalance_factor = 2.5,
                         .ring_offset_x = is_centred ? 0 : 0.3e-3,
                         .ring_offset_y = is_centred ? 0 : -0.1e-3},
          .equations = equations,
          .method = method,
          .until = 0.1,
          .tolerance = 1e-8};
}

Instant towards_the_ring(const Scenario& scenario, bool motor_on) {
  Instant start = at_rest(scenario.parameters);
  start.state = {1e-3, 2e-3, 0.7, 1, 5, 900};
  start.motor_on = motor_on;
  return start;
}

/// Where sliding begins or ends, the sign of the slip is only rounding.
bool slip_is_rounding(const Instant& at, const Scenario& scenario) {
  const double slip = column_by_formula("slip_velocity_m_per_s", at, scenario);
  return at.contact == ContactState::sliding && std::abs(slip) < 1e-12;
}

// Rounding is relative to the largest terms: F_n is the difference of displacement and clearance,
// times k_t; a holding friction is a difference of loads of its size.
void compare(const Column& column, const std::vector<Instant>& instants, const Scenario& scenario) {
  const ColumnContext context(scenario);
  double largest = 0;
  for (const Instant& at : instants)
    largest = std::max(largest, std::abs(column_by_formula(column.name, at, scenario)));
  for (const Instant& at : instants) {
    InstantView view(at, context);
    double expected = column_by_formula(column.name, at, scenario);
    if (column.name == "friction_force_N" && slip_is_rounding(at, scenario))
      expected = -at.slip_sign * std::abs(expected);
    ASSERT_NEAR(column.value(view), expected, 1e-10 * std::abs(expected) + 1e-12 * largest)
        << column.name << " at " << at.time_s << " s, state " << static_cast<int>(at.contact);
  }
}

TEST(Column, IsWhatItsFormulaSays) {
  for (const Equations& equations : {Equations::published, Equations::corrected})
    for (const Method method : {Method::event, Method::rk4})
      for (const bool motor_on : {false, true}) {
        Scenario scenario = of_its_own(equations, method);
        Instants instants;
        for (const double mass_loss_s : {0.0001, 0.099}) {  // before all contacts, after most
          scenario.parameters.mass_loss_time = mass_loss_s;
          run(scenario, towards_the_ring(scenario, motor_on), instants);
        }
        std::set<std::tuple<ContactState, bool>> seen;
        for (const Instant& at : instants.all) seen.insert({at.contact, at.mass_lost});
        EXPECT_EQ(seen.size(), 8U);  // free, indented, sliding, rolling
        for (const Column* column : all_columns()) compare(*column, instants.all, scenario);
      }
}

// The rows of `--events`.
TEST(EventLog, HasEachEventWithTheForceOnTheRotorAndItsSlip) {
  const Scenario scenario = short_run(0.03);
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  EventLog log(scenario, [&](std::string_view event, auto row) {
    names.emplace_back(event);
    rows.emplace_back(row.begin(), row.end());
  });
  EventRecorder events;
  ObserverGroup both{&log, &events};
  run(scenario, both);
  ASSERT_EQ(rows.size(), events.events().size());
  int pressed = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const Instant& at = events.events()[n];
    EXPECT_EQ(names[n], name_of(at.event));
    for (std::size_t i = 0; i < EventLog::columns().size(); ++i) {
      const std::string_view column = EventLog::columns()[i]->name;
      const double expected = column_by_formula(column, at, scenario);
      const double rounding = column.starts_with("slip") ? 1e-13 : 0;  // of the rim's 60 m/s
      EXPECT_NEAR(rows[n][i], expected, 1e-9 * std::abs(expected) + rounding)
          << column << ' ' << names[n];
      pressed += column == "normal_force_N" && expected < -1 ? 1 : 0;
    }
  }
  EXPECT_GT(pressed, 3);
}

class Trace : public CommandLine {
 protected:
  /// The numbers of a trace, row by row.
  std::vector<std::vector<double>> numbers(const std::string& arguments) const {
    const Outcome outcome = rotor("run --trace t.csv " + arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    const std::string& of = arguments.substr(arguments.find("--columns ") + 10);
    std::vector<std::vector<double>> all;
    for (const CsvRow& row : read_csv(folder_ / "t.csv")) {
      all.emplace_back();
      std::istringstream names(of.substr(0, of.find(' ')));
      for (std::string name; std::getline(names, name, ',');)
        all.back().push_back(static_cast<double>(row.number(name)));
    }
    return all;
  }
};

// The largest force is exact wherever in its step the window starts or ends.
TEST_F(Trace, ShowsAMaximumCloseToTheEndsOfItsWindow) {
  const Scenario scenario{.equations = Equations::published, .until = 29.11};
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

// Rows at equal intervals against runs that end at the time of a row.
TEST_F(Trace, ShowsTheMotionAtTheTimesThatItNames) {
  const std::string window = "--from 29.1 --until 29.13 --columns ",
                    columns = "time_s,q1_m,q2_m,q3_rate_rad_per_s,normal_force_N";
  const auto rows = numbers(window + columns + " --every 5e-4");
  EXPECT_EQ(numbers(window + "time_s --every 6.1e-4").size(), 50U);  // the last not at the end
  ASSERT_EQ(rows.size(), 61U);
  for (std::size_t n = 0; n < rows.size(); ++n)
    EXPECT_NEAR(rows[n][0], 29.1 + 5e-4 * static_cast<double>(n), 1e-14);
  for (const std::size_t n : {7U, 41U, 60U}) {
    const Scenario scenario{.until = rows[n][0]};
    const Instant at = run(scenario, nobody).last;
    EXPECT_NEAR(rows[n][1], at.state[0], 1e-10) << n;
    EXPECT_NEAR(rows[n][2], at.state[1], 1e-10) << n;
    EXPECT_NEAR(rows[n][3] / at.state[5], 1, 1e-9) << n;
    const double force = column_by_formula("normal_force_N", at, scenario);
    EXPECT_NEAR(rows[n][4], force, 1e-3 + 1e-6 * std::abs(force)) << n;
  }
}

// The rows are the same, below the provenance and the names, the names alone, or nothing.
TEST_F(Trace, HasTheHeaderThatIsAskedFor) {
  std::map<std::string, std::string> rows_below;
  for (const std::string header : {"none", "names", "full"}) {
    ASSERT_EQ(rotor("run --start-speed-Hz 150 --until 0.02 --trace t.csv --columns time_s,rho_m "
                    "--events e.csv --header " +
                    header)
                  .status,
              0);
    for (const auto& [file, names] :
         {std::pair("t.csv", "run,time_s,rho_m\n"), {"e.csv", "run,event,time_s,"}}) {
      const std::string text = content(file);
      EXPECT_EQ(text.starts_with("# "), header == "full");
      EXPECT_EQ(text.find(names) != text.npos, header != "none");
      std::string& rows = rows_below[file];
      if (header == "none") rows = text;
      EXPECT_TRUE(text.ends_with(rows) && !rows.empty());
    }
  }
}

}  // namespace
}  // namespace rotor
