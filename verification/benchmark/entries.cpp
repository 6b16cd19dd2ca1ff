/// Entries to reference-data/problems by the engine and by other libraries: `entries FOLDER` writes
/// FOLDER/SOLVER.csv, which score.py reads.
#include <ctime>
#include <limits>

#include "figures/data/read_csv.hpp"
#include "figures/runs/scene.hpp"
#include "verification/benchmark/cvode.hpp"
#include "verification/benchmark/peers.hpp"
#include "verification/benchmark/problem_run.hpp"
#include "verification/support/problem_observer.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

struct Rates {
  const Stretch& stretch;
  void operator()(const Newton& x, Newton& rates, double /*time*/) const {
    rates = stretch.rates(x);
  }
};

/// A library without events: the guards are evaluated after each step, and a root is found by
/// repeating the step.
template <template <class> class Library>
class Stepping : public Solver {
 public:
  Stepping(const Stretch& stretch, const Newton& x, double tolerance)
      : stretch_(stretch),
        from_(x),
        now_(x),
        now_s_(stretch.begin_s),
        library_({stretch}, stretch.unit, tolerance, stretch.first_step_s) {}

  const Root* step(double& time_s, Newton& x) override {
    from_ = now_;
    from_s_ = now_s_;
    library_.step(now_, now_s_, stretch_.until_s);
    const Root* first = nullptr;
    time_s = now_s_;
    for (const Root& guard : stretch_.guards)
      if (const auto fall_s = time_of_fall(guard, from_s_, time_s)) {
        first = &guard;
        time_s = *fall_s;
      }
    x = at(time_s);
    return first;
  }
  Newton at(double time_s) override {
    if (time_s == from_s_) return from_;
    if (time_s == now_s_) return now_;
    Newton x = from_;
    library_.step_by(x, time_s - from_s_);
    return x;
  }
  double after_root(const std::function<double(double)>& f, double at_0, double at_1) override {
    return Library<Rates>::after_root(f, at_0, at_1);
  }

 private:
  const Stretch& stretch_;
  Newton from_, now_;
  double from_s_ = 0, now_s_;
  Library<Rates> library_;
};

/// A problem by one solver.
using Solve = std::function<Solution(const Scenario&)>;

Solve by_engine(Method method, double tolerance = Scenario{}.tolerance) {
  return [=](Scenario scenario) {
    scenario.method = method;
    scenario.tolerance = tolerance;
    ProblemObserver observer(scenario);
    const RunEnd end = run(scenario, observer);
    return Solution{observer.values(), end.counters.right_hand_sides};
  };
}

constexpr double least_tolerance = 1e-14;  // of 1e-11 to 1e-15, most digits in most problems

template <class Made>
Solution by(const Scenario& scenario) {
  return solution(scenario, [](const Stretch& stretch, const Newton& x) {
    return std::make_unique<Made>(stretch, x, least_tolerance);
  });
}

const std::map<std::string, Solve> solvers = {{"event 1e-6", by_engine(Method::event, 1e-6)},
                                              {"event 1e-9", by_engine(Method::event, 1e-9)},
                                              {"event 1e-12", by_engine(Method::event, 1e-12)},
                                              {"published RK4", by_engine(Method::rk4)},
                                              {"CVODE", by<Cvode>},
                                              {"GSL", by<Stepping<Gsl>>},
                                              {"Odeint", by<Stepping<Odeint>>}};

struct Timed {
  Solution solution;
  double seconds;
};

/// With the least processor time of the runs within a tenth of a second.
Timed timed(const Solve& solve, const Scenario& scenario) {
  Timed result{{}, std::numeric_limits<double>::infinity()};
  for (double spent = 0; spent < 0.1;) {
    const std::clock_t begin = std::clock();
    result.solution = solve(scenario);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    result.seconds = std::min(result.seconds, seconds);
    spent += seconds;
  }
  return result;
}

int main(const Arguments& arguments) {
  if (arguments.size() != 1) throw std::invalid_argument("needs: FOLDER");
  std::map<std::string, std::vector<std::string>> asked;
  const std::filesystem::path problems = ROTOR_REFERENCE_DATA "/problems";
  for (const CsvRow& row : read_csv(problems / "answers.csv"))
    asked[row["problem"]].push_back(row["quantity"]);
  for (const auto& [name, solve] : solvers) {
    std::string csv = "problem,quantity,value,seconds,right_hand_sides\n";
    for (const auto& [problem, quantities] : asked) {
      const Scenario scenario = read_scene(problems / (problem + ".toml")).runs.at(0).scenario;
      const Timed run = timed(solve, scenario);
      for (const std::string& quantity : quantities)
        if (const auto value = run.solution.values.find(quantity);
            value != run.solution.values.end())
          csv += fmt::format("{},{},{},{:.2g},{}\n", problem, quantity, value->second, run.seconds,
                             run.solution.right_hand_sides);
    }
    write_file(std::filesystem::path(arguments[0]) / (name + ".csv"), csv);
  }
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) { return rotor::run_program("entries", rotor::main, argc, argv); }
