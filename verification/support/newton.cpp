#include "verification/support/newton.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "verification/support/contact_formulas.hpp"
#include "verification/support/place_of_loss.hpp"

namespace rotor {

Newton in_stator_axes(const State<double>& q) {
  const double c = std::cos(q[2]), s = std::sin(q[2]), w = q[5];
  const double x = c * q[0] - s * q[1], y = s * q[0] + c * q[1];
  return {x, y, q[2], c * q[3] - s * q[4] - w * y, s * q[3] + c * q[4] + w * x, w};
}

State<double> in_rotating_axes(const Newton& x) {
  const double c = std::cos(x[2]), s = std::sin(x[2]), w = x[5];
  const double q1 = c * x[0] + s * x[1], q2 = c * x[1] - s * x[0];
  return {q1, q2, x[2], c * x[3] + s * x[4] + w * q2, c * x[4] - s * x[3] - w * q1, w};
}

NewtonRim NewtonLaws::rim(const Newton& x) const {
  const double rho = std::sqrt(x[0] * x[0] + x[1] * x[1]), nx = x[0] / rho, ny = x[1] / rho;
  const double clearance = parameters.stator_radius - parameters.rotor_radius;
  return {nx,
          ny,
          rho,
          rho - clearance,
          x[3] * nx + x[4] * ny,
          x[4] * nx - x[3] * ny + parameters.rotor_radius * x[5]};
}

double NewtonLaws::pressure(const NewtonRim& k) const {
  return spring_force_by_formula(parameters, k.indentation) + parameters.contact_damping * k.rate;
}

double NewtonLaws::bearing_force(const Newton& x, std::size_t axis) const {
  const Parameters& p = parameters;
  const double offset = axis == 0 ? p.ring_offset_x : p.ring_offset_y;
  return p.support_stiffness * (x[axis] + offset) + p.support_damping * x[axis + 3];
}

Newton NewtonLaws::rates(const Newton& x, const NewtonRim& k, double pressure,
                         double friction) const {
  const Parameters& p = parameters;
  const double ex = body.eccentricity * std::cos(x[2]), ey = body.eccentricity * std::sin(x[2]);
  // Supports and F_n act at O, friction at the rim; moments are about C.
  double ox = -bearing_force(x, 0), oy = -bearing_force(x, 1);
  double moment = motor_on ? p.torque : 0;
  if (pressure != 0) {
    ox -= pressure * k.nx;
    oy -= pressure * k.ny;
  }
  moment += ey * ox - ex * oy;
  if (friction != 0) {
    const double fx = -friction * k.ny, fy = friction * k.nx;
    moment += (p.rotor_radius * k.nx - ex) * fy - (p.rotor_radius * k.ny - ey) * fx;
    ox += fx;
    oy += fy;
  }
  // Gravity's moment about O_a: of the whole weight as printed, of C's offset if balanced.
  const double arm = gravity_moment == GravityMoment::whole ? x[1] + ey : ey;
  moment -= body.mass * p.gravity * arm;
  const double angular = moment / body.inertia, w = x[5];
  // C's acceleration is that of O with the turn about it.
  return {x[3],
          x[4],
          w,
          ox / body.mass + angular * ey + w * w * ex,
          oy / body.mass - angular * ex + w * w * ey,
          angular};
}

double NewtonLaws::holding_friction(const Newton& x) const {
  const NewtonRim k = rim(x);
  const double force = std::max(0., pressure(k));
  // The slip's rate is linear in the friction.
  const auto slip_rate = [&](double friction) {
    const Newton a = rates(x, k, force, friction);
    const double along = x[4] * k.nx - x[3] * k.ny;
    return a[4] * k.nx - a[3] * k.ny - along * k.rate / k.rho + parameters.rotor_radius * a[5];
  };
  const double without = slip_rate(0), unit = std::max(1., force);
  return without * unit / (without - slip_rate(unit));
}

namespace {

class Run {
 public:
  Run(const Scenario& scenario, const NewtonSteps& steps, Observer& observer)
      : scenario_(scenario), steps_(steps), observer_(observer), at_(start_of(scenario)) {
    const Parameters& p = scenario.parameters;
    laws_ = {p, scenario.equations.gravity_moment, at_.body, at_.motor_on};
    x_ = in_stator_axes(at_.state);
    clearance_ = p.stator_radius - p.rotor_radius;
    if (at_.contact != ContactState::free && laws_.pressure(laws_.rim(x_)) < 0)
      at_.contact = ContactState::indented;
  }

