/// What is gathered along a run is right at every tolerance that is accepted: maxima and rows are
/// those of the motion that the steps describe, however long the steps are.
#include <gtest/gtest.h>

#include <cmath>

#include "figures/scenes/audience.hpp"
#include "figures/scenes/recorder.hpp"
#include "model/simulation/simulation.hpp"
#include "model/simulation/summary.hpp"
#include "verification/support/column_formulas.hpp"

namespace rotor {
namespace {

/// The largest values of the very motion that a run shows from a time on, sampled densely.
class DenseMaxima : public Observer {
 public:
  DenseMaxima(const Scenario& scenario, double from_s) : scenario_(scenario), from_s_(from_s) {}
  void on_instant(const Instant& at) override { note(at); }
  bool wants_dense_output(const double&, const double& until_s) const override {
    return until_s > from_s_;
  }
  void on_step(const DenseOutput& step) override {
    constexpr int samples = 400;  // dozens in each arc of the longest steps
    for (int n = 0; n <= samples; ++n)
      note(step.at(step.from_s + (step.until_s - step.from_s) * n / samples));
    longest_arcs = std::max(longest_arcs, step.arcs);
  }

  double displacement = 0, normal_force = 0, bearing_force = 0;
  long longest_arcs = 0;

 private:
  void note(const Instant& at) {
    if (at.time_s < from_s_) return;
    const auto raise = [&](double& largest, const char* column) {
      largest = std::max(largest, std::abs(column_by_formula(column, at, scenario_)));
    };
    if (at.separated) raise(displacement, "rho_m");
    if (at.separated) raise(bearing_force, "bearing_force_N");
    raise(normal_force, "normal_force_N");
  }
  const Scenario& scenario_;
  double from_s_;
};

struct Case {
  double tolerance, separation_s, friction, stator_radius;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << "tolerance " << c.tolerance << ", loss at " << c.separation_s << " s, mu " << c.friction
       << ", r_a " << c.stator_radius;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const double tolerance : {1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 1e-6})
    for (const double separation_s : {9.4, 14.15, 29.1, 29.103})
      for (const double friction : {0.3, 0.2, 0.08})
        for (const double stator_radius : {0.063, 0.0625})
          all.push_back({tolerance, separation_s, friction, stator_radius});
  return all;
}

Scenario scenario_of(const Case& c) {
  return {.parameters = {.friction = c.friction,
                         .stator_radius = c.stator_radius,
                         .separation_time = c.separation_s},
          .until = c.separation_s + 0.06,
          .tolerance = c.tolerance};
}

/// The same run's maxima, sampled and located.
std::pair<DenseMaxima, Summary> maxima_of(const Scenario& scenario) {
  DenseMaxima dense(scenario, scenario.parameters.separation_time);
  SummaryObserver observer(scenario);
  Audience audience;
  audience.add(dense);
  audience.add(observer);
  run(scenario, audience);
  return {dense, observer.summary()};
}

// Located, they are no less than any sample, but for the little by which the equations' rates miss
// those of the curve within a step, and no more than the samples' spacing lets be missed.
TEST(LooseTolerances, DoNotHideMaxima) {
  long longest_arcs = 0;
  for (const Case& c : cases()) {
    const Scenario scenario = scenario_of(c);
    const auto [dense, summary] = maxima_of(scenario);
    const auto expect_maximum = [&c](double located, double sampled, const char* of) {
      EXPECT_GE(located, sampled * (1 - 0.1 * c.tolerance))
          << of << ", " << testing::PrintToString(c);
      EXPECT_LE(located, sampled * (1 + 1e-4)) << of << ", " << testing::PrintToString(c);
    };
    expect_maximum(summary.max_displacement_m.value_or(0), dense.displacement, "displacement");
    expect_maximum(summary.peak_normal_force_N.value_or(0), dense.normal_force, "normal force");
    // The run-up's bearing force is below that of the loss.
    expect_maximum(summary.peak_bearing_force_N, dense.bearing_force, "bearing force");
    longest_arcs = std::max(longest_arcs, dense.longest_arcs);
  }
  EXPECT_GT(longest_arcs, 5);  // that steps are long is what makes it hard
}

// A ring without damping lets the rotor vibrate several times within one step: up to 8 % of the
// largest force were missed by looking at the steps' ends alone. What is allowed is by how much the
// rates of the equations and of the curve disagree in the longest steps.
TEST(LooseTolerances, DoNotHideMaximaOfAVibrationWithinAStep) {
  for (const double tolerance : {1e-3, 1e-4})
    for (const double damping : {0., 100., 1000.})
      for (const double friction : {0.1, 0.3, 1.})
        for (const double stator_radius : {0.0625, 0.063})
          for (const double start_speed_Hz : {60., 100., 150.}) {
            Scenario scenario = scenario_of({tolerance, 0, friction, stator_radius});
            scenario.parameters.contact_damping = damping;
            scenario.start_speed_Hz = start_speed_Hz;
            const auto [dense, summary] = maxima_of(scenario);
            const double force = summary.peak_normal_force_N.value_or(0);
            EXPECT_GE(force, dense.normal_force * (1 - 2e-3))
                << tolerance << ' ' << damping << ' ' << friction << ' ' << start_speed_Hz;
            EXPECT_LE(force, dense.normal_force * (1 + 2e-3));
          }
}

// A trace has the largest value in its window, though the run may have had a larger one before.
TEST(LooseTolerances, DoNotHideTheMaximumInAWindow) {
  for (const double friction : {0.1, 0.3, 1.})
    for (const double stator_radius : {0.0625, 0.063})
      for (const double from_s : {0.01, 0.02, 0.03, 0.04, 0.05}) {
        Scenario scenario = scenario_of({1e-3, 0, friction, stator_radius});
        scenario.parameters.contact_damping = 0;
        scenario.start_speed_Hz = 150;
        constexpr double coarse = 1;  // so that rows alone do not show it
        double recorded = 0;
        Recorder recorder({.from_s = from_s, .length_s = scenario.until - from_s},
                          {find_column("time_s"), find_column("normal_force_N")}, scenario, coarse,
                          [&](auto row) { recorded = std::max(recorded, std::abs(row[1])); });
        DenseMaxima dense(scenario, from_s);
        Audience audience;
        audience.add(recorder);
        audience.add(dense);
        run(scenario, audience);
        EXPECT_GE(recorded, dense.normal_force * (1 - 2e-3))
            << friction << ' ' << stator_radius << ' ' << from_s;
      }
}

// Rows of a trace, joined by lines, stay as close to that motion as they do at tight tolerances.
TEST(LooseTolerances, DoNotCoarsenTraces) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const Scenario scenario = scenario_of({tolerance, 9.4, 0.3, 0.063});
    struct Rows {
      std::vector<double> t, rho;
    } trace;
    const std::vector<const Column*> columns = {find_column("time_s"), find_column("rho_m")};
    Recorder recorder({.from_s = 9.4}, columns, scenario, sampling, [&](auto row) {
      trace.t.push_back(row[0]);
      trace.rho.push_back(row[1]);
    });
    struct Samples : Observer {
      bool wants_dense_output(const double& from_s, const double&) const override {
        return from_s >= 9.4;
      }
      void on_step(const DenseOutput& step) override {
        for (int n = 1; n < 500; ++n) {
          const Instant at = step.at(step.from_s + (step.until_s - step.from_s) * n / 500);
          t.push_back(at.time_s);
          rho.push_back(std::hypot(at.state[0], at.state[1]));
        }
      }
      std::vector<double> t, rho;
    } samples;
    Audience audience;
    audience.add(recorder);
    audience.add(samples);
    run(scenario, audience);
    double off = 0;
    for (std::size_t n = 0, i = 1; n < samples.t.size(); ++n) {
      while (trace.t[i] < samples.t[n]) ++i;
      const double part = (samples.t[n] - trace.t[i - 1]) / (trace.t[i] - trace.t[i - 1]);
      const double line = trace.rho[i - 1] + part * (trace.rho[i] - trace.rho[i - 1]);
      off = std::max(off, std::abs(line - samples.rho[n]));
    }
    const double range = *std::max_element(samples.rho.begin(), samples.rho.end());
    // Between points that are looked at, a line may be a little further off than at them.
    EXPECT_LT(off, 1.3 * sampling * range) << tolerance;
  }
}

}  // namespace
}  // namespace rotor
