/// Writes reference-data/high-precision.csv: every event and every final state of the scenes'
/// event-located runs, in quadruple precision, with an estimate of their error. Two steppers and
/// two tolerances are compared; the finer run of Verner's pair is written. Of that one come also a
/// few values of each figure's curves, in reference-data/figure-values.csv.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "figures/data/csv.hpp"
#include "figures/data/files.hpp"
#include "figures/input/scene.hpp"
#include "model/certified/quad.hpp"
#include "model/integration/fehlberg.hpp"
#include "model/methods/event_method.ipp"
#include "model/methods/stages.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

using QuadInstant = BasicInstant<Quad>;

/// A time at which a figure's curves are looked at.
struct Probe {
  int figure;
  std::string run;
  std::vector<std::string> columns;
  bool from_rolling_onset;  ///< whether the time is counted from there, until it is known
  Quad time_s;
  QuadInstant at{};
  bool seen = false;

  bool is_between(const Quad& from_s, const Quad& until_s) const {
    return !from_rolling_onset && !seen && time_s >= from_s && time_s <= until_s;
  }
};

/// Whoever copies a run means the same probes.
using Probes = std::vector<std::shared_ptr<Probe>>;

/// At times spread over the window of a scene.
void add_probes(Probes& probes, int figure, const std::string& run, const Scene& scene) {
  constexpr int times = 7;
  std::vector<std::string> columns;
  for (const Column* column : scene.columns)
    if (column->name != "time_s" && column->name != "contact_state")
      columns.emplace_back(column->name);
  const Window& window = scene.window;
  for (int n = 0; n < times; ++n) {
    const double from = window.from_rolling_onset ? 0 : window.from_s,
                 time_s = from + (n + 0.5) / times * window.length_s;
    probes.push_back(
        std::make_shared<Probe>(Probe{figure, run, columns, window.from_rolling_onset, time_s}));
  }
}

