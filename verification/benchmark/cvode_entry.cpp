/// An entry to reference-data/problems by CVODE of SUNDIALS, with its own location of events.
/// Forces are those of verification/support/newton.hpp. `cvode-entry` prints what score.py reads.
#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <ctime>
#include <functional>
#include <map>

#include "figures/data/read_csv.hpp"
#include "figures/runs/scene.hpp"
#include "model/mechanics/mass_loss.hpp"
#include "verification/support/newton.hpp"
#include "verification/support/program.hpp"

namespace rotor {
namespace {

constexpr double tolerance = 1e-14;

void check(int flag) {
  if (flag < 0) throw std::runtime_error(fmt::format("CVODE gave up with {}", flag));
}

/// A function of the motion, and what follows where it falls through zero.
struct Root {
  std::function<double(const Newton&)> value;
  std::function<void()> follow;
};

/// CVODE from an instant on, with roots of its own: Adams methods, as its manual has it for systems
/// that are not stiff.
class Cvode {
 public:
  using Rates = std::function<Newton(const Newton&)>;

  Cvode(Rates rates, std::vector<Root> guards, const Newton& x, const Newton& unit)
      : rates_(std::move(rates)), guards_(std::move(guards)), now_(x), there_(x), least_(unit) {
    check(SUNContext_Create(0, &context_));
    for (double& least : least_) least *= tolerance / 100;
    for (auto [vector, values] : {std::pair(&vectors_[0], &now_), std::pair(&vectors_[1], &there_),
                                  std::pair(&vectors_[2], &least_)})
      *vector = N_VMake_Serial(6, values->data(), context_);
    solver_ = CVodeCreate(CV_ADAMS, context_);
    iteration_ = SUNNonlinSol_FixedPoint(vectors_[0], 0, context_);
  }
  Cvode(const Cvode&) = delete;
  Cvode& operator=(const Cvode&) = delete;
  ~Cvode() {
    CVodeFree(&solver_);
    SUNNonlinSolFree(iteration_);
    for (const N_Vector vector : vectors_) N_VDestroy(vector);
    SUNContext_Free(&context_);
  }

  void start(double time_s, double until_s, double first_step_s) {
    std::vector<int> falling(guards_.size(), -1);
    check(CVodeInit(solver_, rates_of, time_s, vectors_[0]));
    check(CVodeSetUserData(solver_, this));
    check(CVodeSVtolerances(solver_, tolerance, vectors_[2]));
    check(CVodeSetNonlinearSolver(solver_, iteration_));
    check(CVodeRootInit(solver_, static_cast<int>(guards_.size()), guards_of));
    check(CVodeSetRootDirection(solver_, falling.data()));
    check(CVodeSetNoInactiveRootWarn(solver_));
    check(CVodeSetInitStep(solver_, std::min(first_step_s, until_s - time_s)));
    check(CVodeSetStopTime(solver_, until_s));
    until_s_ = until_s;
  }

  /// Takes a step, or a part that ends at a root. Returns the guard that has fallen, if one has.
  const Root* step(double& time_s) {
    const int flag = CVode(solver_, until_s_, vectors_[0], &time_s, CV_ONE_STEP);
    check(flag);
    if (flag != CV_ROOT_RETURN) return nullptr;
    std::vector<int> which(guards_.size());
    check(CVodeGetRootInfo(solver_, which.data()));
    const auto fallen = std::find_if(which.begin(), which.end(), [](int w) { return w != 0; });
    return &guards_.at(static_cast<std::size_t>(fallen - which.begin()));
  }
  const Newton& now() const { return now_; }
  const Root& first_guard() const { return guards_.front(); }

  /// Within the last step.
  const Newton& at(double time_s) {
    check(CVodeGetDky(solver_, time_s, 0, vectors_[1]));
    return there_;
  }
  bool falls(const Root& root, double from_s, double until_s) {
    return root.value(at(from_s)) > 0 && root.value(at(until_s)) < 0;
  }
  double time_of(const Root& root, double from_s, double until_s) {
    return boost::math::tools::bisect([&](double time_s) { return root.value(at(time_s)); }, from_s,
                                      until_s, boost::math::tools::eps_tolerance<double>(52))
        .second;
  }

 private:
  static Newton& newton(N_Vector x) { return *reinterpret_cast<Newton*>(N_VGetArrayPointer(x)); }
  static int rates_of(double /*time*/, N_Vector x, N_Vector rates, void* self) {
    newton(rates) = static_cast<Cvode*>(self)->rates_(newton(x));
    return 0;
  }
  static int guards_of(double /*time*/, N_Vector x, double* values, void* self) {
    for (const Root& guard : static_cast<Cvode*>(self)->guards_) *values++ = guard.value(newton(x));
    return 0;
  }

