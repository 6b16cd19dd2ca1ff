/// Entries to reference-data/problems by solvers of other libraries: `library-entry SOLVER` prints
/// what score.py reads.
#include <ctime>

#include "figures/data/read_csv.hpp"
#include "figures/runs/scene.hpp"
#include "verification/benchmark/cvode.hpp"
#include "verification/benchmark/peers.hpp"
#include "verification/benchmark/problem_run.hpp"
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

constexpr double tolerance = 1e-14;  // of 1e-11 to 1e-15, it gives most of them most digits

template <class Made>
std::unique_ptr<Solver> make(const Stretch& stretch, const Newton& x) {
  return std::make_unique<Made>(stretch, x, tolerance);
}

int main(const Arguments& arguments) {
  const std::map<std::string, MakeSolver> solvers = {
      {"CVODE", make<Cvode>}, {"GSL", make<Stepping<Gsl>>}, {"Odeint", make<Stepping<Odeint>>}};
  const auto solver = solvers.find(arguments.size() == 1 ? arguments[0] : "");
  if (solver == solvers.end()) throw std::invalid_argument("needs: CVODE, GSL or Odeint");
  fmt::print("problem,quantity,value,seconds,right_hand_sides\n");
  const std::filesystem::path folder = ROTOR_REFERENCE_DATA "/problems";
  struct Timed {
    Solution solution;
    double seconds;
  };
  std::map<std::string, Timed> solved;
  for (const CsvRow& row : read_csv(folder / "answers.csv")) {
    const std::string& problem = row["problem"];
    if (!solved.contains(problem)) {
      const Scenario scenario = read_scene(folder / (problem + ".toml")).runs.at(0).scenario;
      const std::clock_t begin = std::clock();
      const Solution found = solution(scenario, solver->second);
      solved[problem] = {found, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC};
    }
    const auto& [found, seconds] = solved[problem];
    if (const auto value = found.values.find(row["quantity"]); value != found.values.end())
      fmt::print("{},{},{},{:.2g},{}\n", problem, value->first, value->second, seconds,
                 found.right_hand_sides);
  }
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("library-entry", rotor::main, argc, argv);
}