/// Keeps what it is shown, and looks at the probes.
struct ProbedRun : BasicEventRecorder<Quad> {
  explicit ProbedRun(Probes all) : probes(std::move(all)) {}
  void on_instant(const QuadInstant& at) override {
    BasicEventRecorder<Quad>::on_instant(at);
    if (at.contact != ContactState::rolling) return;
    for (const auto& probe : probes)
      if (std::exchange(probe->from_rolling_onset, false)) probe->time_s += at.time_s;
  }
  bool wants_dense_output(const Quad& from_s, const Quad& until_s) const override {
    return std::ranges::any_of(
        probes, [&](const auto& probe) { return probe->is_between(from_s, until_s); });
  }
  void on_step(const BasicDenseOutput<Quad>& step) override {
    for (const auto& probe : probes)
      if (probe->is_between(step.from_s, step.until_s)) {
        probe->at = step.at(probe->time_s);
        probe->seen = true;
      }
  }
  Probes probes;
};

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
    if (instant.mass_lost) {
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

/// The rows of a run's probes.
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

using Unknowns = std::array<Quad, 6>;
using Verner = Verner87<Unknowns, Quad>;
using Fehlberg = Fehlberg78<Unknowns, Quad>;

struct NamedRun {
  std::string name;
  Scenario scenario;
  Probes probes;                       ///< where figures want it
  std::vector<QuadInstant> landmarks;  ///< events, then the end
};

/// The runs of all figures, each once, in the order in which they leave the run-up.
std::vector<NamedRun> all_runs() {
  std::vector<NamedRun> runs;
  for (const auto& [number, scene_file] : figure_files(ROTOR_SCENES)) {
    const auto file = std::filesystem::path(ROTOR_SCENES) / fmt::format("fig{:02}.toml", number);
    const Scene scene = read_scene(file);
    for (const SceneRun& scene_run : scene.runs) {
      const Scenario& scenario = scene_run.scenario;
      if (scenario.method != Method::event) continue;
      const auto same = [&](const NamedRun& run) { return run.scenario == scenario; };
      auto run = std::ranges::find_if(runs, same);
      if (run == runs.end())
        run = runs.insert(run,
                          {fmt::format("fig{:02}: {}", number, scene_run.name), scenario, {}, {}});
      add_probes(run->probes, number, scene_run.name, scene);
    }
  }
  for (const NamedRun& run : runs)
    if (run_up_part(run.scenario) != run_up_part(runs.front().scenario))
      throw std::runtime_error(run.name + ": does not share the run-up of the others");
  std::ranges::stable_sort(runs, {}, [](const NamedRun& run) { return run.scenario.run_up_end(); });
  return runs;
}

template <class Stepper>
std::vector<NamedRun> landmarks(std::vector<NamedRun> runs, const Quad& tolerance,
                                std::string_view what) {
  Probes all;
  for (const NamedRun& run : runs) all.insert(all.end(), run.probes.begin(), run.probes.end());
  ProbedRun on_the_way(all);
  const Scenario& first = runs.front().scenario;
  EventMethod<Quad, Stepper> trunk(first, tolerance, at_rest<Quad>(first.parameters));
  for (NamedRun& run : runs) {
    fmt::print(stderr, "{}: {}\n", what, run.name);
    trunk.run_up(Quad(run.scenario.run_up_end()), on_the_way);
    ProbedRun own = on_the_way;
    own.probes = run.probes;
    auto branch = trunk.with(run.scenario);
    finish(branch, run.scenario, MassLoss<Quad>(run.scenario.parameters), own);
    run.landmarks = own.events();
    run.landmarks.push_back(branch.instant());
    run.landmarks.back().event = Event::none;
  }
  return runs;
}

/// Largest deviation of the states: of lengths relative to the clearance, of velocities relative to
/// that times the speed, of the speed relative to itself, and of the angle in rad.
Quad state_deviation(const NamedRun& run, const QuadInstant& a, const QuadInstant& b) {
  const Quad length = Ring<Quad>(run.scenario.parameters).clearance;
  const Quad speed = abs(a.state[5]) + 1;
  const State<Quad> scale = {length, length, 1, length * speed, length * speed, speed};
  Quad largest = 0;
  for (std::size_t i = 0; i < scale.size(); ++i)
    largest = std::max(largest, Quad(abs(a.state[i] - b.state[i]) / scale[i]));
  return largest;
}

std::string digits(const Quad& value) { return value.str(22, std::ios_base::scientific); }

std::string table(const std::vector<NamedRun>& best,
                  const std::vector<std::vector<NamedRun>>& others) {
  std::string rows =
      "run,landmark,time_s,q1_m,q2_m,q3_rad,q1_rate_m_per_s,q2_rate_m_per_s,q3_rate_rad_per_s,"
      "time_error_s,state_error\n";
  for (std::size_t i = 0; i < best.size(); ++i)
    for (std::size_t k = 0; k < best[i].landmarks.size(); ++k) {
      const QuadInstant& at = best[i].landmarks[k];
      Quad time_error = 0, state_error = 0;
      for (const auto& other : others) {
        if (other[i].landmarks.size() != best[i].landmarks.size())
          throw std::runtime_error(
              fmt::format("{}: the runs do not agree on the number of events", best[i].name));
        const QuadInstant& same = other[i].landmarks[k];
        time_error = std::max(time_error, Quad(abs(at.time_s - same.time_s)));
        state_error = std::max(state_error, state_deviation(best[i], at, same));
      }
      rows += fmt::format("{},{},{}", best[i].name,
                          at.event == Event::none ? "end" : name_of(at.event), digits(at.time_s));
      for (const Quad& value : at.state) rows += fmt::format(",{}", digits(value));
      rows += fmt::format(",{:.1e},{:.1e}\n", static_cast<double>(time_error),
                          static_cast<double>(state_error));
    }
  return rows;
}

int main(const Arguments& arguments) {
  if (arguments.size() != 2) throw std::runtime_error("needs: FILE, FILE of figures' values");
  const Quad coarse("1e-16"), fine("1e-18");
  const std::vector<NamedRun> runs = all_runs();
  const auto best = landmarks<Verner>(runs, fine, "Verner 8(7), tolerance 1e-18");
  std::string figures;
  for (const NamedRun& run : best) figures += figure_values(run.probes, run.scenario);
  FileTransaction files;
  files.write(arguments[1],
              "# A few values of each figure's curves, from `make reference`; not from the paper.\n"
              "# rotor " ROTOR_VERSION
              ", method event in quadruple precision (113 bits), published equations\n"
              "figure,run,time_s,column,value\n" +
                  figures);
  const auto coarser = landmarks<Verner>(runs, coarse, "Verner 8(7), tolerance 1e-16");
  const auto other = landmarks<Fehlberg>(runs, fine, "Fehlberg 7(8), tolerance 1e-18");
  files.write(arguments[0],
              "# High-precision results of our own, from `make reference`; not from the paper.\n"
              "# rotor " ROTOR_VERSION
              ", method event in quadruple precision (113 bits), published equations\n"
              "# Verner 8(7) at tolerance 1e-18; the errors are the largest deviations from Verner "
              "8(7) at 1e-16 and Fehlberg 7(8) at 1e-18.\n"
              "# state_error: lengths relative to the clearance, velocities to that times the "
              "speed and 1 rad/s, the speed to itself and 1 rad/s, the angle in rad.\n" +
                  table(best, {coarser, other}));
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("reference", rotor::main, argc, argv); }