  Rates rates_;
  std::vector<Root> guards_;
  Newton now_, there_, least_;
  double until_s_ = 0;
  SUNContext context_{};
  std::array<N_Vector, 3> vectors_{};
  void* solver_ = nullptr;
  SUNNonlinearSolver iteration_{};
};

/// A rotor that loses mass at the start, or never.
class Run {
 public:
  explicit Run(const Scenario& scenario)
      : scenario_(scenario), start_(start_of(scenario)), x_(in_stator_axes(start_.state)) {
    const Parameters& p = scenario.parameters;
    const Body<double> body = p.loses_mass ? MassLoss<double>(p).after : start_.body;
    laws_ = {p, scenario.equations.gravity_moment, body, start_.motor_on};
    clearance_ = p.stator_radius - p.rotor_radius;
  }

  std::map<std::string, double> results() {
    if (gap(x_) < 0) begin_contact();
    while (time_s_ < scenario_.until) advance();
    const State<double> q = in_rotating_axes(x_);
    found_["final_speed_Hz"] = q[5] / two_pi;
    found_["final_q1_m"] = q[0];
    found_["final_q2_m"] = q[1];
    found_["final_displacement_m"] = std::hypot(x_[0], x_[1]);
    return found_;
  }

 private:
  bool touches() const { return rotor::touches(contact_); }
  double gap(const Newton& x) const { return clearance_ - std::hypot(x[0], x[1]); }
  double pressure(const Newton& x) const { return laws_.pressure(laws_.rim(x)); }
  double slip(const Newton& x) const { return laws_.rim(x).slip; }
  /// By which the greatest friction exceeds what holds the rim, N.
  double grip(const Newton& x) const {
    return laws_.parameters.friction * pressure(x) - std::abs(laws_.holding_friction(x));
  }

  Newton rates(const Newton& x) const {
    if (!touches()) return laws_.rates(x, {}, 0, 0);
    const NewtonRim k = laws_.rim(x);
    const double force = laws_.pressure(k);
    return laws_.rates(x, k, force,
                       contact_ == ContactState::rolling
                           ? laws_.holding_friction(x)
                           : -slip_sign_ * laws_.parameters.friction * force);
  }
  double pressure_rate(const Newton& x) const {
    const Parameters& p = laws_.parameters;
    const NewtonRim k = laws_.rim(x);
    const Newton a = rates(x);
    const double along = x[4] * k.nx - x[3] * k.ny, n = p.contact_exponent;
    const double slope =
        n * p.contact_stiffness *
        (n == 1 ? 1 : std::pow(std::max(0., k.indentation) / p.reference_indentation, n - 1));
    return slope * k.rate + p.contact_damping * (a[3] * k.nx + a[4] * k.ny + along * along / k.rho);
  }

  /// Where a quantity is largest, the root of its rate.
  std::vector<Root> maxima() {
    std::vector<Root> all = {
        {[](const Newton& x) { return x[0] * x[3] + x[1] * x[4]; },
         [this] { keep_greatest("peak_displacement_m", clearance_ - gap(x_)); }}};
    if (touches())
      all.push_back(
          {[this](const Newton& x) { return pressure_rate(x); }, [this] { note_pressure(); }});
    return all;
  }

  /// What ends the phase.
  std::vector<Root> guards() {
    const Root clear = {[this](const Newton& x) { return -gap(x); },
                        [this] { contact_ = ContactState::free; }};
    const Root release = {[this](const Newton& x) { return pressure(x); },
                          [this] { contact_ = ContactState::indented; }};
    if (contact_ == ContactState::free)
      return {{[this](const Newton& x) { return gap(x); }, [this] { touch_down(); }}};
    if (contact_ == ContactState::indented)
      return {clear,
              {[this](const Newton& x) { return -pressure(x); }, [this] { begin_contact(); }}};
    std::vector<Root> all = {laws_.parameters.contact_damping > 0 ? release : clear};
    if (contact_ == ContactState::rolling)
      all.push_back({[this](const Newton& x) { return grip(x); }, [this] { slide(); }});
    else if (laws_.parameters.friction > 0)
      all.push_back({[this](const Newton& x) { return slip_sign_ * slip(x); },
                     [this] { leave_zero_slip(); }});
    return all;
  }

