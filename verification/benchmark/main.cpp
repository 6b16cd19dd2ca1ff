/// Run time against error: each method, over its steps or tolerances, on scenes of the paper.
/// `benchmark FOLDER` prints tables and writes FOLDER/work-precision.csv. Only ratios of times are
/// comparable between machines. The reference is a run in extended precision by another stepper.
#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <map>

#include "model/integration/fehlberg.hpp"
#include "model/methods/event_method.hpp"
#include "model/methods/published_method.hpp"
#include "verification/benchmark/peer_method.hpp"
#include "verification/support/follow_with.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

using Extended = long double;

/// A scene of the paper, from a state known in extended precision.
struct Problem {
  std::string name;
  Scenario scenario;
  BasicInstant<Extended> start;
};

template <class S, class Stepper>
BasicRunEnd<S> by_events(const Problem& problem, const S& tolerance, const BasicInstant<S>& start) {
  BasicObserver<S> null_observer;
  return follow_with<S, Stepper>(problem.scenario, tolerance, start, problem.scenario.until,
                                 null_observer);
}

/// The run-up, with the motor on to its end and switched off before, the rubs at three frictions,
/// flight without contact, a single impact, and rolling. A method without events errs where the
/// motor is switched off and where contacts begin and end; in the scenes without any of this its
/// errors are those of truncation.
std::vector<Problem> problems() {
  Scenario run_up{.equations = Equations::published, .until = 29.1};
  run_up.parameters.loses_mass = false;
  run_up.step_rub = run_up.step_run_up;
  std::vector<Problem> all{
      {"run-up with switch-off", run_up, at_rest<Extended>(run_up.parameters)}};
  run_up.parameters.motor_off_Hz = 1000;
  all.push_back({"run-up", run_up, all.front().start});
  const auto after_loss = [&](const char* name, Scenario scenario) {
    scenario.equations = Equations::published;
    all.push_back({name, scenario, after_mass_loss_with<Extended>(scenario, 1e-15L)});
  };
  after_loss("rub mu = 0.3", {.until = 29.2});
  after_loss("rub mu = 0.2", {.parameters = {.friction = 0.2}});
  after_loss("rub mu = 0.08", {.parameters = {.friction = 0.08}});
  after_loss("no contact", {.parameters = {.mass_loss_time = 9.4}, .until = 10.4});
  after_loss("single impact", {.until = 29.106});
  after_loss("rolling", {.until = 29.15});
  Problem& rolling = all.back();
  rolling.start =
      by_events<Extended, Verner87<State<Extended>, Extended>>(rolling, 1e-15L, rolling.start).last;
  rolling.scenario.until = 29.35;
  return all;
}

/// An instant rounded to double precision.
Instant rounded(const BasicInstant<Extended>& at) {
  Instant result{.time_s = static_cast<double>(at.time_s),
                 .body = {static_cast<double>(at.body.mass), static_cast<double>(at.body.inertia),
                          static_cast<double>(at.body.eccentricity)},
                 .motor_on = at.motor_on,
                 .mass_lost = at.mass_lost,
                 .contact = at.contact};
  std::ranges::transform(at.state, result.state.begin(),
                         [](Extended x) { return static_cast<double>(x); });
  return result;
}

