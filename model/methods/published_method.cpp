#include "model/methods/published_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <stdexcept>

namespace rotor {
namespace {

[[noreturn]] void fail(double time_s, double step, const std::string& fault) {
  throw std::runtime_error(
      fmt::format("the rk4 run diverged at t = {:.6f} s: {}; its step of {} s is too long for this "
                  "rotor: lower step_run_up or step_rub",
                  time_s, fault, step));
}

/// A remainder within this share of a step is a whole step, or none.
constexpr double whole_step = 1e-6;

}  // namespace

PublishedMethod::PublishedMethod(const Scenario& scenario, const Instant& from)
    : scenario_(scenario),
      rotor_(scenario.parameters, scenario.equations),
      check_(RunCheck<double>::fixed_steps) {
  restart(from);
}

void PublishedMethod::restart(const Instant& from) {
  at_ = from;
  at_.event = Event::none;  // fixed steps locate none
  at_.slip_sign = 0;        // and have no phases
  rotor_.body = at_.body;
  rotor_.motor_on = at_.motor_on;
  check_.begin(rotor_, at_);
  origin_s_ = at_.time_s;
  steps_ = 0;
  whirl_angle_ = at_.contact == ContactState::free ? 0 : RotatingFrame<double>::angle(at_.state);
}

void PublishedMethod::set_step(double step) {
  if (step == step_) return;
  step_ = step;
  origin_s_ = at_.time_s;
  steps_ = 0;
}

void PublishedMethod::run_up(double until_s, Observer& observer) {
  set_step(scenario_.step_run_up);
  while (!stopped_ && step_end_s() <= until_s + whole_step * step_)
    if (!take_step(step_, step_end_s(), false, observer)) break;
}

void PublishedMethod::advance(double until_s, Observer& observer) {
  set_step(scenario_.step_rub);
  while (!stopped_ && step_end_s() < until_s - whole_step * step_)
    take_step(step_, step_end_s(), true, observer);
  if (stopped_) return;
  const double left = (until_s - at_.time_s) / step_;
  if (left > whole_step)
    take_step(left > 1 - whole_step ? step_ : left * step_, until_s, true, observer);
  at_.time_s = until_s;
  check_run(at_.touches());
}

void PublishedMethod::check_run(bool touches) {
  if (const auto fault = check_.fault(rotor_, at_, touches)) fail(at_.time_s, step_, *fault);
  check_.begin(rotor_, at_);
}

/// Eqs. (3)-(4) with the contact of Eqs. (15)-(25), friction against the slip of this very stage.
/// Flattened, because gcc would call the contact's short functions.
[[gnu::flatten]] void PublishedMethod::compute_rates(const State<double>& q, State<double>& rates) {
  ++counters_.right_hand_sides;
  const auto motion = RotatingFrame<double>::motion(at_.body, q);
  Loads<double> loads = rotor_.loads(motion);
  if (!rotor_.ring.is_clear_of(motion)) {
    ++counters_.contact_evaluations;
    const auto k = rotor_.ring.rim_point(motion);
    const double normal = rotor_.ring.normal_force(k);
    const int slip_sign = k.slip_velocity > 0 ? 1 : -1;  // Eq. (23)
    loads += rotor_.ring.loads(k, {normal, rotor_.ring.sliding_friction(normal, slip_sign)});
  }
  rates = RotatingFrame<double>::rates(motion, q, acceleration(at_.body, motion, loads));
}

/// Returns whether the step was taken: one that touches the ring only if it `may_touch`.
bool PublishedMethod::take_step(double length, double end_s, bool may_touch, Observer& observer) {
  boost::numeric::odeint::runge_kutta4<State<double>> stepper;
  const Counters before = counters_;
  State<double> state = at_.state;
  const auto rates_of = [this](const State<double>& q, State<double>& rates, double /*time*/) {
    compute_rates(q, rates);
  };
  stepper.do_step(rates_of, state, at_.time_s, length);
  ++counters_.steps;
  if (!std::all_of(state.begin(), state.end(), [](double q) { return std::isfinite(q); }))
    fail(end_s, length, "the motion is not finite");
  const ContactState contact = contact_state(state, length);
  const bool touched = counters_.contact_evaluations > before.contact_evaluations;
  if (touched && !may_touch) {
    counters_ = before;  // advance() takes this step
    return false;
  }

  const bool begins = at_.contact == ContactState::free;
  if (touches(contact) != at_.touches()) check_run(touches(contact));
  check_.add_step(length, at_.state[5], state[5]);
  ++steps_;
  at_.time_s = end_s;
  at_.state = state;
  at_.contact = contact;
  if (rotor_.motor_guard(state[5]) <= 0) {
    check_run(at_.touches());
    rotor_.motor_on = at_.motor_on = false;
  }
  observer.on_instant(at_);
  if (contact == ContactState::free)
    whirl_angle_ = 0;
  else if (const double angle = RotatingFrame<double>::angle(state); begins)
    whirl_angle_ = angle;
  else
    whirl_angle_ += std::remainder(angle - whirl_angle_, two_pi);
  stopped_ = !observer.should_continue({at_.time_s, at_.state[5], whirl_angle_});
  return true;
}

/// The method has no state of rolling: friction makes the slip jump to and fro about zero. The rim
/// counts as rolling while friction can stop it within one step.
ContactState PublishedMethod::contact_state(const State<double>& state, double step) {
  const auto motion = RotatingFrame<double>::motion(at_.body, state);
  if (rotor_.ring.is_clear_of(motion)) return ContactState::free;
  ++counters_.contact_evaluations;
  const auto k = rotor_.ring.rim_point(motion);
  const double normal = rotor_.ring.normal_force(k);
  if (normal == 0) return ContactState::indented;
  const double slip_change = rotor_.ring.friction * -normal * step *
                             slip_mobility<double>(at_.body, rotor_.ring.friction_arm(motion, k));
  return std::abs(k.slip_velocity) < slip_change ? ContactState::rolling : ContactState::sliding;
}

}  // namespace rotor