  bool run_to_end() {
    at_.touches() ? begin_contact(Event::none) : show(Event::none);
    if (scenario_.loses_mass()) {
      if (!advance(scenario_.parameters.mass_loss_time)) return false;
      lose_mass();
    }
    if (!advance(scenario_.until)) return false;
    show(Event::none);
    return true;
  }

 private:
  Newton rates(const Newton& x) const {
    if (!at_.touches()) return laws_.rates(x, {}, 0, 0);
    const NewtonRim k = laws_.rim(x);
    const double force = laws_.pressure(k);
    return laws_.rates(x, k, force,
                       at_.contact == ContactState::rolling
                           ? laws_.holding_friction(x)
                           : -at_.slip_sign * laws_.parameters.friction * force);
  }

  /// Where a step of that length leads, and its error.
  Newton step(double h, Newton* error = nullptr) const {
    boost::numeric::odeint::runge_kutta_fehlberg78<Newton> stepper;
    Newton to, off;
    stepper.do_step([this](const Newton& x, Newton& dx, double) { dx = rates(x); }, x_, 0., to, h,
                    off);
    if (error) *error = off;
    return to;
  }

  /// Positive as long as the contact and the motor stay as they are.
  enum Guard { gap, indentation, pressure, slip, grip, motor };
  double guard(Guard which, const Newton& x) const {
    if (which == motor) return two_pi * laws_.parameters.motor_off_Hz - x[5];
    const NewtonRim k = laws_.rim(x);
    if (which == gap) return -k.indentation;
    if (which == indentation) return k.indentation;
    if (which == slip) return at_.slip_sign * k.slip;
    const double force = laws_.pressure(k);
    if (which == pressure) return at_.contact == ContactState::indented ? -force : force;
    return laws_.parameters.friction * force - std::abs(laws_.holding_friction(x));
  }
  /// Whether it becomes smaller within a time.
  bool guard_falls(Guard which, const Newton& x, double within_s) const {
    if (which == gap) return laws_.rim(x).rate > 0;
    if (which == indentation) return laws_.rim(x).rate < 0;
    const Newton a = rates(x);
    Newton later = x;
    for (std::size_t i = 0; i < later.size(); ++i) later[i] += within_s * a[i];
    return guard(which, later) < guard(which, x);
  }
  std::vector<Guard> guards() const {
    std::vector<Guard> all = {at_.contact == ContactState::free ? gap : indentation};
    // Without a dashpot the force vanishes with the indentation.
    if (all[0] == indentation && !(at_.touches() && laws_.parameters.contact_damping == 0))
      all.push_back(pressure);
    if (at_.contact == ContactState::sliding) all.push_back(slip);
    if (at_.contact == ContactState::rolling) all.push_back(grip);
    if (at_.motor_on) all.push_back(motor);
    return all;
  }

  void begin_contact(Event event) {
    if (event == Event::touch_down) count_whirl_from_here();
    const double slip_there = laws_.rim(x_).slip;
    at_.contact = ContactState::sliding;
    at_.slip_sign = slip_there > 0 ? 1 : -1;
    if (slip_there == 0) end_slip();
    show(event);
  }
  Event end_slip() {
    const double holding = laws_.holding_friction(x_);
    const double friction = laws_.parameters.friction;
    const bool held = friction > 0 && std::abs(holding) <= friction * laws_.pressure(laws_.rim(x_));
    at_.contact = held ? ContactState::rolling : ContactState::sliding;
    at_.slip_sign = held ? 0 : holding > 0 ? -1 : 1;
    return held ? Event::rolling_onset : Event::slip_reversal;
  }

  void count_whirl_from_here() {
    const State<double> q = in_rotating_axes(x_);
    whirl_angle_ = q[2] + std::atan2(q[1], q[0]);
  }

