/// Run time against error: each method, over its steps or tolerances, on scenes of the paper.
/// `benchmark FOLDER` prints tables and writes FOLDER/work-precision.csv; `benchmark FOLDER PYTHON
/// SCRIPT` asks that script, in another process, for SciPy's rows. Times are of this machine;
/// ratios are what counts. The reference is a run in extended precision by another stepper.
#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>

#include "figures/csv.hpp"
#include "model/event_method.hpp"
#include "model/published_method.hpp"
#include "verification/peer.hpp"
#include "verification/program.hpp"
#ifdef ROTOR_SUNDIALS
#include "verification/sundials_solver.hpp"
#endif
#ifdef ROTOR_GSL
#include "verification/gsl_solver.hpp"
#endif

namespace rotor {
namespace {

namespace odeint = boost::numeric::odeint;
using Extended = long double;

template <class S>
using Verner = Verner87<std::array<S, 6>, S>;
template <class S>
using Fehlberg78 =
    odeint::runge_kutta_fehlberg78<std::array<S, 6>, S, std::array<S, 6>, S, odeint::array_algebra>;
template <class S>
using CashKarp54 = odeint::runge_kutta_cash_karp54<std::array<S, 6>, S, std::array<S, 6>, S,
                                                   odeint::array_algebra>;

/// Where a scene begins, known in extended precision, and where it ends.
struct Scene {
  std::string name;
  Scenario scenario;
  BasicInstant<Extended> start;
  bool is_run_up = false;

  bool touches() const { return start.contact != ContactState::free; }
};

/// What a run found.
struct Outcome {
  State<double> state;
  std::vector<double> touch_downs;
  double peak_force = 0;
  Work work;
};

/// Watches for touch-downs and the peak force.
template <class S>
class Landmarks : public BasicObserver<S> {
 public:
  /// `touches` at the start, if the rim does: that is no touch-down.
  Landmarks(const Parameters& p, bool touches) : ring_(p), touching_(touches) {}

  using BasicObserver<S>::see;
  void see(const BasicInstant<S>& at) override {
    const bool touches = at.contact != ContactState::free;
    if (touches && !touching_) touch_downs.push_back(static_cast<double>(at.time_s));
    touching_ = touches;
    if (touches)
      peak_force = std::max(peak_force,
                            -static_cast<double>(ring_.normal_force(ring_.rim_point(at.motion()))));
  }
  bool wants(Extreme of, const S& bound, const S&, const S&) const override {
    return of == Extreme::normal_force && bound > peak_force;
  }

  std::vector<double> touch_downs;
  double peak_force = 0;

