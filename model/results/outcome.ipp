/// Definitions of outcome.hpp, for instantiation.
#pragma once

#include <cmath>
#include <limits>

#include "model/results/outcome.hpp"

namespace rotor {
namespace stalling {

/// A rotor stalls if over this many natural periods of its supports it
constexpr int periods = 10;
/// gains less than this share of the speed that its motor would add without resistance,
constexpr double share = 0.1;
/// and turns at less than this multiple of the critical speed.
constexpr double speeds = 1.5;

}  // namespace stalling

template <class S>
S reach(const Body<S>& body, const Supports<S>& supports, const Motion<S>& motion) {
  using std::hypot, std::sqrt;
  if (!supports.springs.is_linear()) return std::numeric_limits<S>::infinity();
  const S frequency = sqrt(supports.springs.linear_stiffness("the reach") / body.mass);
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

template <class S>
BasicOutcomeWatch<S>::BasicOutcomeWatch(const Scenario& scenario)
    : parameters_(scenario.parameters),
      supports_(scenario.parameters, scenario.equations),
      until_s_(scenario.until) {
  using std::sqrt;
  const S period = RotorSystem<S>::radians_per_turn() *
                   sqrt(stated<S>(parameters_.mass) / supports_.springs.tangent_stiffness(S(0)));
  time_of_speed_s_ = until_s_ - stalling::periods * period;
}

template <class S>
void BasicOutcomeWatch<S>::note(const BasicInstant<S>& at) {
  touched_ = touched_ || at.contact != ContactState::free;
  rolled_ = rolled_ || at.contact == ContactState::rolling;
  if (!at.touches())
    contact_since_s_ = std::nullopt;
  else if (!contact_since_s_)
    contact_since_s_ = at.time_s;
  last_ = at;
}

template <class S>
Outcome BasicOutcomeWatch<S>::outcome() const {
  if (rolled_) return Outcome::rolling;
  if (is_stalled()) return Outcome::stalled;
  using std::sqrt;
  const Ring<S> ring(parameters_);
  const S contact_period =
      RotorSystem<S>::radians_per_turn() * sqrt(last_.body.mass / ring.stiffness);
  if (contact_since_s_ && last_.time_s - *contact_since_s_ > contact_period)
    return Outcome::sliding;
  const bool is_free = last_.contact == ContactState::free;
  if (is_free && reach(last_.body, supports_, last_.motion()) < ring.clearance)
    return touched_ ? Outcome::freed : Outcome::no_contact;
  return touched_ ? Outcome::bouncing : Outcome::undecided;
}

template <class S>
bool BasicOutcomeWatch<S>::stays_clear() const {
  using std::abs, std::max, std::sqrt;
  const Body<S>& body = last_.body;
  const Motion<S> motion = last_.motion();
  const S speed = abs(motion.speed), left_s = until_s_ - last_.time_s;
  const S stiffness = supports_.springs.linear_stiffness("the resonance");
  const S square = stiffness / body.mass, decay = supports_.damping / body.mass;
  const auto response = [&](const S& w) {  // steady displacement of O by the unbalance
    return (supports_.unbalance_response(body, w) - Vector<S>(body.eccentricity, S(0))).norm();
  };
  // Energy that rotation and vibration can exchange, and that damping can take.
  const S farthest = reach(body, supports_, motion), vibration = farthest - response(speed);
  const S velocity = vibration * sqrt(square) + response(speed) * speed;
  const S exchanged = body.mass * (velocity * velocity / 2 + 2 * supports_.gravity * farthest) +
                      stiffness * farthest * farthest / 2;
  const S damped = supports_.damping * velocity * velocity * left_s;
  const S driven = last_.motor_on ? supports_.torque / body.inertia * left_s : S(0);
  const S least = sqrt(max(S(0), S(speed * speed - 2 * (exchanged + damped) / body.inertia)));
  const S most = sqrt(speed * speed + 2 * exchanged / body.inertia) + driven;
  const S clearance = Ring<S>(parameters_).clearance;
  const auto is_clear_at = [&](const S& w) { return vibration + response(w) < clearance; };
  // In between the response is greatest at the resonance, if that lies there.
  const S resonance = square * square / (square - decay * decay / 2);  // squared
  const bool is_passed = resonance > least * least && resonance < most * most;
  return is_clear_at(least) && is_clear_at(most) && !(is_passed && !is_clear_at(sqrt(resonance)));
}

template <class S>
bool BasicOutcomeWatch<S>::is_stalled() const {
  if (!last_.motor_on || !early_speed_ || !(supports_.torque > 0)) return false;
  using std::abs, std::sqrt;
  const S critical = sqrt(supports_.springs.tangent_stiffness(S(0)) / last_.body.mass);
  const S unresisted = supports_.torque / last_.body.inertia * (last_.time_s - time_of_speed_s_);
  const S speed = last_.state[5];
  return abs(speed) < S(stalling::speeds) * critical &&
         speed - *early_speed_ < S(stalling::share) * unresisted;
}

}  // namespace rotor
