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
/// speed: the steady response to the unbalance plus a vibration about it that can only decay. The
/// ripple of the speed due to gravity, and its effect on O, are neglected.
template <class S>
S reach(const Body<S>& body, const Supports<S>& supports, const Motion<S>& motion) {
  using std::hypot;
  const S frequency = natural_frequency(supports.stiffness, body.mass);
  const Vector<S> along = motion.eccentricity / body.eccentricity;  // the rotor's axis x
  const Vector<S> steady =
      body.eccentricity > 0
          ? Vector<S>(complex_product(supports.unbalance_response(body, motion.speed), along))
          : Vector<S>(S(0), S(0));
  const Vector<S> deviation = motion.mass_centre() - steady;
  const Vector<S> velocity = motion.mass_centre_velocity() - motion.speed * quarter_turn(steady);
  const S drift = velocity.norm();
  const S amplitude = hypot(deviation.norm(), drift > 0 ? S(drift / frequency) : S(0));
  return amplitude + (steady - motion.eccentricity).norm();  // O turns with C
}

/// Gathers what decides the outcome.
template <class S>
class BasicOutcomeWatch {
 public:
  explicit BasicOutcomeWatch(const Scenario& scenario)
      : parameters_(scenario.parameters),
        supports_(scenario.parameters, scenario.equations),
        until_s_(scenario.until) {
    const S period = RotorSystem<S>::radians_per_turn() /
                     natural_frequency(supports_.stiffness, as_typed<S>(parameters_.mass));
    time_of_speed_s_ = until_s_ - stalling_periods * period;
  }

  /// Time whose speed note_speed() needs, if the motor is on then, s.
  const S& time_of_speed_s() const { return time_of_speed_s_; }
  void note_speed(const std::optional<S>& speed) { early_speed_ = speed; }
  const std::optional<S>& early_speed() const { return early_speed_; }

  /// To be called at all events, and at the end; in flight at any time.
  void note(const BasicInstant<S>& at) {
    touched_ = touched_ || at.contact != ContactState::free;
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
    if (is_free && reach(last_.body, supports_, last_.motion()) < ring.clearance)
      return touched_ ? Outcome::freed : Outcome::no_contact;
    return touched_ ? Outcome::bouncing : Outcome::undecided;
  }

  /// Whether the free rotor cannot reach the ring until the end of the run, nor stall, at any speed
  /// that it can have until then: driven by its motor or by gravity, braked by the damping of its
  /// supports or by gravity.
  bool stays_clear() const {
    using std::abs, std::hypot, std::max, std::min, std::sqrt;
    const Body<S>& body = last_.body;
    const Motion<S> motion = last_.motion();
    const S clearance = Ring<S>(parameters_).clearance, e = body.eccentricity;
    const S speed = abs(motion.speed), left_s = until_s_ - last_.time_s;
    const S& stiffness = supports_.stiffness;
    if (!(stiffness > 0)) return false;  // any rounded velocity takes it anywhere
    const S square = stiffness / body.mass, decay = supports_.damping / body.mass;
    const auto response = [&](const S& w) {  // steady displacement of O by the unbalance
      return (supports_.unbalance_response(body, w) - Vector<S>(e, S(0))).norm();
    };
    // Energy that rotation and vibration can exchange, and that damping can take. The moment of the
    // weight at the eccentricity has a potential; the whole moment of gravity has none, and may
    // drive or brake the rotor as long as the run lasts.
    const S farthest = reach(body, supports_, motion), vibration = farthest - response(speed);
    const S velocity = vibration * sqrt(square) + response(speed) * speed;
    const bool balanced = supports_.balanced_by_springs;
    const S weight = body.mass * supports_.gravity, arm = balanced ? e : S(clearance + e);
    const S exchanged =
        body.mass * velocity * velocity / 2 + 2 * weight * e + stiffness * farthest * farthest / 2;
    const S damped = supports_.damping * velocity * velocity * left_s;
    const S driven = last_.motor_on ? supports_.torque / body.inertia * left_s : S(0);
    const S pumped = balanced ? S(0) : S(weight * arm / body.inertia * left_s);
    const S braked = motion.speed < 0 ? S(driven + pumped) : pumped;
    const S least = max(
        S(0),
        S(sqrt(max(S(0), S(speed * speed - 2 * (exchanged + damped) / body.inertia))) - braked));
    const S most = sqrt(speed * speed + 2 * exchanged / body.inertia) + driven + pumped;
    if (driven > 0 && least < fastest_stall()) return false;
    // Gravity's moment makes the angle ripple, and the unbalance with it, which shakes the rotor at
    // frequencies that may be its natural one.
    const S slowest = min(least, sqrt(square));
    S rippling(0);  // m/s^2
    if (arm > 0 && weight > 0) {
      if (!(slowest > 0)) return false;
      const S ripple = weight * arm / (body.inertia * slowest * slowest);
      rippling = e * ripple * hypot(stiffness, supports_.damping * most) / body.mass;
    }
    // So does the steady response A(w), which lags behind a speed that changes.
    const S changing = ((last_.motor_on ? supports_.torque : S(0)) +
                        e * supports_.bearing_force(farthest, velocity)) /
                       body.inertia;  // rad/s^2
    const auto is_clear_at = [&](const S& w) {
      const S lagging =
          changing * (supports_.unbalance_response(body, w).norm() +
                      (2 * w + decay) * supports_.unbalance_response_by_speed(body, w).norm());
      const S force = rippling + lagging;  // at worst in resonance, m/s^2
      S shaken = force > 0 ? S(force / sqrt(square) * left_s / 2) : S(0);
      if (decay > 0) shaken = min(shaken, S(force / (decay * sqrt(square))));
      return vibration + shaken + response(w) < clearance;
    };
    // In between the response is greatest at the resonance, if that lies there.
    const S resonance = square * square / (square - decay * decay / 2);  // squared
    const bool is_passed = resonance > least * least && resonance < most * most;
    return is_clear_at(least) && is_clear_at(most) && !(is_passed && !is_clear_at(sqrt(resonance)));
  }

 private:
  bool is_stalled() const {
    if (!last_.motor_on || !early_speed_ || !(supports_.torque > 0)) return false;
    // Backward whirl along the ring brakes the rotor, and may yet end in rolling.
    const Motion<S> motion = last_.motion();
    if (last_.touches() && cross(motion.displacement, motion.velocity) * motion.speed < 0)
      return false;
    using std::abs;
    const S unresisted = supports_.torque / last_.body.inertia * (last_.time_s - time_of_speed_s_);
    const S speed = last_.state[5];
    return abs(speed) < fastest_stall() && speed - *early_speed_ < S(stalling_share) * unresisted;
  }

  S fastest_stall() const {  // rad/s
    return S(stalling_speeds) * natural_frequency(supports_.stiffness, last_.body.mass);
  }

  /// A rotor stalls if over this many natural periods of its supports it
  static constexpr int stalling_periods = 10;
  /// gains less than this share of the speed that its motor would add without resistance,
  static constexpr double stalling_share = 0.1;
  /// and turns at less than this multiple of the critical speed.
  static constexpr double stalling_speeds = 1.5;

  Parameters parameters_;
  Supports<S> supports_;
  S until_s_, time_of_speed_s_;
  std::optional<S> early_speed_;  ///< rad/s
  std::optional<S> contact_since_s_;
  bool touched_ = false, rolled_ = false;
  BasicInstant<S> last_;
};

using OutcomeWatch = BasicOutcomeWatch<double>;
extern template class BasicOutcomeWatch<double>;

}  // namespace rotor
