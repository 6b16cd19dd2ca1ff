/// Every column against formulas written out anew, in every state of the contact.
#include "figures/scenes/columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <tuple>

#include "figures/scenes/audience.hpp"
#include "figures/scenes/recorder.hpp"
#include "model/simulation/simulation.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/observers.hpp"

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
                         .unbalance_factor = 2.5},
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

/// Where sliding begins or ends, the slip says by rounding alone which way the rim slides.
bool slip_is_rounding(const Instant& at, const Scenario& scenario) {
  const double slip = column_by_formula("slip_velocity_m_per_s", at, scenario);
  return at.contact == ContactState::sliding && std::abs(slip) < 1e-12;
}

class Columns : public testing::TestWithParam<std::tuple<Equations, Method, bool>> {};

// Their largest values, over which rounding is spread, take part: F_n is the difference of a
// displacement and the clearance, times k_t; a holding friction that of loads of its size.
void compare(const Column& column, const std::vector<Instant>& instants, const Scenario& scenario) {
  const ColumnContext context(scenario);
  double largest = 0;
  for (const Instant& at : instants)
    largest = std::max(largest, std::abs(column_by_formula(column.name, at, scenario)));
  for (const Instant& at : instants) {
    View view(at, context);
    double expected = column_by_formula(column.name, at, scenario);
    if (column.name == "friction_force_N" && slip_is_rounding(at, scenario))
      expected = -at.direction * std::abs(expected);
    ASSERT_NEAR(column.value(view), expected, 1e-10 * std::abs(expected) + 1e-12 * largest)
        << column.name << " at " << at.time_s << " s, state " << static_cast<int>(at.contact);
  }
}

TEST_P(Columns, AreWhatTheFormulasSay) {
  const auto [equations, method, motor_on] = GetParam();
  Scenario scenario = of_its_own(equations, method);
  Instants instants;
  for (const double separation_s : {0.0001, 0.099}) {  // before all contacts, and after most
    scenario.parameters.separation_time = separation_s;
    run(scenario, towards_the_ring(scenario, motor_on), instants);
  }
  std::map<std::tuple<ContactState, bool>, int> seen;
  for (const Instant& at : instants.all) ++seen[{at.contact, at.separated}];
  for (const ContactState state :
       {ContactState::free, ContactState::indented, ContactState::sliding, ContactState::rolling})
    for (const bool separated : {false, true})
      EXPECT_GT((seen[{state, separated}]), 2) << static_cast<int>(state) << separated;
  for (const Column& column : all_columns()) compare(column, instants.all, scenario);
}

std::string name_of_case(const testing::TestParamInfo<Columns::ParamType>& c) {
  const auto& [equations, method, motor_on] = c.param;
  return std::string(equations == Equations::published ? "Published" : "Consistent") +
         (method == Method::event ? "ByEvent" : "ByRk4") + (motor_on ? "Driven" : "Coasting");
}

INSTANTIATE_TEST_SUITE_P(
    EverySetAndMethod, Columns,
    testing::Combine(testing::Values(Equations::published, Equations::consistent),
                     testing::Values(Method::event, Method::rk4), testing::Bool()),
    name_of_case);

// The paper's signs, at an instant whose answer can be told without any formula.
TEST(Column, HasThePapersSigns) {
  const Scenario scenario;
  Instant at = at_rest(scenario.parameters);
  at.contact = ContactState::sliding;
  at.state = {0, 3.5e-3, 0, 0, 0, 900};  // O lies along y_a, the rim slides with the rotation
  const ColumnContext context(scenario);
  const auto value = [&](const char* name) {
    View view(at, context);
    return find_column(name)->value(view);
  };
  EXPECT_EQ(value("x_a_m"), 0);
  EXPECT_GT(value("y_a_m"), 3e-3);
  EXPECT_LT(value("normal_force_N"), -3e5);  // compression
  EXPECT_LT(value("friction_force_N"), 0);   // against the slip
  EXPECT_GT(value("slip_velocity_m_per_s"), 0);
  EXPECT_LT(value("friction_power_W"), 0);
  at.state[2] = std::acos(-1.) / 2;  // y of the rotor points up now, against x_a
  EXPECT_LT(value("x_a_m"), -3e-3);
  EXPECT_NEAR(value("y_a_m"), 0, 1e-15);
}

