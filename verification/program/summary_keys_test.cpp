/// The results that `rotor run --json` prints against direct use of the engine: its events, maxima
/// and end, and closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "figures/input/names.hpp"
#include "model/results/summary.hpp"
#include "model/run/simulation.hpp"
#include "verification/support/column_formulas.hpp"
#include "verification/support/command_line.hpp"

namespace rotor {
namespace {

constexpr double turn = 2 * 3.14159265358979323846;

/// The expected summary, gathered in the simplest way.
class Landmarks : public Observer {
 public:
  explicit Landmarks(const Scenario& scenario) : scenario_(scenario) {}

  void on_instant(const Instant& at) override {
    const bool touches = value("contact_state", at) == 1 || value("contact_state", at) == 2;
    const bool rolls = value("contact_state", at) == 2;
    if (at.event == Event::touch_down) {
      if (!said["first_contact_s"].is_number()) said["first_contact_s"] = at.time_s;
      said["touch_downs"] = said["touch_downs"].get<long>() + 1;
      if (!at.mass_lost)
        said["touch_downs_before_loss"] = said["touch_downs_before_loss"].get<long>() + 1;
      if (!said["rolling_onset_s"].is_number())
        said["touch_downs_to_rolling"] = said["touch_downs_to_rolling"].get<long>() + 1;
    }
    if (rolls && !said["rolling_onset_s"].is_number()) {
      said["rolling_onset_s"] = at.time_s;
      said["rolling_onset_speed_Hz"] = at.state[5] / turn;
      said["rolling_onset_force_N"] = -value("normal_force_N", at);
    }
    if (rolls) said["rolling_until_s"] = nullptr;
    if (rolled_ && !rolls) said["rolling_until_s"] = at.time_s;
    rolled_ = rolls;
    if (touched_) contact_s += at.time_s - since_s_;
    touched_ = touches;
    since_s_ = at.time_s;
    if (at.event == Event::motor_off) said["motor_off_s"] = at.time_s;
    if (at.event == Event::mass_loss) {
      said["speed_at_mass_loss_Hz"] = at.state[5] / turn;
      said["mass_loss_reached"] = true;
    }
    note_maxima(at);
  }
  double threshold(Extreme, const double&, const double&) const override { return 0; }
  void on_maximum(const Maximum& maximum) override {
    note_maxima(maximum.at);
    rolled_at_peak_ = rolled_at_peak_ ||
                      (said["rolling_onset_s"].is_number() && maximum.of == Extreme::normal_force);
  }

  Json said = {{"touch_downs", 0},
               {"touch_downs_before_loss", 0},
               {"touch_downs_to_rolling", 0},
               {"peak_force_to_rolling_N", nullptr},
               {"max_displacement_before_loss_m", 0},
               {"peak_bearing_force_N", 0},
               {"mass_loss_reached", false},
               {"first_contact_s", nullptr},
               {"rolling_onset_s", nullptr},
               {"rolling_onset_speed_Hz", nullptr},
               {"rolling_onset_force_N", nullptr},
               {"rolling_until_s", nullptr},
               {"peak_normal_force_N", nullptr},
               {"peak_time_s", nullptr},
               {"peak_normal_force_before_loss_N", nullptr},
               {"max_displacement_m", nullptr},
               {"motor_off_s", nullptr},
               {"speed_at_mass_loss_Hz", nullptr}};
  double contact_s = 0;

 private:
  double value(const char* column, const Instant& at) const {
    return column_by_formula(column, at, scenario_);
  }
  bool raises(const char* key, double value) {
    if (said[key].is_number() && said[key].get<double>() >= value) return false;
    said[key] = value;
    return true;
  }
  void note_maxima(const Instant& at) {
    const double rho = value("rho_m", at);
    if (at.mass_lost || !scenario_.parameters.loses_mass) raises("max_displacement_m", rho);
    if (!at.mass_lost) raises("max_displacement_before_loss_m", rho);
    raises("peak_bearing_force_N", value("bearing_force_N", at));
    const double force = -value("normal_force_N", at);
    if (!(force > 0)) return;
    if (raises("peak_normal_force_N", force)) said["peak_time_s"] = at.time_s;
    if (!at.mass_lost) raises("peak_normal_force_before_loss_N", force);
    if (!rolled_at_peak_) raises("peak_force_to_rolling_N", force);
  }

