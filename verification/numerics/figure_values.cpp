#include "verification/numerics/figure_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "figures/data/csv.hpp"

namespace rotor {
namespace {

/// Written out here, for the figures must not depend on one line of code alone.
Quad value(const std::string& column, const QuadInstant& instant, const Scenario& scenario) {
  const Parameters& p = scenario.parameters;
  const auto& q = instant.state;
  const Quad rho = sqrt(q[0] * q[0] + q[1] * q[1]);
  // Of O, along the rotating axes.
  const Quad v_1 = q[3] - q[5] * q[1], v_2 = q[4] + q[5] * q[0];
  if (column == "q1_m") return q[0];
  if (column == "q2_m") return q[1];
  if (column == "rho_m") return rho;
  if (column == "x_a_m") return q[0] * cos(q[2]) - q[1] * sin(q[2]);
  if (column == "y_a_m") return q[0] * sin(q[2]) + q[1] * cos(q[2]);
  if (column == "speed_Hz") return q[5] / (8 * atan(Quad(1)));
  if (column == "slip_velocity_m_per_s")
    return (q[0] * v_2 - q[1] * v_1) / rho + Quad(p.rotor_radius) * q[5];
  if (column == "normal_force_N") {
    if (!instant.touches()) return 0;
    const Quad indentation = rho - (Quad(p.stator_radius) - Quad(p.rotor_radius));
    return -Quad(p.contact_stiffness) * indentation -
           Quad(p.contact_damping) * (q[0] * q[3] + q[1] * q[4]) / rho;
  }
  if (column == "kinetic_energy_J") {
    Quad e = p.eccentricity, m = p.mass, inertia = p.inertia;
    if (instant.separated) {
      const Quad e_1 = Quad(p.unbalance_factor) * e, r = p.rotor_radius;
      const Quad lost = m * (e_1 - e) / (r + e_1);
      m -= lost;
      inertia -= lost * (r + e) * (r + e) + m * (e_1 - e) * (e_1 - e);
      e = e_1;
    }
    const Quad v_C = v_2 + q[5] * e;
    return (m * (v_1 * v_1 + v_C * v_C) + inertia * q[5] * q[5]) / 2;
  }
  throw std::runtime_error(fmt::format("{}: there is no formula for it here", column));
}

}  // namespace

void add_probes(Probes& probes, int figure, const std::string& run, const Scene& scene) {
  constexpr int times = 7;
  std::vector<std::string> columns;
  for (const Column* column : scene.columns)
    if (column->name != "time_s" && column->name != "contact_state")
      columns.emplace_back(column->name);
  const Window& window = scene.window;
  for (int n = 0; n < times; ++n) {
    const double share = (n + 0.5) / times;
    const double from = window.from_rolling_onset ? 0 : window.from_s;
    probes.push_back(std::make_shared<Probe>(
        Probe{figure, run, columns, window.from_rolling_onset, from + share * window.length_s}));
  }
}

void ProbedRun::on_instant(const QuadInstant& at) {
  BasicEventRecorder<Quad>::on_instant(at);
  if (at.contact != ContactState::rolling) return;
  for (const auto& probe : probes_)
    if (std::exchange(probe->from_rolling_onset, false)) probe->time_s += at.time_s;
}

bool ProbedRun::wants_dense_output(const Quad& from_s, const Quad& until_s) const {
  return std::any_of(probes_.begin(), probes_.end(), [&](const auto& probe) {
    return !probe->from_rolling_onset && !probe->seen && probe->time_s >= from_s &&
           probe->time_s <= until_s;
  });
}

void ProbedRun::on_step(const BasicDenseOutput<Quad>& step) {
  for (const auto& probe : probes_)
    if (!probe->from_rolling_onset && !probe->seen && probe->time_s >= step.from_s &&
        probe->time_s <= step.until_s) {
      probe->at = step.at(probe->time_s);
      probe->seen = true;
    }
}

std::string figure_values(const Probes& probes, const Scenario& scenario) {
  std::string rows;
  for (const auto& probe : probes) {
    if (!probe->seen)
      throw std::runtime_error(fmt::format("figure {}: nothing of {} at {} s", probe->figure,
                                           probe->run, static_cast<double>(probe->time_s)));
    for (const std::string& column : probe->columns)
      rows += fmt::format("{},{},{},{},{}\n", probe->figure, csv_field(probe->run),
                          probe->time_s.str(18, std::ios_base::scientific), column,
                          value(column, probe->at, scenario).str(18, std::ios_base::scientific));
  }
  return rows;
}

}  // namespace rotor