 private:
  Ring<S> ring_;
  bool touching_;
};

template <class S, class Stepper>
Outcome by_events(const Scene& scene, const S& tolerance) {
  Outcome outcome;
  Landmarks<S> landmarks(scene.scenario.parameters, scene.touches());
  EventMethod<S, Stepper> method(scene.scenario, tolerance, landmarks, outcome.work);
  BasicInstant<S> at;
  at.time_s = static_cast<S>(scene.start.time_s);
  for (std::size_t i = 0; i < 6; ++i) at.state[i] = static_cast<S>(scene.start.state[i]);
  at.separated = scene.start.separated;
  at.motor_on = scene.start.motor_on;
  at.contact = scene.start.contact;
  const MassLoss<S> loss(scene.scenario.parameters);
  at.body = at.separated ? loss.after : loss.before;
  at = method.rub(at, S(scene.scenario.until));
  for (std::size_t i = 0; i < 6; ++i) outcome.state[i] = static_cast<double>(at.state[i]);
  outcome.touch_downs = landmarks.touch_downs;
  outcome.peak_force = landmarks.peak_force;
  return outcome;
}

Instant rounded(const BasicInstant<Extended>& at) {
  Instant result{.time_s = static_cast<double>(at.time_s),
                 .body = {static_cast<double>(at.body.mass), static_cast<double>(at.body.inertia),
                          static_cast<double>(at.body.eccentricity)},
                 .motor_on = at.motor_on,
                 .separated = at.separated,
                 .contact = at.contact};
  for (std::size_t i = 0; i < 6; ++i) result.state[i] = static_cast<double>(at.state[i]);
  return result;
}

/// The published method with its step.
Outcome by_fixed_steps(const Scene& scene, double step) {
  Outcome outcome;
  Scenario scenario = scene.scenario;
  scenario.method = Method::rk4;
  scenario.step_run_up = scenario.step_rub = step;
  Landmarks<double> landmarks(scenario.parameters, scene.touches());
  PublishedMethod method(scenario, landmarks, outcome.work);
  const Instant last = method.rub(rounded(scene.start), scenario.until);
  outcome.state = last.state;
  outcome.touch_downs = landmarks.touch_downs;
  outcome.peak_force = landmarks.peak_force;
  return outcome;
}

/// What one would try first with Odeint: controlled Dormand-Prince steps on the paper's equations,
/// the friction against the slip of the moment. Refuses after `most_steps`.
Outcome by_odeint_off_the_shelf(const Scene& scene, double tolerance) {
  constexpr long most_steps = 2'000'000;
  Outcome outcome;
  Landmarks<double> landmarks(scene.scenario.parameters, scene.touches());
  const Parameters& p = scene.scenario.parameters;
  const Supports<double> supports(p, scene.scenario.equations);
  const Ring<double> ring(p);
  Instant at = rounded(scene.start);
  const double motor_off = boost::math::constants::two_pi<double>() * p.motor_off_Hz;
  const auto system = [&](const State<double>& q, State<double>& rates, double) {
    ++outcome.work.right_hand_sides;
    const auto motion = RotatingFrame<double>::motion(at.body, q);
    auto loads = supports.loads(at.body, motion, at.motor_on && q[5] < motor_off);
    if (!ring.is_clear_of(motion)) {
      const auto k = ring.rim_point(motion);
      const double normal = ring.normal_force(k);
      loads += ring.loads(k, {normal, ring.sliding_friction(normal, k.slip_velocity > 0 ? 1 : -1)});
    }
    rates = RotatingFrame<double>::rates(motion, q, acceleration(at.body, motion, loads));
  };
  auto stepper = odeint::make_controlled<odeint::runge_kutta_dopri5<State<double>>>(
      tolerance * 1e-3, tolerance);  // absolute, relative: lengths are millimetres
  double step = 1e-6;
  while (at.time_s < scene.scenario.until) {
    step = std::min(step, scene.scenario.until - at.time_s);
    if (stepper.try_step(system, at.state, at.time_s, step) == odeint::fail) continue;
    if (++outcome.work.steps > most_steps) throw std::runtime_error("too many steps");
    const auto motion = at.motion();
    at.contact = ring.is_clear_of(motion) ? ContactState::free : ContactState::sliding;
    landmarks.see(at);
  }
  outcome.state = at.state;
  outcome.touch_downs = landmarks.touch_downs;
  outcome.peak_force = landmarks.peak_force;
  return outcome;
}

/// A packaged solver. Makes of a tolerance the solver that has it.
using MakeSolver = std::function<std::unique_ptr<PeerSolver>(double tolerance)>;

Outcome by_peer(const Scene& scene, PeerCoordinates coordinates, PeerSolver& solver) {
  Outcome outcome;
  Landmarks<double> landmarks(scene.scenario.parameters, scene.touches());
  PeerMethod method(scene.scenario, coordinates, solver, landmarks, outcome.work);
  outcome.state = method.rub(rounded(scene.start), scene.scenario.until).state;
  outcome.touch_downs = landmarks.touch_downs;
  outcome.peak_force = std::numeric_limits<double>::quiet_NaN();  // it is shown events alone
  return outcome;
}

struct Peer {
  std::string name;
  PeerCoordinates coordinates;
  MakeSolver make;
};

std::vector<Peer> peers() {
  std::vector<Peer> all;
  [[maybe_unused]] const auto add = [&](const std::string& name, const MakeSolver& make,
                                        bool in_ours_as_well) {
    all.push_back({name, PeerCoordinates::of_the_paper, make});
    if (in_ours_as_well)
      all.push_back({name + " in our coordinates", PeerCoordinates::of_the_phases, make});
  };
#ifdef ROTOR_SUNDIALS
  using Kind = SundialsSolver::Kind;
  const auto sundials = [](Kind kind) {
    return [kind](double tolerance) { return std::make_unique<SundialsSolver>(kind, tolerance); };
  };
  add("CVODE Adams", sundials(Kind::adams), true);
  add("CVODE BDF", sundials(Kind::bdf), false);
  add("ARKODE ERK 5", sundials(Kind::erk5), false);
  add("ARKODE ERK 8", sundials(Kind::erk8), true);
#endif
#ifdef ROTOR_GSL
  add(
      "GSL rk8pd", [](double tolerance) { return std::make_unique<GslSolver>(tolerance); }, true);
#endif
  return all;
}

struct Row {
  std::string scene, method, setting;
  double error_state{}, error_event_s{}, error_peak{}, time_s{}, time_median_s{};
  long right_hand_sides{}, steps{};
  long events{}, contact_evaluations{};
};

/// Of the position in parts of the clearance, of the velocity in parts of clearance times speed, of
/// the speed in parts of itself: the largest.
double state_error(const Scene& scene, const Outcome& a, const Outcome& exact) {
  const double length = Ring<double>(scene.scenario.parameters).clearance;
  const auto& [q1, q2, q3, v1, v2, w] = exact.state;
  return std::max(
      {std::hypot(a.state[0] - q1, a.state[1] - q2) / length,
       std::hypot(a.state[3] - v1, a.state[4] - v2) / (std::hypot(v1, v2) + length * std::abs(w)),
       std::abs(a.state[5] - w) / std::abs(w)});
}

double event_error(const Outcome& a, const Outcome& exact) {
  if (a.touch_downs.size() != exact.touch_downs.size())
    return std::numeric_limits<double>::quiet_NaN();
  double largest = 0;
  for (std::size_t i = 0; i < a.touch_downs.size(); ++i)
    largest = std::max(largest, std::abs(a.touch_downs[i] - exact.touch_downs[i]));
  return largest;
}

double peak_error(const Outcome& a, const Outcome& exact) {
  return exact.peak_force > 0 ? std::abs(a.peak_force / exact.peak_force - 1) : 0;
}

const std::string ours = "event Verner 8(7)", published = "published RK4";

std::string power(int digits) { return fmt::format("1e-{}", digits); }

class Benchmark {
 public:
  using Solve = std::function<Outcome(const Scene&)>;