  void touch_down() {
    found_[fmt::format("touch_down_{}_s", ++found_["touch_downs"])] = time_s_;
    begin_contact();
  }
  void begin_contact() {
    contact_ = ContactState::sliding;
    slip_sign_ = slip(x_) > 0 ? 1 : -1;
    note_pressure();
    if (slip(x_) == 0 && laws_.parameters.friction > 0) leave_zero_slip();
  }
  void leave_zero_slip() {
    if (grip(x_) < 0) return slide();
    contact_ = ContactState::rolling;
    if (found_.contains("rolling_onset_s")) return;
    found_["rolling_onset_s"] = time_s_;
    found_["rolling_onset_speed_Hz"] = x_[5] / two_pi;
    found_["rolling_onset_force_N"] = pressure(x_);
  }
  void slide() {
    contact_ = ContactState::sliding;
    slip_sign_ = laws_.holding_friction(x_) > 0 ? -1 : 1;
  }
  bool keep_greatest(const std::string& name, double value) {
    const bool is_greatest = value > found_[name];
    if (is_greatest) found_[name] = value;
    return is_greatest;
  }
  void note_pressure() {
    if (keep_greatest("peak_normal_force_N", pressure(x_))) found_["peak_time_s"] = time_s_;
  }

  void go(const Newton& x, double time_s) {
    x_ = x;
    time_s_ = time_s;
  }

  /// To the end of the phase, or of the run.
  void advance() {
    const Parameters& p = laws_.parameters;
    const double speed = std::max(std::abs(x_[5]), std::sqrt(p.support_stiffness / p.mass)) + 1;
    const Newton unit = {clearance_, clearance_, 1, clearance_ * speed, clearance_ * speed, speed};
    Cvode solver([this](const Newton& x) { return rates(x); }, guards(), x_, unit);
    // The first step leaves the zero of the guard that has just been passed.
    solver.start(time_s_, scenario_.until, 1e-3 * std::sqrt(p.mass / p.contact_stiffness));
    const double begin_s = time_s_;
    const bool touched = touches();
    const std::vector<Root> all_maxima = maxima();
    const Root* passed = nullptr;
    while (!passed && time_s_ < scenario_.until) {
      const double from_s = time_s_;
      double until_s = from_s;
      passed = solver.step(until_s);
      const Newton now = solver.now();
      bool grazes = false;
      for (const Root& maximum : all_maxima) {
        if (!solver.falls(maximum, from_s, until_s)) continue;
        const double top_s = solver.time_of(maximum, from_s, until_s);
        if (!touched && solver.falls(solver.first_guard(), from_s, top_s)) {
          // The step has passed over a graze.
          grazes = true;
          passed = &solver.first_guard();
          until_s = solver.time_of(*passed, from_s, top_s);
        } else {
          go(solver.at(top_s), top_s);
          maximum.follow();
        }
      }
      go(grazes ? solver.at(until_s) : now, until_s);
    }
    if (touched) found_["contact_time_s"] += time_s_ - begin_s;
    keep_greatest("peak_displacement_m", clearance_ - gap(x_));
    if (passed) passed->follow();
  }

  const Scenario& scenario_;
  Instant start_;
  Newton x_;
  NewtonLaws laws_;
  double clearance_ = 0, time_s_ = 0;
  ContactState contact_ = ContactState::free;
  int slip_sign_ = 0;
  std::map<std::string, double> found_ = {{"touch_downs", 0}};
};

int main(const Arguments& /*arguments*/) {
  fmt::print("problem,quantity,value,seconds\n");
  const std::filesystem::path folder = ROTOR_REFERENCE_DATA "/problems";
  struct Solved {
    std::map<std::string, double> values;
    double seconds;
  };
  std::map<std::string, Solved> solved;
  for (const CsvRow& row : read_csv(folder / "answers.csv")) {
    const std::string& problem = row["problem"];
    if (!solved.contains(problem)) {
      const Scenario scenario = read_scene(folder / (problem + ".toml")).runs.at(0).scenario;
      const std::clock_t begin = std::clock();
      const auto values = Run(scenario).results();
      solved[problem] = {values, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC};
    }
    const auto& [values, seconds] = solved[problem];
    if (const auto value = values.find(row["quantity"]); value != values.end())
      fmt::print("{},{},{},{:.2g}\n", problem, value->first, value->second, seconds);
  }
  return 0;
}

}  // namespace
}  // namespace rotor

int main(int argc, char** argv) {
  return rotor::run_program("cvode-entry", rotor::main, argc, argv);
}
