#include "verification/paper/convergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "figures/data/csv.hpp"
#include "model/simulation/simulation.hpp"
#include "model/simulation/summary.hpp"

namespace rotor {
namespace {

constexpr double converged_tolerance = 1e-13;
constexpr std::array tolerances = {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
constexpr std::array steps = {4., 2., 1., 1. / 2, 1. / 4, 1. / 8, 1. / 16};
constexpr std::size_t papers_own = 2;  // of the steps

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

/// The slope of the logarithms, leaving out what has no error.
double power(std::span<const double> settings, const std::function<double(std::size_t)>& error) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (error(i) < 1e-11) continue;  // rounding, about
    const double a = std::log(settings[i]), b = std::log(error(i));
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return n < 3 ? std::numeric_limits<double>::quiet_NaN() : (n * xy - x * y) / (n * xx - x * x);
}

/// Of each three successive steps, as far as they differ by more than rounding.
std::vector<double> orders_of(const std::vector<double>& by_steps) {
  std::vector<double> orders;
  for (std::size_t i = 2; i < by_steps.size(); ++i) {
    const double coarse = by_steps[i - 2] - by_steps[i - 1], fine = by_steps[i - 1] - by_steps[i];
    if (std::max(std::abs(coarse), std::abs(fine)) < 1e-11 * std::abs(by_steps[i])) break;
    const double ratio = coarse / fine;
    orders.push_back(ratio > 0 ? std::log2(ratio) : std::numeric_limits<double>::quiet_NaN());
  }
  return orders;
}

std::string text_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.1e}", *value) : "none";
}
std::string power_text(double power) {
  return std::isnan(power) ? "-" : fmt::format("{:.2f}", power);
}

}  // namespace

std::span<const double> studied_tolerances() { return tolerances; }
std::span<const double> studied_steps() { return steps; }

double Convergence::error_by_tolerance(std::size_t n) const {
  return std::abs(by_tolerance[n] / converged - 1);
}
double Convergence::error_by_steps(std::size_t n) const {
  return std::abs(by_steps[n] / converged - 1);
}
double Convergence::power_of_tolerance() const {
  return power(tolerances, [&](std::size_t n) { return error_by_tolerance(n); });
}
double Convergence::power_of_step() const {
  return power(steps, [&](std::size_t n) { return error_by_steps(n); });
}

std::optional<double> Convergence::grid_convergence_index() const {
  if (orders.size() < 2) return std::nullopt;
  const auto [least, greatest] = std::ranges::minmax(orders);
  const bool all = std::ranges::none_of(orders, [](double p) { return std::isnan(p); });
  if (!all || greatest > 1.1 * least) return std::nullopt;
  constexpr double safety = 1.25;
  const double fine = by_steps[papers_own], coarser = by_steps[papers_own - 1];
  return safety * std::abs((coarser - fine) / fine) / (std::exp2(orders.front()) - 1);
}

std::vector<Convergence> studied_convergence() {
  std::vector<Convergence> all;
  for (const Stretch& stretch : stretches()) {
    const std::size_t first = all.size();
    const Result converged = by_tolerance(stretch, converged_tolerance);
    for (const Named& landmark : stretch.landmarks)
      all.push_back({landmark.name, landmark.unit, landmark.of(converged), {}, {}, {}});
    const auto note = [&](const Result& result, std::vector<double> Convergence::*values) {
      for (std::size_t n = 0; n < stretch.landmarks.size(); ++n)
        (all[first + n].*values).push_back(stretch.landmarks[n].of(result));
    };
    for (const double tolerance : tolerances)
      note(by_tolerance(stretch, tolerance), &Convergence::by_tolerance);
    for (const double times : steps) note(by_steps(stretch, times), &Convergence::by_steps);
    for (std::size_t n = first; n < all.size(); ++n) all[n].orders = orders_of(all[n].by_steps);
  }
  return all;
}

std::string convergence_table(const std::vector<Convergence>& all) {
  std::string table = fmt::format("  {:<54}{:>14}", "event method, tolerance", "converged");
  for (const double tolerance : tolerances) table += fmt::format("{:>9.0e}", tolerance);
  table += fmt::format("{:>9}\n", "power");
  for (const Convergence& c : all) {
    table += fmt::format("  {:<54}{:>10.7g} {:<3}", c.landmark, c.converged, c.unit);
    for (std::size_t n = 0; n < tolerances.size(); ++n)
      table += fmt::format("{:>9.1e}", c.error_by_tolerance(n));
    table += fmt::format("{:>9}\n", power_text(c.power_of_tolerance()));
  }
  table += fmt::format("  {:<68}", "paper's method, steps in those of the paper");
  for (const double times : steps) table += fmt::format("{:>9.4g}", times);
  table += fmt::format("{:>9}  {:<34}{}\n", "power", "orders of three successive steps", "GCI");
  for (const Convergence& c : all) {
    table += fmt::format("  {:<68}", c.landmark);
    for (std::size_t n = 0; n < steps.size(); ++n)
      table += fmt::format("{:>9.1e}", c.error_by_steps(n));
    std::string orders;
    for (const double p : c.orders) orders += std::isnan(p) ? "  -  " : fmt::format("{:5.1f}", p);
    table += fmt::format("{:>9}  {:<34}{}\n", power_text(c.power_of_step()), orders,
                         text_of(c.grid_convergence_index()));
  }
  return table;
}

std::string to_csv(const std::vector<Convergence>& all) {
  std::string csv = "landmark,unit,method,tolerance_or_steps,value,relative_error\n";
  const auto row = [&](const Convergence& c, const char* method, double setting, double value,
                       double error) {
    csv += fmt::format("{},{},{},{},{:.12g},{:.3g}\n", csv_field(c.landmark), c.unit, method,
                       setting, value, error);
  };
  for (const Convergence& c : all) {
    row(c, "event", converged_tolerance, c.converged, 0);
    for (std::size_t n = 0; n < tolerances.size(); ++n)
      row(c, "event", tolerances[n], c.by_tolerance[n], c.error_by_tolerance(n));
    for (std::size_t n = 0; n < steps.size(); ++n)
      row(c, "rk4", steps[n], c.by_steps[n], c.error_by_steps(n));
  }
  return csv;
}

}  // namespace rotor
