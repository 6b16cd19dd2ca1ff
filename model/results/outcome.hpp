/// What became of the rotor, in one word.
#pragma once

#include <cmath>
#include <optional>

#include "model/scenario/instant.hpp"

namespace rotor {

/// The outcome is the first of these that holds at the end of a run, see
/// BasicOutcomeWatch::outcome().
enum class Outcome { rolling, stalled, sliding, freed, no_contact, bouncing, undecided };

/// The farthest that O can get from O_a, m, while the rotor stays clear of the ring and keeps its
/// speed: the position of rest plus the steady response to the unbalance plus a vibration about it
/// that can only decay. The ripple of the speed due to gravity, and its effect on O, are neglected.
template <class S>
S reach(const Body<S>& body, const Supports<S>& supports, const Motion<S>& motion) {
  using std::hypot;
  const S frequency = natural_frequency(supports.stiffness, body.mass);
  const Vector<S> along = motion.eccentricity / body.eccentricity;  // the rotor's axis x
  const Vector<S> steady =
      body.eccentricity > 0
          ? Vector<S>(complex_product(supports.unbalance_response(body, motion.speed), along))
          : Vector<S>(S(0), S(0));
  const Vector<S> deviation = supports.from_rest(motion) + motion.eccentricity - steady;
  const Vector<S> velocity = motion.mass_centre_velocity() - motion.speed * quarter_turn(steady);
  const S drift = velocity.norm();
  const S amplitude = hypot(deviation.norm(), drift > 0 ? S(drift / frequency) : S(0));
  return supports.rest_distance + amplitude +
         (steady - motion.eccentricity).norm();  // O turns with C
}

/// Gathers what decides the outcome.
template <class S>
class BasicOutcomeWatch {
 public:
  explicit BasicOutcomeWatch(const Scenario& scenario)
      : parameters_(scenario.parameters),
        acting_(scenario.parameters, scenario.equations),
        until_s_(scenario.until),
        margin_(scenario.method == Method::rk4 ? S(0.01) : S(1000 * scenario.tolerance + 1e-9)) {
    const S period = RotorSystem<S>::radians_per_turn() /
                     natural_frequency(acting_.supports.stiffness, as_typed<S>(parameters_.mass));
    time_of_speed_s_ = until_s_ - stalling_periods * period;
  }

  /// Time whose speed note_speed() needs, if the motor is on then, s.
  const S& time_of_speed_s() const { return time_of_speed_s_; }
  void note_speed(const std::optional<S>& speed) { early_speed_ = speed; }
  const std::optional<S>& early_speed() const { return early_speed_; }

  /// To be called at all events, and at the end; in flight at any time.
  void note(const BasicInstant<S>& at) {
    touched_ = touch_downs_.begins_with(at.contact) || touched_;
    rolled_ = rolled_ || at.contact == ContactState::rolling;
    if (!at.touches())
      contact_since_s_ = std::nullopt;
    else if (!contact_since_s_)
      contact_since_s_ = at.time_s;
    last_ = at;
  }

  /// At the last instant noted.
  Outcome outcome() const {
    if (rolled_) return Outcome::rolling;
    if (is_stalled()) return Outcome::stalled;
    const Ring<S> ring(parameters_);
    const S contact_period = RotorSystem<S>::radians_per_turn() /
                             natural_frequency(ring.typical_stiffness(), last_.body.mass);
    if (contact_since_s_ && last_.time_s - *contact_since_s_ > contact_period)
      return Outcome::sliding;
    const bool is_free = last_.contact == ContactState::free;
    if (is_free && reach(last_.body, acting_.supports, last_.motion()) < ring.clearance)
      return touched_ ? Outcome::freed : Outcome::no_contact;
    return touched_ ? Outcome::bouncing : Outcome::undecided;
  }