  explicit Benchmark(double seconds_per_row) : seconds_per_row_(seconds_per_row) {}

  /// A row to be measured in the next run().
  void enter(const std::string& method, const std::string& setting, const Solve& solve) {
    entries_.push_back({method, setting, solve, {}, {}, true});
  }

  /// Measures what has been entered, in turns, so that a slow spell of the machine hits all alike.
  void run(const Scene& scene, const Outcome& exact) {
    constexpr int rounds = 50;
    for (int round = 0; round < rounds; ++round)
      for (Entry& entry : entries_)
        if (entry.works && entry.total_s() < seconds_per_row_) measure(entry, scene);
    for (const Entry& entry : entries_) add(row(entry, scene, exact));
    entries_.clear();
  }

  void add(const Row& row) {
    fmt::print("{:<14} {:<31} {:>6} {:>8.1e} {:>8.1e} {:>8.1e} {:>10.3f} {:>9} {:>8}\n", row.scene,
               row.method, row.setting, row.error_state, row.error_event_s, row.error_peak,
               1e3 * row.time_s, row.right_hand_sides, row.steps);
    std::fflush(stdout);
    rows_.push_back(row);
  }

  std::string csv() const {
    std::string text =
        "# Run time against error; see "
        "verification/benchmark.cpp\nscene,method,setting,error_state,"
        "error_event_s,error_peak,time_s,time_median_s,right_hand_sides,steps,events\n";
    for (const Row& r : rows_)
      text += fmt::format("{},{},{},{:.3e},{:.3e},{:.3e},{:.4e},{:.4e},{},{},{}\n", r.scene,
                          r.method, r.setting, r.error_state, r.error_event_s, r.error_peak,
                          r.time_s, r.time_median_s, r.right_hand_sides, r.steps, r.events);
    return text;
  }

  /// What the scene's reference is off by, as far as another stepper and tolerance can tell.
  void add_reference(const Scene& scene, const Outcome& exact, const Outcome& other) {
    add({.scene = scene.name,
         .method = "reference",
         .setting = "",
         .error_state = std::max(1e-17, state_error(scene, other, exact)),
         .error_event_s = event_error(other, exact),
         .error_peak = peak_error(other, exact)});
  }