/// The largest error of the position relative to the clearance, of the velocity relative to itself
/// and clearance times speed, and of the speed relative to itself.
double state_error(const Problem& problem, const State<double>& a, const State<double>& exact) {
  const double length = Ring<double>(problem.scenario.parameters).clearance;
  const auto& [q1, q2, q3, v1, v2, w] = exact;
  return std::max({std::hypot(a[0] - q1, a[1] - q2) / length,
                   std::hypot(a[3] - v1, a[4] - v2) / (std::hypot(v1, v2) + length * std::abs(w)),
                   std::abs(a[5] - w) / std::abs(w)});
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Processor time of this program, which the load of the machine hardly affects.
double processor_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One setting of a method. NaN: failed.
struct Point {
  std::string setting;
  std::function<RunEnd()> solve;
  RunEnd end{};
  double error = none, time_s = std::numeric_limits<double>::infinity();

  /// Returns the time that it took, s.
  double measure(const Problem& problem, const State<double>& exact) {
    const double begin_s = processor_s();
    try {
      end = solve();
      error = state_error(problem, end.last.state, exact);
    } catch (const std::runtime_error&) {
    }
    const double spent_s = processor_s() - begin_s;
    time_s = std::min(time_s, spent_s);
    return spent_s;
  }
};

struct Curve {
  std::string method;
  std::vector<Point> points;

  /// The run time at which it reaches an error, interpolated logarithmically; NaN if its settings
  /// are all worse or all better.
  double time_at(double wanted) const {
    const Point* above = nullptr;
    for (const Point& point : points) {
      if (std::isnan(point.error)) continue;
      if (point.error > wanted) {
        above = &point;
      } else if (above) {
        const double part = std::log(above->error / wanted) / std::log(above->error / point.error);
        return above->time_s * std::pow(point.time_s / above->time_s, part);
      } else {
        return none;
      }
    }
    return none;
  }
};

std::string power_of_ten(int minus_exponent) { return fmt::format("1e-{}", minus_exponent); }

/// The methods to compare; the event method is the first.
std::vector<Curve> curves(const Problem& problem) {
  std::vector<Curve> all;
  const Instant start = rounded(problem.start);
  const auto add = [&](const char* method, int first, int last, const auto& solve) {
    all.push_back({method, {}});
    for (int digits = first; digits <= last; ++digits)
      all.back().points.push_back(
          {power_of_ten(digits), [=] { return solve(std::pow(10, -digits)); }});
  };
  add("event Verner 8(7)", 3, 12, [=, &problem](double tolerance) {
    return by_events<double, Verner87<State<double>, double>>(problem, tolerance, start);
  });
  all.push_back({"published RK4", {}});
  for (const auto& [step, length] :
       {std::pair("16h", 16.), {"4h", 4.}, {"h", 1.}, {"h/4", 1. / 4}, {"h/16", 1. / 16}})
    all.back().points.push_back({step, [=, &problem, factor = length] {
                                   Scenario scenario = problem.scenario;
                                   scenario.step_rub *= factor;
                                   Observer null_observer;
                                   PublishedMethod method(scenario, start);
                                   method.advance(scenario.until, null_observer);
                                   return RunEnd{method.instant(), method.counters()};
                                 }});
  const auto add_peer = [&]<class Peer>(const char* method, std::type_identity<Peer>) {
    add(method, 4, 11, [=, &problem](double tolerance) {
      return Peer(problem.scenario, tolerance, start).run(problem.scenario.until);
    });
  };
  add_peer("GSL rk8pd", std::type_identity<PeerMethod<Gsl, PaperChart, PaperChart>>());
  add_peer("GSL rk8pd in our coordinates",
           std::type_identity<PeerMethod<Gsl, FlightChart<double>, ContactChart<double>>>());
  add_peer("Odeint Fehlberg 7(8)",
           std::type_identity<PeerMethod<Odeint, PaperChart, PaperChart>>());
  return all;
}

/// Measures each point for a time or a number of rounds, in turns, so that a slow period of the
/// machine affects all equally.
void measure(std::vector<Curve>& all, const Problem& problem, const State<double>& exact) {
  constexpr double seconds = 0.1;
  constexpr int rounds = 50;
  std::map<const Point*, double> spent_s;
  for (int round = 0; round < rounds; ++round)
    for (Curve& curve : all)
      for (Point& point : curve.points)
        if (double& spent = spent_s[&point]; spent < seconds)
          spent += point.measure(problem, exact);
}

/// Run times of the others relative to the first at the same error, without extrapolation.
void print_ratios(const std::vector<Curve>& all) {
  constexpr int first = 1, last = 10;
  fmt::print("{:<31}", "time at equal error, relative");
  for (int digits = first; digits <= last; ++digits) fmt::print(" {:>7}", power_of_ten(digits));
  for (std::size_t i = 1; i < all.size(); ++i) {
    fmt::print("\n{:<31}", all[i].method);
    for (int digits = first; digits <= last; ++digits) {
      const double error = std::pow(10, -digits),
                   ratio = all[i].time_at(error) / all.front().time_at(error);
      fmt::print(" {:>7}", std::isnan(ratio) ? "-" : fmt::format("{:.1f}", ratio));
    }
  }
  fmt::print("\n- : the settings of this or of the event method are all worse, or all better.\n");
}

int main(const Arguments& arguments) {
  if (arguments.size() != 1) throw std::runtime_error("needs: FOLDER");
  const std::filesystem::path folder = arguments[0];
  std::filesystem::create_directories(folder);
  std::string csv =
      "# Run time against error, from make bench\n"
      "problem,method,setting,error_state,time_s,right_hand_sides\n";
  for (const Problem& problem : problems()) {
    const State<double> exact = rounded(by_events<Extended, Fehlberg78<State<Extended>, Extended>>(
                                            problem, 1e-15L, problem.start)
                                            .last)
                                    .state;
    // The error of the reference, estimated by another stepper and tolerance.
    const Instant other = rounded(
        by_events<Extended, Verner87<State<Extended>, Extended>>(problem, 1e-16L, problem.start)
            .last);
    csv += fmt::format("{},reference,,{:.3e},nan,0\n", problem.name,
                       std::max(1e-17, state_error(problem, other.state, exact)));
    std::vector<Curve> all = curves(problem);
    measure(all, problem, exact);
    fmt::print("\n{:<31} {:>6} {:>8} {:>10} {:>9}\n", problem.name, "set", "state", "time, ms",
               "rhs");
    for (const Curve& curve : all)
      for (const Point& p : curve.points) {
        fmt::print("{:<31} {:>6} {:>8.1e} {:>10.3f} {:>9}\n", curve.method, p.setting, p.error,
                   1e3 * p.time_s, p.end.counters.right_hand_sides);
        csv += fmt::format("{},{},{},{:.3e},{:.4e},{}\n", problem.name, curve.method, p.setting,
                           p.error, p.time_s, p.end.counters.right_hand_sides);
      }
    print_ratios(all);
    std::fflush(stdout);
  }
  write_file(folder / "work-precision.csv", csv);
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("benchmark", rotor::main, argc, argv); }