  /// Whether the free rotor cannot reach the ring until the end of the run, nor stall, at any speed
  /// that it can have until then: driven or braked by constant moments or by gravity, and braked by
  /// the damping of its supports.
  bool stays_clear() const {
    using std::abs, std::hypot, std::max, std::min, std::sqrt;
    const Body<S>& body = last_.body;
    const Motion<S> motion = last_.motion();
    const S clearance = Ring<S>(parameters_).clearance, e = body.eccentricity;
    const S surely_clear = (1 - margin_) * clearance;
    const S speed = abs(motion.speed), left_s = until_s_ - last_.time_s;
    const Supports<S>& supports = acting_.supports;
    const S &stiffness = supports.stiffness, &damping = supports.damping;
    if (!(stiffness > 0)) return false;  // any rounded velocity takes it anywhere
    const S square = stiffness / body.mass, decay = damping / body.mass;
    const auto response = [&](const S& w) {  // steady displacement of O by the unbalance
      return (supports.unbalance_response(body, w) - Vector<S>(e, S(0))).norm();
    };
    // Energy that rotation and vibration can exchange, and that damping can take. Moments that are
    // constant between events, now or once the motor is off, or have no potential may drive or
    // brake the rotor as long as the run lasts.
    const S farthest = reach(body, supports, motion), rest = supports.rest_distance,
            vibration = farthest - rest - response(speed);
    const S velocity = vibration * sqrt(square) + response(speed) * speed;
    const S exchanged =
        body.mass * velocity * velocity / 2 + acting_.potential_range(body, farthest);
    const S damped = damping * velocity * velocity * left_s;
    const S now = acting_.constant_moment(last_.motor_on), later = acting_.constant_moment(false),
            constant = max<S>(abs(now), abs(later));
    const S driven = constant / body.inertia * left_s;
    const S pumped = acting_.moment_without_potential(body, clearance + e) / body.inertia * left_s;
    const bool brakes = now * motion.speed < 0 || later * motion.speed < 0;
    const S braked = brakes ? S(driven + pumped) : pumped;
    const S least = max(
        S(0),
        S(sqrt(max(S(0), S(speed * speed - 2 * (exchanged + damped) / body.inertia))) - braked));
    const S most = sqrt(speed * speed + 2 * exchanged / body.inertia) + driven + pumped;
    if (driven > 0 && least < fastest_stall()) return false;
    // Moments that vary, as gravity's, make the angle ripple, and the unbalance with it, which
    // shakes the rotor at frequencies that may be its natural one.
    const S slowest = min(least, sqrt(square));
    S rippling(0);  // m/s^2
    const LoadBound<S> varying = acting_.bound(body, {farthest, clearance + e, velocity});
    if (varying.couple > 0) {
      if (!(slowest > 0)) return false;
      const S ripple = varying.couple / (body.inertia * slowest * slowest);
      rippling = e * ripple * hypot(stiffness, damping * most) / body.mass;
    }
    // So does the steady response A(w), which lags behind a speed that changes.
    const S changing = (constant + e * varying.force) / body.inertia;  // rad/s^2
    const auto is_clear_at = [&](const S& w) {
      const S lagging =
          changing * (supports.unbalance_response(body, w).norm() +
                      (2 * w + decay) * supports.unbalance_response_by_speed(body, w).norm());
      const S force = rippling + lagging;  // at worst in resonance, m/s^2
      S shaken = force > 0 ? S(force / sqrt(square) * left_s / 2) : S(0);
      if (decay > 0) shaken = min(shaken, S(force / (decay * sqrt(square))));
      return rest + vibration + shaken + response(w) < surely_clear;
    };
    // In between the response is greatest at the resonance, if that lies there.
    const S resonance = square * square / (square - decay * decay / 2);  // squared
    const bool is_passed = resonance > least * least && resonance < most * most;
    return is_clear_at(least) && is_clear_at(most) && !(is_passed && !is_clear_at(sqrt(resonance)));
  }

 private:
  bool is_stalled() const {
    const S moment = acting_.constant_moment(last_.motor_on);
    if (!last_.motor_on || !early_speed_ || !(moment > 0)) return false;
    // Backward whirl along the ring brakes the rotor, and may yet end in rolling.
    const Motion<S> motion = last_.motion();
    if (last_.touches() && cross(motion.displacement, motion.velocity) * motion.speed < 0)
      return false;
    using std::abs;
    const S unresisted = moment / last_.body.inertia * (last_.time_s - time_of_speed_s_);
    const S speed = last_.state[5];
    return abs(speed) < fastest_stall() && speed - *early_speed_ < S(stalling_share) * unresisted;
  }

  S fastest_stall() const {  // rad/s
    return S(stalling_speeds) * natural_frequency(acting_.supports.stiffness, last_.body.mass);
  }

  /// A rotor stalls if over this many natural periods of its supports it
  static constexpr int stalling_periods = 10;
  /// gains less than this share of the speed that its motor would add without resistance,
  static constexpr double stalling_share = 0.1;
  /// and turns at less than this multiple of the critical speed.
  static constexpr double stalling_speeds = 1.5;

  Parameters parameters_;
  ActingLoads<S> acting_;
  S until_s_, time_of_speed_s_;
  S margin_;  ///< for errors of the rest of a run, relative to the clearance: of 300,000 flight
              ///< steps
  std::optional<S> early_speed_;  ///< rad/s
  std::optional<S> contact_since_s_;
  TouchDowns touch_downs_;
  bool touched_ = false, rolled_ = false;
  BasicInstant<S> last_;
};

using OutcomeWatch = BasicOutcomeWatch<double>;
extern template class BasicOutcomeWatch<double>;

}  // namespace rotor
