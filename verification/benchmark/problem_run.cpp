#include "verification/benchmark/problem_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/mechanics/mass_loss.hpp"

namespace rotor {
namespace {

/// Forces are those of verification/support/newton.hpp. The rotor loses mass at the start, or
/// never.
class Run {
 public:
  Run(const Scenario& scenario, const MakeSolver& make_solver)
      : scenario_(scenario),
        make_solver_(make_solver),
        start_(start_of(scenario)),
        x_(in_stator_axes(start_.state)) {
    const Parameters& p = scenario.parameters;
    if (scenario.loses_mass() && p.mass_loss_time != 0)
      throw std::invalid_argument("mass_loss_time: must be 0 in a problem");
    const Body<double> body = p.loses_mass ? MassLoss<double>(p).after : start_.body;
    laws_ = {p, scenario.equations.gravity_moment, body, start_.motor_on};
    clearance_ = p.stator_radius - p.rotor_radius;
  }

  Solution solve() {
    if (gap(x_) < 0) begin_contact();
    while (time_s_ < scenario_.until) advance();
    const State<double> q = in_rotating_axes(x_);
    found_["final_speed_Hz"] = q[5] / two_pi;
    found_["final_q1_m"] = q[0];
    found_["final_q2_m"] = q[1];
    found_["final_displacement_m"] = std::hypot(x_[0], x_[1]);
    return {found_, right_hand_sides_};
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

  std::vector<Root> guards() {
    std::vector<Root> all = ends_of_contact_state();
    if (laws_.motor_on)
      all.push_back(
          {[this](const Newton& x) { return two_pi * laws_.parameters.motor_off_Hz - x[5]; },
           [this] { laws_.motor_on = false; }});
    return all;
  }
  std::vector<Root> ends_of_contact_state() {
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

  /// To the next event, or to the end of the run.
  void advance() {
    const Parameters& p = laws_.parameters;
    const double speed = std::max(std::abs(x_[5]), std::sqrt(p.support_stiffness / p.mass)) + 1;
    const Stretch stretch{
        .rates =
            [this](const Newton& x) {
              ++right_hand_sides_;
              return rates(x);
            },
        .guards = guards(),
        .unit = {clearance_, clearance_, 1, clearance_ * speed, clearance_ * speed, speed},
        .first_step_s = 1e-3 * std::sqrt(p.mass / p.contact_stiffness),
        .begin_s = time_s_,
        .until_s = scenario_.until};
    const auto solver = make_solver_(stretch, x_);
    const bool touched = touches();
    const std::vector<Root> all_maxima = maxima();
    const Root* passed = nullptr;
    while (!passed && time_s_ < scenario_.until) {
      const double from_s = time_s_;
      double until_s = from_s;
      Newton end = x_;
      passed = solver->step(until_s, end);
      for (const Root& maximum : all_maxima) {
        const auto top_s = solver->time_of_fall(maximum, from_s, until_s);
        if (!top_s) continue;
        const Root& guard = stretch.guards.front();
        if (const auto fall_s =
                touched ? std::nullopt : solver->time_of_fall(guard, from_s, *top_s)) {
          // The step has passed over a graze.
          passed = &guard;
          until_s = *fall_s;
          end = solver->at(until_s);
        } else {
          go(solver->at(*top_s), *top_s);
          maximum.follow();
        }
      }
      go(end, until_s);
    }
    if (touched) found_["contact_time_s"] += time_s_ - stretch.begin_s;
    keep_greatest("peak_displacement_m", clearance_ - gap(x_));
    if (passed) passed->follow();
  }

  const Scenario& scenario_;
  const MakeSolver& make_solver_;
  Instant start_;
  Newton x_;
  NewtonLaws laws_;
  double clearance_ = 0, time_s_ = 0;
  ContactState contact_ = ContactState::free;
  int slip_sign_ = 0;
  long right_hand_sides_ = 0;
  std::map<std::string, double> found_ = {{"touch_downs", 0}};
};

}  // namespace

Solution solution(const Scenario& scenario, const MakeSolver& make_solver) {
  return Run(scenario, make_solver).solve();
}

}  // namespace rotor