  void pass(Guard which) {
    const bool was_indented = at_.contact == ContactState::indented;
    show(Event::none);
    if (which == gap) return begin_contact(Event::touch_down);
    if (which == pressure && was_indented) return begin_contact(Event::renewed_contact);
    if (which == slip) return show(end_slip());
    if (which == motor) {
      laws_.motor_on = at_.motor_on = false;
      return show(Event::motor_off);
    }
    if (which == grip) {
      at_.slip_sign = laws_.holding_friction(x_) > 0 ? -1 : 1;
      at_.contact = ContactState::sliding;
      return show(Event::break_away);
    }
    at_.contact = which == indentation ? ContactState::free : ContactState::indented;
    show(which == indentation && was_indented ? Event::ring_clear : Event::release);
  }

  void lose_mass() {
    show(Event::none);
    at_.mass_lost = true;
    if (const PlaceOfLoss opposite(scenario_.parameters, 0); opposite.lost_mass() > 0) {
      at_ = opposite.lose_mass(at_, scenario_.equations);
      x_ = in_stator_axes(at_.state);
      laws_.body = at_.body;
      if (at_.contact != ContactState::free) resume_contact();
    }
    count_whirl_from_here();
    show(Event::mass_loss);
  }

  void resume_contact() {
    const NewtonRim k = laws_.rim(x_);
    const bool jumps = scenario_.equations.velocity_jump == VelocityJump::twice;
    if (laws_.pressure(k) < 0) {
      at_.contact = ContactState::indented;
    } else if (at_.contact != ContactState::rolling || jumps) {
      at_.contact = ContactState::sliding;
      at_.slip_sign = k.slip > 0 ? 1 : -1;
    }
  }

  void show(Event event) {
    at_.state = in_rotating_axes(x_);
    at_.event = event;
    if (at_.contact != ContactState::sliding) at_.slip_sign = 0;
    observer_.on_instant(at_);
  }

  /// A quantity of an Extreme; and what has the sign of its rate.
  double value(Extreme of, const Newton& x) const {
    if (of == Extreme::normal_force) return laws_.pressure(laws_.rim(x));
    if (of == Extreme::displacement) return std::hypot(x[0], x[1]);
    return std::hypot(laws_.bearing_force(x, 0), laws_.bearing_force(x, 1));
  }
  double rising(Extreme of, const Newton& x) const {
    const NewtonRim k = laws_.rim(x);
    if (of == Extreme::displacement) return k.rate;
    const Newton a = rates(x);
    const Parameters& p = laws_.parameters;
    if (of == Extreme::bearing_force) {
      const auto along = [&](std::size_t i) {
        return laws_.bearing_force(x, i) *
               (p.support_stiffness * x[i + 3] + p.support_damping * a[i + 3]);
      };
      return along(0) + along(1);
    }
    const double around = x[4] * k.nx - x[3] * k.ny;
    const double depth = std::max(k.indentation, 1e-15 * k.rho);  // rounding may show a gap
    const double second = a[3] * k.nx + a[4] * k.ny + around * around / k.rho;
    return tangent_stiffness(depth) * k.rate + p.contact_damping * second;
  }
  double tangent_stiffness(double depth) const {
    const Parameters& p = laws_.parameters;
    return p.contact_exponent * spring_force_by_formula(p, depth) / depth;
  }

  /// The length of the part of a step in which that holds, if it holds at first and not at last.
  template <class Holds>
  double bisect(double h, double share, const Holds& holds) const {
    double low = 0, high = h;
    while (high - low > share * h) {
      const double middle = low + (high - low) / 2;
      if (middle == low || middle == high) break;
      (holds(step(middle)) ? low : high) = middle;
    }
    return high;
  }

  void show_maxima(double h, const Newton& to) {
    std::vector<std::pair<double, Extreme>> found;
    for (const Extreme of :
         {Extreme::displacement, Extreme::bearing_force, Extreme::normal_force}) {
      if (of == Extreme::normal_force && !at_.touches()) continue;
      const double most = 1.2 * std::max(value(of, x_), value(of, to));  // of a flat maximum
      if (most < observer_.threshold(of, at_.time_s, at_.time_s + h)) continue;
      if (rising(of, x_) > 0 && rising(of, to) < 0)
        found.emplace_back(bisect(h, 1e-7, [&](const Newton& x) { return rising(of, x) > 0; }), of);
    }
    std::sort(found.begin(), found.end());
    for (const auto& [length, of] : found) {
      Instant there = at_;
      there.time_s += length;
      there.state = in_rotating_axes(step(length));
      there.event = Event::none;
      observer_.on_maximum({of, value(of, in_stator_axes(there.state)), there});
    }
  }