  /// Cost against simulated time and against number of contacts: ours at a tolerance of 1e-8.
  void print_costs(const std::vector<Scene>& scenes, const std::vector<Outcome>& exact) const {
    fmt::print("\nWhat a scene costs ({}, tolerance 1e-8)\n", ours);
    fmt::print("{:<14} {:>9} {:>9} {:>9} {:>10} {:>7} {:>12} {:>14}\n", "scene", "time, s",
               "contacts", "rhs", "of contact", "events", "ms of 1 s", "us a contact");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const Scene& scene = scenes[i];
      const auto row = std::ranges::find_if(rows_, [&](const Row& r) {
        return r.scene == scene.name && r.method == ours && r.setting == power(8);
      });
      if (row == rows_.end()) continue;
      const double duration = scene.scenario.until - static_cast<double>(scene.start.time_s);
      const auto contacts = exact[i].touch_downs.size();
      fmt::print("{:<14} {:>9.3f} {:>9} {:>9} {:>10} {:>7} {:>12.2f} {:>14}\n", scene.name,
                 duration, contacts, row->right_hand_sides, row->contact_evaluations, row->events,
                 1e3 * row->time_s / duration,
                 contacts > 0
                     ? fmt::format("{:.0f}", 1e6 * row->time_s / static_cast<double>(contacts))
                     : "-");
    }
  }

  /// How many times longer the others take for the same error of the state.
  void print_ratios() const {
    fmt::print("\nTime at equal error of the state, in units of the event method's\n");
    std::vector<std::pair<std::string, std::string>> curves;
    for (const Row& row : rows_)
      if (row.method != ours && row.method != "reference" &&
          std::ranges::find(curves, std::pair{row.scene, row.method}) == curves.end())
        curves.emplace_back(row.scene, row.method);
    fmt::print("{:<14} {:<31}", "scene", "method");
    for (int digits = 3; digits <= 10; ++digits) fmt::print(" {:>8}", fmt::format("1e-{}", digits));
    fmt::print("\n");
    for (const auto& [scene, method] : curves) {
      fmt::print("{:<14} {:<31}", scene, method);
      for (int digits = 3; digits <= 10; ++digits) {
        const double error = std::pow(10, -digits);
        const double ours_s = time_at(scene, ours, error);
        const double ratio = time_at(scene, method, error) / ours_s;
        const double far_ratio = extrapolated(scene, method, error) / ours_s;
        fmt::print(" {:>8}", !std::isnan(ratio)       ? fmt::format("{:.1f}", ratio)
                             : !std::isnan(far_ratio) ? fmt::format("({:.1e})", far_ratio)
                                                      : "-");
      }
      fmt::print("\n");
    }
    fmt::print("In brackets: extrapolated by the order that the published method shows there.\n");
  }

 private:
  struct Entry {
    std::string method, setting;
    Solve solve;
    std::vector<double> times;
    Outcome outcome;
    bool works;

    double total_s() const { return std::accumulate(times.begin(), times.end(), 0.); }
  };