  const Scenario& scenario_;
  bool rolled_ = false, touched_ = false, rolled_at_peak_ = false;
  double since_s_ = 0;
};

void expect_equal(const Json& printed, const Json& expected, const std::string& key) {
  ASSERT_TRUE(printed.contains(key)) << key;
  if (expected.is_number_float() && printed[key].is_number()) {
    const auto value = expected.get<double>();
    EXPECT_NEAR(printed[key].get<double>(), value, 1e-11 * std::abs(value)) << key;
  } else {
    EXPECT_EQ(printed[key], expected) << key;
  }
}

struct Case {
  const char* arguments;
  Scenario scenario;
};

class SummaryKeys : public CommandLine {};

/// Rolling until its end; contacts before the loss; no contact; no mass loss; an end before it.
std::vector<Case> cases() {
  Scenario early{.until = 10.3, .tolerance = 1e-9};
  early.parameters.support_stiffness = 1.2e5;
  early.parameters.mass_loss_time = 10;
  Scenario none{.equations = Equations::consistent, .until = 9.65};
  none.parameters.mass_loss_time = 9.4;
  none.parameters.unbalance_factor = 2;
  Scenario whole{.start_speed_Hz = 40, .until = 0.5};
  whole.parameters.loses_mass = false;
  whole.parameters.mass = 6;
  Scenario before{.until = 3};  // and no loss after it
  before.parameters.loses_mass = false;
  before.parameters.stator_radius = 0.061;
  Scenario rolling{.until = 31};
  rolling.parameters.motor_off_Hz = 149;
  return {{"--until 31 --motor-off-hz 149", rolling},
          {"--support-stiffness 1.2e5 --mass-loss-time 10 --until 10.3 --tolerance 1e-9", early},
          {"--mass-loss-time 9.4 --unbalance-factor 2 --equations consistent", none},
          {"--start-speed-hz 40 --until 0.5 --no-mass-loss --mass 6", whole},
          {"--no-mass-loss --until 3 --stator-radius 0.061", before},
          {"--until 3", {.until = 3}}};
}

TEST_F(SummaryKeys, SayWhatTheRunShows) {
  for (const auto& [arguments, scenario] : cases()) {
    SCOPED_TRACE(arguments);
    const Json printed = summary(arguments);
    Landmarks landmarks(scenario);
    run(scenario, landmarks);
    SummaryObserver found(scenario);
    const RunEnd end = run(scenario, found);

    Json expected = landmarks.said;
    const Parameters& p = scenario.parameters;
    const double critical = std::sqrt(p.support_stiffness / p.mass) / turn;
    const double e = p.eccentricity, e_1 = p.unbalance_factor * e, r = p.rotor_radius;
    const double lost = p.mass * (e_1 - e) / (r + e_1), left = p.mass - lost;
    const auto if_lost = [&](double value) { return p.loses_mass ? Json(value) : Json(nullptr); };
    expected["contact_time_s"] = landmarks.contact_s;
    expected["critical_speed_Hz"] = critical;
    expected["damping_ratio"] = p.support_damping / (2 * p.mass * critical * turn);
    expected["lost_mass_kg"] = if_lost(lost);
    expected["inertia_after_loss_kg_m2"] =
        if_lost(p.inertia - lost * (r + e) * (r + e) - left * (e_1 - e) * (e_1 - e));
    const Json& at_loss = expected["speed_at_mass_loss_Hz"];
    expected["speed_ratio_at_mass_loss"] =
        at_loss.is_null() ? Json(nullptr) : Json(at_loss.get<double>() / critical);
    expected["final_time_s"] = end.last.time_s;
    expected["final_speed_Hz"] = end.last.state[5] / turn;
    expected["final_q1_m"] = end.last.state[0];
    expected["final_q2_m"] = end.last.state[1];
    expected["final_kinetic_energy_J"] = column_by_formula("kinetic_energy_J", end.last, scenario);
    expected["right_hand_sides"] = end.counters.right_hand_sides;
    expected["contact_evaluations"] = end.counters.contact_evaluations;
    expected["steps"] = end.counters.steps;
    expected["located_events"] = end.counters.located_events;
    // Outcome and whirl are taken from the engine; outcome_test.cpp and summary_test.cpp test them.
    expected["outcome"] = std::string(name_of(found.summary().outcome));
    const auto number = [](const std::optional<double>& value) {
      return value ? Json(*value) : Json(nullptr);
    };
    expected["whirl_frequency_Hz"] = number(found.summary().whirl_frequency_Hz);
    expected["whirl_from_s"] = number(found.summary().whirl_from_s);
    expected["whirl_until_s"] = number(found.summary().whirl_until_s);
    expected["stop_on"] = nullptr;
    expected["stop_reached"] = false;
    expected["tolerance"] = scenario.tolerance;
    expected["estimated_relative_error"] = nullptr;  // not requested
    expected["version"] = ROTOR_VERSION;
    for (const auto& [key, value] : expected.items()) expect_equal(printed, value, key);
  }
}

}  // namespace
}  // namespace rotor