  double longest_step() const {
    const Parameters& p = laws_.parameters;
    double frequency = std::max(std::abs(x_[5]), std::sqrt(p.support_stiffness / at_.body.mass));
    if (at_.contact != ContactState::free) {
      const double depth = std::max(laws_.rim(x_).indentation, 1e-3 * clearance_);
      frequency = std::max(frequency, std::sqrt(tangent_stiffness(depth) / at_.body.mass));
    }
    const double longest = two_pi / frequency / steps_.per_period;
    if (at_.contact == ContactState::free || p.contact_exponent == 1) return longest;
    // The estimated error hardly shows that the force is not smooth where the indentation is zero.
    const NewtonRim k = laws_.rim(x_);
    return std::min(longest, std::max(longest / 1024, std::abs(k.indentation / k.rate) / 4));
  }

  bool advance(double until_s) {
    while (at_.time_s < until_s) {
      if (--steps_.most < 0) return false;
      const double most = longest_step();
      const bool last = at_.time_s + std::min(most, next_) >= until_s;
      double h = last ? until_s - at_.time_s : std::min(most, next_);
      Newton error, to = step(h, &error);
      const double speed = 1 / (most * steps_.per_period);
      double worst = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        const double unit = i % 3 == 2 ? 0.01 : clearance_ / 100;
        worst = std::max(worst, std::abs(error[i]) / unit / (i < 3 ? 1 : speed));
      }
      const double factor = std::clamp(0.9 * std::pow(steps_.tolerance / worst, 1 / 8.), 0.2, 4.);
      if (!(worst <= steps_.tolerance)) {
        if (!(at_.time_s + factor * h > at_.time_s)) return false;
        next_ = factor * h;
        continue;
      }
      if (!last) next_ = factor * h;
      std::optional<Guard> event;
      double first = h;
      const auto look_at = [&](double end, const Newton& there) {
        for (const Guard which : guards())
          if (guard(which, there) < 0) {
            const double length =
                bisect(end, 0, [&](const Newton& x) { return guard(which, x) >= 0; });
            if (!event || length < first) {
              event = which;
              first = length;
            }
          }
      };
      // Between both ends of a step a guard may become negative, by more than rounding, and
      // positive again.
      const bool is_far = 1.2 * laws_.rim(to).rho < clearance_;
      for (const Guard which : guards()) {
        const double least = std::min(guard(which, x_), guard(which, to));
        const auto falls = [&](const Newton& x) { return guard_falls(which, x, h / 1024); };
        if ((which == gap && is_far) || !(least > 0) || !falls(x_) || falls(to)) continue;
        const double turn = bisect(h, 1e-7, falls);
        if (const Newton there = step(turn); guard(which, there) < -1e-12 * least)
          look_at(turn, there);
      }
      look_at(first, event ? step(first) : to);
      h = first;
      if (event) to = step(h);
      show_maxima(h, to);
      const double turned =
          std::remainder(std::atan2(to[1], to[0]) - std::atan2(x_[1], x_[0]), two_pi);
      whirl_angle_ += turned;
      x_ = to;
      at_.time_s = last && !event ? until_s : at_.time_s + h;
      observer_.should_continue({at_.time_s, x_[5], whirl_angle_});
      if (event) pass(*event);
    }
    return true;
  }

  Scenario scenario_;
  NewtonSteps steps_;
  Observer& observer_;
  Instant at_;
  NewtonLaws laws_;
  Newton x_;
  double clearance_, next_ = std::numeric_limits<double>::infinity(), whirl_angle_ = 0;
};

}  // namespace

bool run_by_newton(const Scenario& scenario, const NewtonSteps& steps, Observer& observer) {
  return Run(scenario, steps, observer).run_to_end();
}

}  // namespace rotor