TEST(Column, HasNoSlipAndNoWhirlWhereTheRotorIsCentred) {
  const Scenario scenario;
  const Instant at = at_rest(scenario.parameters);
  const ColumnContext context(scenario);
  for (const Column& column : all_columns()) {
    View view(at, context);
    const bool has_none =
        column.name == "slip_velocity_m_per_s" || column.name == "whirl_frequency_Hz";
    EXPECT_EQ(std::isnan(column.value(view)), has_none) << column.name;
    EXPECT_EQ(find_column(column.name), &column);
  }
}

// Friction does not jump where the rim breaks away, or turns round, but to the side that it slides
// to.
TEST(Column, OfFrictionHasTheSignOfTheSlipThatFollows) {
  Scenario scenario{.start_speed_Hz = 150, .until = 1.6};
  scenario.parameters.separation_time = 0;
  const ColumnContext context(scenario);
  EventRecorder recorder;
  run(scenario, recorder);
  int at_rest = 0;
  for (const Instant& at : recorder.events()) {
    if (at.event != Event::break_away && at.event != Event::slip_reversal) continue;
    ++at_rest;
    double after = 0;
    MotionObserver look(at.time_s, at.time_s + 1e-3, [&](const DenseOutput& motion) {
      if (after != 0 || motion.from_s < at.time_s) return;
      const Instant later = motion.at(motion.from_s + 1e-3 * (motion.until_s - motion.from_s));
      after = View(later, context).friction();
    });
    run(scenario, at, look);
    EXPECT_EQ(std::signbit(View(at, context).friction()), std::signbit(after)) << at.time_s;
  }
  EXPECT_GT(at_rest, 0);
}

// Where the slip ends, it is an error of interpolation at a loose tolerance, but friction is not.
TEST(Column, OfFrictionDoesNotTurnRoundWhereTheSlipEnds) {
  for (const double tolerance : {1e-3, 1e-5, 1e-7, 1e-12}) {
    Scenario scenario{.start_speed_Hz = 150, .until = 0.2, .tolerance = tolerance};
    scenario.parameters.separation_time = 0;
    scenario.parameters.contact_damping = 1e5;
    double most = 0;
    bool slides_back = false;
    int rows = 0;
    Recorder recorder({}, {find_column("friction_force_N"), find_column("contact_state")}, scenario,
                      1e-3, [&](std::span<const double> row) {
                        ++rows;
                        if (row[1] == 1) most = std::max(most, row[0]);
                      });
    EventRecorder events;
    Audience audience;
    audience.add(recorder);
    audience.add(events);
    run(scenario, audience);
    for (const Instant& at : events.events()) slides_back = slides_back || at.direction < 0;
    EXPECT_FALSE(slides_back) << tolerance;  // so that friction is against the rotation throughout
    EXPECT_EQ(most, 0) << tolerance;
    EXPECT_GT(rows, 1000) << tolerance;
  }
}

// Whose largest magnitudes a trace contains.
TEST(Column, OfAnExtremeIsThatExtreme) {
  for (const Column& column : all_columns()) {
    const auto expected = column.name == "rho_m"             ? std::optional(Extreme::displacement)
                          : column.name == "normal_force_N"  ? std::optional(Extreme::normal_force)
                          : column.name == "bearing_force_N" ? std::optional(Extreme::bearing_force)
                                                             : std::nullopt;
    EXPECT_EQ(column.extreme, expected) << column.name;
  }
}

}  // namespace
}  // namespace rotor
