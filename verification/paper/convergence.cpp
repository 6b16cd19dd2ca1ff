#include "verification/paper/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "figures/data/csv.hpp"
#include "model/simulation/simulation.hpp"
#include "model/simulation/summary.hpp"

namespace rotor {
namespace {

constexpr double converged_tolerance = 1e-13;
const std::vector<double> tolerances = {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
const std::vector<double> steps = {4., 2., 1., 1. / 2, 1. / 4, 1. / 8, 1. / 16};

struct Result {
  Summary summary;
  Instant last;
};

using Landmark = std::function<double(const Result&)>;
struct Named {
  std::string name, unit;
  Landmark of;
};

/// A part of a run that both methods begin alike, and what is read off it.
struct Stretch {
  Scenario scenario;
  Instant from;
  std::vector<Named> landmarks;
};

Result result_of(const Stretch& stretch, const Scenario& scenario) {
  SummaryObserver observer(scenario);
  const RunEnd end = run(scenario, stretch.from, observer);
  return {observer.summary(), end.last};
}

Result by_tolerance(const Stretch& stretch, double tolerance) {
  Scenario scenario = stretch.scenario;
  scenario.tolerance = tolerance;
  return result_of(stretch, scenario);
}

Result by_steps(const Stretch& stretch, double times) {
  Scenario scenario = stretch.scenario;
  scenario.method = Method::rk4;
  scenario.step_rub *= times;
  return result_of(stretch, scenario);
}

/// From just after the mass loss.
Stretch rub(double friction, std::vector<Named> landmarks) {
  Scenario scenario{.parameters = {.friction = friction}, .tolerance = converged_tolerance};
  Simulation simulation(scenario);
  Observer null_observer;
  simulation.pass_mass_loss(null_observer);
  return {scenario, simulation.instant(), std::move(landmarks)};
}

std::vector<Stretch> stretches() {
  const Landmark final_Hz = [](const Result& r) { return in_Hz(r.last.state[5]); };
  const Landmark peak_kN = [](const Result& r) { return *r.summary.peak_normal_force_N / 1e3; };
  // Before the first contact the motion is smooth. Steps are 16 times as large, whose errors stand
  // above rounding.
  Stretch flight =
      rub(0.3, {{"flight to 29.104 s by 16 times the step: displacement", "mm",
                 [](const Result& r) { return 1e3 * r.last.motion().displacement.norm(); }},
                {"flight to 29.104 s by 16 times the step: q1", "mm",
                 [](const Result& r) { return 1e3 * r.last.state[0]; }}});
  flight.scenario.until = 29.104;
  flight.scenario.step_rub *= 16;
  return {
      flight,
      rub(0.3, {{"mu = 0.3: first contact after the loss", "ms",
                 [](const Result& r) { return 1e3 * (*r.summary.first_contact_s - 29.1); }},
                {"mu = 0.3: onset of rolling after the loss", "ms",
                 [](const Result& r) { return 1e3 * (*r.summary.rolling_onset_s - 29.1); }},
                {"mu = 0.3: speed there", "Hz",
                 [](const Result& r) { return *r.summary.rolling_onset_speed_Hz; }},
                {"mu = 0.3: force there", "kN",
                 [](const Result& r) { return *r.summary.rolling_onset_force_N / 1e3; }},
                {"mu = 0.3: largest force", "kN", peak_kN},
                {"mu = 0.3: speed at 29.35 s", "Hz", final_Hz}}),
      rub(0.08, {{"mu = 0.08: largest force", "kN", peak_kN},
                 {"mu = 0.08: touch-downs", "",
                  [](const Result& r) { return static_cast<double>(r.summary.collisions); }},
                 {"mu = 0.08: speed at 29.35 s", "Hz", final_Hz}}),
  };
}

}  // namespace

double Convergence::error(std::size_t n) const { return std::abs(values[n] / converged - 1); }

double Convergence::power() const {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (error(i) < 1e-11) continue;  // rounding, about
    const double a = std::log(settings[i]), b = std::log(error(i));
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return n < 3 ? std::numeric_limits<double>::quiet_NaN() : (n * xy - x * y) / (n * xx - x * x);
}

std::vector<Convergence> studied_convergence() {
  std::vector<Convergence> all;
  for (const auto& [method, settings, result] :
       {std::tuple("event", tolerances, &by_tolerance), {"rk4", steps, &by_steps}})
    for (const Stretch& stretch : stretches()) {
      const Result converged = by_tolerance(stretch, converged_tolerance);
      const std::size_t first = all.size();
      for (const Named& landmark : stretch.landmarks)
        all.push_back({landmark.name, landmark.unit, method, landmark.of(converged), settings, {}});
      for (const double setting : settings) {
        const Result its = result(stretch, setting);
        for (std::size_t n = 0; n < stretch.landmarks.size(); ++n)
          all[first + n].values.push_back(stretch.landmarks[n].of(its));
      }
    }
  return all;
}

std::string convergence_table(const std::vector<Convergence>& all) {
  std::string table, method;
  for (const Convergence& c : all) {
    if (c.method != method) {
      method = c.method;
      table += fmt::format("  {:<54}{:>14}",
                           method == "event" ? "event method, tolerance"
                                             : "paper's method, steps in those of the paper",
                           "converged");
      for (const double setting : c.settings) table += fmt::format("{:>9.4g}", setting);
      table += fmt::format("{:>9}\n", "power");
    }
    table += fmt::format("  {:<54}{:>10.7g} {:<3}", c.landmark, c.converged, c.unit);
    for (std::size_t n = 0; n < c.settings.size(); ++n)
      table += fmt::format("{:>9.1e}", c.error(n));
    table +=
        std::isnan(c.power()) ? fmt::format("{:>9}\n", "-") : fmt::format("{:>9.2f}\n", c.power());
  }
  return table;
}

std::string to_csv(const std::vector<Convergence>& all) {
  std::string csv = "landmark,unit,method,tolerance_or_steps,value,relative_error\n";
  for (const Convergence& c : all)
    for (std::size_t n = 0; n < c.settings.size(); ++n)
      csv += fmt::format("{},{},{},{},{:.12g},{:.3g}\n", csv_field(c.landmark), c.unit, c.method,
                         c.settings[n], c.values[n], c.error(n));
  return csv;
}

}  // namespace rotor
