/// Run time against error: each method, over its steps or tolerances, on scenes of the paper.
/// Writes a table and build/bench/work-precision.csv. Times are of this machine; ratios are what
/// counts. The reference is a run in extended precision by another stepper.
#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <chrono>
#include <functional>

#include "figures/csv.hpp"
#include "model/event_method.hpp"
#include "model/published_method.hpp"
#ifdef ROTOR_SUNDIALS
#include "verification/sundials_method.hpp"
#endif

namespace rotor {
namespace {

namespace odeint = boost::numeric::odeint;
using Extended = long double;

template <class S>
using Fehlberg78 =
    odeint::runge_kutta_fehlberg78<std::array<S, 6>, S, std::array<S, 6>, S, odeint::array_algebra>;

/// Where a scene begins, known in extended precision, and where it ends.
struct Scene {
  std::string name;
  Scenario scenario;
  BasicInstant<Extended> start;
  bool is_run_up = false;
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
  explicit Landmarks(const Parameters& p) : ring_(p) {}

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
  bool touching_ = false;
};

template <class S, class Stepper>
Outcome by_events(const Scene& scene, const S& tolerance) {
  Outcome outcome;
  Landmarks<S> landmarks(scene.scenario.parameters);
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
  Landmarks<double> landmarks(scenario.parameters);
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
  Landmarks<double> landmarks(scene.scenario.parameters);
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

#ifdef ROTOR_SUNDIALS
Outcome by_sundials(const Scene& scene, SundialsSolver solver, double tolerance) {
  Outcome outcome;
  Landmarks<double> landmarks(scene.scenario.parameters);
  SundialsMethod method(scene.scenario, solver, tolerance, landmarks, outcome.work);
  outcome.state = method.rub(rounded(scene.start), scene.scenario.until).state;
  outcome.touch_downs = landmarks.touch_downs;
  outcome.peak_force = std::numeric_limits<double>::quiet_NaN();  // it is shown events alone
  return outcome;
}
#endif

struct Row {
  std::string scene, method, setting;
  double error_state{}, error_event_s{}, error_peak{}, time_s{}, time_median_s{};
  long right_hand_sides{}, steps{};
  std::size_t events{};
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

class Benchmark {
 public:
  using Solve = std::function<Outcome(const Scene&)>;

  explicit Benchmark(double seconds_per_row) : seconds_per_row_(seconds_per_row) {}

  void add(const Scene& scene, const Outcome& exact, const std::string& method,
           const std::string& setting, const Solve& solve) {
    Row row{.scene = scene.name, .method = method, .setting = setting};
    try {
      std::vector<double> times;
      Outcome outcome;
      double total = 0;
      while (times.empty() || (total < seconds_per_row_ && times.size() < 200)) {
        const auto begin = std::chrono::steady_clock::now();
        outcome = solve(scene);
        times.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        total += times.back();
      }
      std::ranges::sort(times);
      row.error_state = state_error(scene, outcome, exact);
      row.error_event_s = event_error(outcome, exact);
      row.error_peak =
          exact.peak_force > 0 ? std::abs(outcome.peak_force / exact.peak_force - 1) : 0;
      row.time_s = times.front();
      row.time_median_s = times[times.size() / 2];
      row.right_hand_sides = outcome.work.right_hand_sides;
      row.steps = outcome.work.steps;
      row.events = static_cast<std::size_t>(outcome.work.located_events);
    } catch (const std::runtime_error&) {
      const double none = std::numeric_limits<double>::quiet_NaN();  // a failed solve is listed
      row.error_state = row.error_event_s = row.error_peak = row.time_s = row.time_median_s = none;
    }
    fmt::print("{:<22} {:<22} {:>8} {:>9.1e} {:>9.1e} {:>9.1e} {:>10.3f} {:>9} {:>8}\n", row.scene,
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

  /// How many times longer the others take for the same error of the state.
  void print_ratios() const {
    const std::string ours = "event Verner 8(7)";
    fmt::print("\nTime at equal error of the state, in units of the event method's\n");
    std::vector<std::pair<std::string, std::string>> curves;
    for (const Row& row : rows_)
      if (row.method != ours &&
          std::ranges::find(curves, std::pair{row.scene, row.method}) == curves.end())
        curves.emplace_back(row.scene, row.method);
    fmt::print("{:<22} {:<22}", "scene", "method");
    for (int digits = 3; digits <= 10; ++digits) fmt::print(" {:>8}", fmt::format("1e-{}", digits));
    fmt::print("\n");
    for (const auto& [scene, method] : curves) {
      fmt::print("{:<22} {:<22}", scene, method);
      for (int digits = 3; digits <= 10; ++digits) {
        const double error = std::pow(10, -digits);
        const double ratio = time_at(scene, method, error) / time_at(scene, ours, error);
        fmt::print(" {:>8}", std::isnan(ratio) ? "-" : fmt::format("{:.1f}", ratio));
      }
      fmt::print("\n");
    }
  }

 private:
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

  double seconds_per_row_;
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

std::string power(int digits) { return fmt::format("1e-{}", digits); }

int main(const std::filesystem::path& file) {
  Benchmark benchmark(0.15);
  fmt::print("{:<22} {:<22} {:>8} {:>9} {:>9} {:>9} {:>10} {:>9} {:>8}\n", "scene", "method",
             "setting", "state", "event, s", "peak", "time, ms", "rhs", "steps");
  for (const Scene& scene : scenes()) {
    const Outcome exact = by_events<Extended, Fehlberg78<Extended>>(scene, 1e-15L);
    for (int digits = 3; digits <= 12; ++digits)
      benchmark.add(scene, exact, "event Verner 8(7)", power(digits), [=](const Scene& s) {
        return by_events<double, Verner87<std::array<double, 6>, double>>(s, std::pow(10, -digits));
      });
    for (int digits = 4; digits <= 12; digits += 2)
      benchmark.add(scene, exact, "event Fehlberg 7(8)", power(digits), [=](const Scene& s) {
        return by_events<double, Fehlberg78<double>>(s, std::pow(10, -digits));
      });
    const double published = scene.is_run_up ? 1e-4 : 5e-6;
    for (const int part : {1, 2, 4, 8, 16})
      benchmark.add(scene, exact, "published RK4", fmt::format("h/{}", part),
                    [=](const Scene& s) { return by_fixed_steps(s, published / part); });
#ifdef ROTOR_SUNDIALS
    const std::pair<const char*, SundialsSolver> solvers[] = {
        {"CVODE Adams", SundialsSolver::adams},
        {"CVODE BDF", SundialsSolver::bdf},
        {"ARKODE ERK 5", SundialsSolver::erk5},
        {"ARKODE ERK 8", SundialsSolver::erk8}};
    for (const auto& [name, solver] : solvers)
      for (int digits = 4; digits <= 11; ++digits)
        benchmark.add(scene, exact, name, power(digits), [=, solver = solver](const Scene& s) {
          return by_sundials(s, solver, std::pow(10, -digits));
        });
#endif
    for (int digits = 3; digits <= 8; ++digits)
      benchmark.add(scene, exact, "Odeint off the shelf", power(digits), [=](const Scene& s) {
        return by_odeint_off_the_shelf(s, std::pow(10, -digits));
      });
  }
  benchmark.print_ratios();
  FileTransaction files;
  files.write(file, benchmark.csv());
  files.commit();
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  try {
    return rotor::main(argc > 1 ? argv[1] : "work-precision.csv");
  } catch (const std::exception& error) {
    fmt::print(stderr, "benchmark: {}\n", error.what());
    return 1;
  }
}
