/// Writes reference-data/high-precision.csv: every event and every final state of the scenes'
/// event-located runs, in quadruple precision, with an estimate of their error. Two steppers and
/// two tolerances are compared; the finer run of Verner's pair is written.
#include <fmt/format.h>

#include <algorithm>

#include "figures/data/csv.hpp"
#include "figures/runs/scene.hpp"
#include "model/digits/quad.hpp"
#include "model/integration/fehlberg.hpp"
#include "model/methods/event_method.hpp"
#include "model/methods/whole_run.hpp"
#include "verification/support/observers.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

using QuadInstant = BasicInstant<Quad>;

using Unknowns = std::array<Quad, 6>;
using Verner = Verner87<Unknowns, Quad>;
using Fehlberg = Fehlberg78<Unknowns, Quad>;

struct NamedRun {
  std::string name;
  Scenario scenario;
  std::vector<QuadInstant> landmarks;  ///< events, then the end
};

/// The runs of all figures, each once, in the order in which they leave the run-up.
std::vector<NamedRun> all_runs() {
  std::vector<NamedRun> runs;
  for (const auto& [number, scene_file] : figure_files(ROTOR_SCENES)) {
    for (const SceneRun& scene_run : read_scene(scene_file).runs) {
      const Scenario& scenario = scene_run.scenario;
      if (scenario.method != Method::event) continue;
      const auto same = [&](const NamedRun& run) { return run.scenario == scenario; };
      if (std::ranges::none_of(runs, same))
        runs.push_back({fmt::format("fig{:02}: {}", number, scene_run.name), scenario, {}});
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
  BasicEventRecorder<Quad> on_the_way;
  const Scenario& first = runs.front().scenario;
  EventMethod<Quad, Stepper> trunk(first, tolerance, at_rest<Quad>(first.parameters));
  for (NamedRun& run : runs) {
    fmt::print(stderr, "{}: {}\n", what, run.name);
    trunk.run_up(Quad(run.scenario.run_up_end()), on_the_way);
    BasicEventRecorder<Quad> own = on_the_way;
    auto branch = trunk.branch(run.scenario);
    run_to_end(branch, run.scenario, MassLoss<Quad>(run.scenario.parameters), own);
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
  if (arguments.size() != 1) throw std::runtime_error("needs: FILE");
  const Quad coarse("1e-18"), fine("1e-20");
  const std::vector<NamedRun> runs = all_runs();
  const auto best = landmarks<Verner>(runs, fine, "Verner 8(7), tolerance 1e-20");
  const auto coarser = landmarks<Verner>(runs, coarse, "Verner 8(7), tolerance 1e-18");
  const auto other = landmarks<Fehlberg>(runs, fine, "Fehlberg 7(8), tolerance 1e-20");
  write_file(arguments[0],
             "# High-precision results of our own, from `make reference`; not from the paper.\n"
             "# rotor " ROTOR_VERSION
             ", method event in quadruple precision (113 bits), published equations\n"
             "# Verner 8(7) at tolerance 1e-20; the errors are the largest deviations from Verner "
             "8(7) at 1e-18 and Fehlberg 7(8) at 1e-20.\n"
             "# state_error: lengths relative to the clearance, velocities to that times the "
             "speed and 1 rad/s, the speed to itself and 1 rad/s, the angle in rad.\n" +
                 table(best, {coarser, other}));
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("reference", rotor::main, argc, argv); }
