#include "model/published_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace rotor {
namespace {

/// Eqs. (3)-(4) with the contact of Eqs. (15)-(25), friction against the slip of this very stage.
class RightHandSide {
 public:
  RightHandSide(const Body<double>& body, const Supports<double>& supports,
                const Ring<double>& ring, bool motor_on, Work& work)
      : body_(body), supports_(supports), ring_(ring), motor_on_(motor_on), work_(work) {}

  void operator()(const State<double>& q, State<double>& rates, double /*time*/) const {
    ++work_.right_hand_sides;
    const auto motion = RotatingFrame<double>::motion(body_, q);
    Loads<double> loads = supports_.loads(body_, motion, motor_on_);
    if (!ring_.is_clear_of(motion)) loads += contact(motion);
    rates = RotatingFrame<double>::rates(motion, q, acceleration(body_, motion, loads));
  }

 private:
  Loads<double> contact(const Motion<double>& motion) const {
    ++work_.contact_evaluations;
    const auto k = ring_.rim_point(motion);
    const double normal = ring_.normal_force(k);
    const int direction = k.slip_velocity > 0 ? 1 : -1;  // Eq. (23)
    return ring_.loads(k, {normal, ring_.sliding_friction(normal, direction)});
  }

  const Body<double>& body_;
  const Supports<double>& supports_;
  const Ring<double>& ring_;
  bool motor_on_;
  Work& work_;
};

void require_finite(const State<double>& state, double time_s, double step) {
  for (const double component : state)
    if (!std::isfinite(component))
      throw std::runtime_error(
          fmt::format("the rk4 run diverged at t = {:.6f} s; its step of {} s is too long for this "
                      "rotor: lower step_run_up or step_rub",
                      time_s, step));
}

}  // namespace

PublishedMethod::PublishedMethod(const Scenario& scenario, Observer& observer, Work& work)
    : scenario_(scenario),
      observer_(observer),
      work_(work),
      supports_(scenario.parameters, scenario.equations),
      ring_(scenario.parameters) {}

Instant PublishedMethod::run_up(Instant from, double until_s) {
  return advance(from, until_s, scenario_.step_run_up, Extent::whole_steps);
}

Instant PublishedMethod::rub(Instant from, double until_s) {
  return advance(from, until_s, scenario_.step_rub, Extent::everything);
}

Instant PublishedMethod::advance(Instant at, double until_s, double step, Extent extent) {
  boost::numeric::odeint::runge_kutta4<State<double>> stepper;
  at.event = Event::none;  // fixed steps locate none
  const double motor_off = 2 * std::numbers::pi * scenario_.parameters.motor_off_Hz;
  const double start = at.time_s;
  // The last step is shortened to end at until_s. A remainder that differs from a step by rounding
  // alone is a whole step, so that no result depends on where a run was interrupted.
  const double rounding = 1e-6;
  const double length = (until_s - at.time_s) / step;
  const auto whole_steps = static_cast<long>(std::floor(length + rounding));
  const double remainder = std::max(0., length - static_cast<double>(whole_steps));
  const bool shortened = extent == Extent::everything && remainder > rounding;
  const long steps = whole_steps + (shortened ? 1 : 0);

  for (long n = 1; n <= steps; ++n) {
    const bool arrives = n == steps && (shortened || remainder <= rounding);
    const double time = arrives ? until_s : start + static_cast<double>(n) * step;
    const double h = n <= whole_steps ? step : remainder * step;
    const long contacts_before = work_.contact_evaluations;
    State<double> state = at.state;
    stepper.do_step(RightHandSide(at.body, supports_, ring_, at.motor_on, work_), state, at.time_s,
                    h);
    ++work_.steps;
    require_finite(state, time, step);
    const ContactState contact = contact_state(at.body, state, h);
    const bool touched = work_.contact_evaluations > contacts_before;
    if (touched && extent == Extent::whole_steps) break;

    at.time_s = time;
    at.state = state;
    at.contact = contact;
    if (state[5] >= motor_off) at.motor_on = false;
    observer_.see(at);
  }
  return at;
}

/// The method has no state of rolling: friction throws the slip to and fro about zero. The rim
/// counts as rolling while friction is able to stop it within one step.
ContactState PublishedMethod::contact_state(const Body<double>& body, const State<double>& state,
                                            double step) const {
  const auto motion = RotatingFrame<double>::motion(body, state);
  if (ring_.is_clear_of(motion)) return ContactState::free;
  ++work_.contact_evaluations;
  const auto k = ring_.rim_point(motion);
  const double normal = ring_.normal_force(k);
  if (normal == 0) return ContactState::indented;
  const auto mobility = friction_mobility(body, motion, k, ring_.rotor_radius);
  const double slip_change =
      ring_.friction * -normal * step * slip_mobility(motion, k, mobility, ring_.rotor_radius);
  return std::abs(k.slip_velocity) <= slip_change ? ContactState::rolling : ContactState::sliding;
}

}  // namespace rotor