  static void measure(Entry& entry, const Scene& scene) {
    const auto begin = std::chrono::steady_clock::now();
    try {
      entry.outcome = entry.solve(scene);
    } catch (const std::runtime_error&) {
      entry.works = false;
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    entry.times.push_back(time.count());
  }

  static Row row(const Entry& entry, const Scene& scene, const Outcome& exact) {
    Row row{.scene = scene.name, .method = entry.method, .setting = entry.setting};
    const double none = std::numeric_limits<double>::quiet_NaN();
    row.error_state = row.error_event_s = row.error_peak = row.time_s = row.time_median_s = none;
    if (!entry.works) return row;  // a failed solve is listed
    std::vector<double> times = entry.times;
    std::ranges::sort(times);
    const Outcome& outcome = entry.outcome;
    row.error_state = state_error(scene, outcome, exact);
    row.error_event_s = event_error(outcome, exact);
    row.error_peak = peak_error(outcome, exact);
    row.time_s = times.front();
    row.time_median_s = times[times.size() / 2];
    row.right_hand_sides = outcome.work.right_hand_sides;
    row.steps = outcome.work.steps;
    row.events = outcome.work.located_events;
    row.contact_evaluations = outcome.work.contact_evaluations;
    return row;
  }

  /// The time at which a curve reaches an error, between two of its points in logarithms; not a
  /// number if it never does.
  double time_at(const std::string& scene, const std::string& method, double error) const {
    const Row* above = nullptr;
    for (const Row& row : rows_) {
      if (row.scene != scene || row.method != method || std::isnan(row.error_state)) continue;
      if (row.error_state > error) {
        above = &row;
      } else if (above) {
        const double part =
            std::log(above->error_state / error) / std::log(above->error_state / row.error_state);
        return above->time_s * std::pow(row.time_s / above->time_s, part);
      } else {
        return row.time_s;  // its coarsest setting is better than that
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// The same for the published method beyond its shortest step, by its order between its longest
  /// and its shortest step.
  double extrapolated(const std::string& scene, const std::string& method, double error) const {
    if (method != published) return std::numeric_limits<double>::quiet_NaN();
    std::vector<const Row*> curve;
    for (const Row& row : rows_)
      if (row.scene == scene && row.method == method && row.error_state > 0) curve.push_back(&row);
    if (curve.size() < 2) return std::numeric_limits<double>::quiet_NaN();
    const Row &coarse = *curve.front(), &fine = *curve.back();
    const double order =
        std::log(coarse.error_state / fine.error_state) /
        std::log(static_cast<double>(fine.steps) / static_cast<double>(coarse.steps));
    if (!(order > 0.5 && error < fine.error_state)) return std::numeric_limits<double>::quiet_NaN();
    return fine.time_s * std::pow(fine.error_state / error, 1 / order);
  }

  double seconds_per_row_;
  std::vector<Entry> entries_;
  std::vector<Row> rows_;
};

/// The rotor just after its mass loss.
BasicInstant<Extended> after_mass_loss(const Scenario& scenario) {
  struct : BasicObserver<Extended> {
    using BasicObserver<Extended>::see;
    void see(const BasicInstant<Extended>& at) override {
      if (at.event == Event::mass_loss) found = at;
    }
    BasicInstant<Extended> found;
  } separation;
  Work work;
  Scenario until_separation = scenario;
  until_separation.until = std::nextafter(scenario.parameters.separation_time, 1e9);
  EventMethod<Extended> method(until_separation, 1e-15L, separation, work);
  run_by(method, separation, until_separation,
         BasicInstant<Extended>{.body = Body<Extended>::of(scenario.parameters)});
  return separation.found;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  Scenario run_up;
  run_up.parameters.separates = false;
  run_up.until = 29.1;
  all.push_back({"run-up", run_up,
                 BasicInstant<Extended>{.body = Body<Extended>::of(run_up.parameters)}, true});

  const Scenario high{.until = 29.2};
  all.push_back({"rub mu = 0.3", high, after_mass_loss(high)});
  const Scenario intermediate{.parameters = {.friction = 0.2}};
  all.push_back({"rub mu = 0.2", intermediate, after_mass_loss(intermediate)});
  const Scenario low{.parameters = {.friction = 0.08}};
  all.push_back({"rub mu = 0.08", low, after_mass_loss(low)});
  const Scenario clear{.parameters = {.separation_time = 9.4}, .until = 10.4};
  all.push_back({"no contact", clear, after_mass_loss(clear)});
  Scene impact{"single impact", high, after_mass_loss(high)};
  impact.scenario.until = 29.106;
  all.push_back(impact);

  Scene rolling{"rolling", Scenario{}, {}};
  rolling.scenario.until = 29.15;
  struct : BasicObserver<Extended> {
    using BasicObserver<Extended>::see;
    void see(const BasicInstant<Extended>& at) override { last = at; }
    BasicInstant<Extended> last;
  } end;
  Work work;
  EventMethod<Extended>(rolling.scenario, 1e-15L, end, work).rub(all[1].start, 29.15L);
  rolling.start = end.last;
  rolling.scenario.until = 29.35;
  all.push_back(rolling);
  return all;
}

/// What another process needs to run the scenes.
void write_scenes(const std::vector<Scene>& scenes, const std::vector<Outcome>& exact,
                  const std::filesystem::path& file) {
  nlohmann::json all;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Scene& scene = scenes[i];
    const Instant first = rounded(scene.start);
    nlohmann::json json{{"name", scene.name},
                        {"from_s", first.time_s},
                        {"until_s", scene.scenario.until},
                        {"state", first.state},
                        {"mass", first.body.mass},
                        {"inertia", first.body.inertia},
                        {"eccentricity", first.body.eccentricity},
                        {"motor_on", first.motor_on},
                        {"rolling", first.contact == ContactState::rolling},
                        {"exact_state", exact[i].state},
                        {"exact_touch_downs", exact[i].touch_downs}};
    for (const Quantity& quantity : quantities())
      json["parameters"][std::string(quantity.name)] = quantity.of(scene.scenario);
    all.push_back(json);
  }
  FileTransaction files;
  files.write(file, all.dump(1));
  files.commit();
}

/// Rows as Benchmark::csv writes them.
std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::vector<std::string> cells = cells_of(line);
    const auto number = [&](std::size_t i) { return std::stod(cells.at(i)); };
    const auto count = [&](std::size_t i) { return std::stol(cells.at(i)); };
    const Row row{.scene = cells.at(0),
                  .method = cells.at(1),
                  .setting = cells.at(2),
                  .error_state = number(3),
                  .error_event_s = number(4),
                  .error_peak = number(5),
                  .time_s = number(6),
                  .time_median_s = number(7),
                  .right_hand_sides = count(8),
                  .steps = count(9),
                  .events = count(10)};
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> rows_of_scipy(const std::vector<Scene>& scenes, const std::vector<Outcome>& exact,
                               const std::filesystem::path& folder, const std::string& python,
                               const std::string& script) {
  const auto input = folder / "scenes.json", output = folder / "scipy.csv";
  write_scenes(scenes, exact, input);
  const std::string command =
      fmt::format("'{}' '{}' '{}' '{}'", python, script, input.string(), output.string());
  if (std::system(command.c_str()) != 0) {
    fmt::print("Without SciPy, which make deps-bench installs.\n");
    return {};
  }
  return read_rows(output);
}

void enter_methods(const Scene& scene, Benchmark& benchmark) {
  const auto sweep = [&](const std::string& method, int first, int last, const auto& solve) {
    for (int digits = first; digits <= last; ++digits)
      benchmark.enter(method, power(digits),
                      [=](const Scene& s) { return solve(s, std::pow(10, -digits)); });
  };
  sweep(ours, 3, 12, by_events<double, Verner<double>>);
  sweep("event Fehlberg 7(8)", 4, 11, by_events<double, Fehlberg78<double>>);
  sweep("event Cash-Karp 5(4)", 4, 9, by_events<double, CashKarp54<double>>);
  const double step = scene.is_run_up ? 1e-4 : 5e-6;
  for (const int part : {1, 2, 4, 8, 16})
    benchmark.enter(published, fmt::format("h/{}", part),
                    [=](const Scene& s) { return by_fixed_steps(s, step / part); });
  for (const Peer& peer : peers())
    sweep(peer.name, 4, 11, [=](const Scene& s, double tolerance) {
      const auto solver = peer.make(tolerance);
      return by_peer(s, peer.coordinates, *solver);
    });
  sweep("Odeint off the shelf", 3, 6, by_odeint_off_the_shelf);
}

int main(const Arguments& arguments) {
  if (arguments.size() != 1 && arguments.size() != 3)
    throw std::runtime_error("needs: FOLDER [PYTHON SCRIPT]");
  const std::filesystem::path folder = arguments[0];
  std::filesystem::create_directories(folder);
  const std::vector<Scene> all = scenes();
  std::vector<Outcome> exact;
  for (const Scene& scene : all)
    exact.push_back(by_events<Extended, Fehlberg78<Extended>>(scene, 1e-15L));

  Benchmark benchmark(0.1);
  fmt::print("{:<14} {:<31} {:>6} {:>8} {:>8} {:>8} {:>10} {:>9} {:>8}\n", "scene", "method", "set",
             "state", "event, s", "peak", "time, ms", "rhs", "steps");
  for (std::size_t i = 0; i < all.size(); ++i) {
    benchmark.add_reference(all[i], exact[i],
                            by_events<Extended, Verner<Extended>>(all[i], 1e-16L));
    enter_methods(all[i], benchmark);
    benchmark.run(all[i], exact[i]);
  }
  if (arguments.size() == 3)
    for (const Row& row : rows_of_scipy(all, exact, folder, arguments[1], arguments[2]))
      benchmark.add(row);
  benchmark.print_ratios();
  benchmark.print_costs(all, exact);
  FileTransaction files;
  files.write(folder / "work-precision.csv", benchmark.csv());
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("benchmark", rotor::main, argc, argv); }
