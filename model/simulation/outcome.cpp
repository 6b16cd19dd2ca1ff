#include "model/simulation/outcome.hpp"

#include <cmath>
#include <numbers>

namespace rotor {
namespace {

/// A rotor that stalls is looked at for so many natural periods of its supports,
constexpr int periods_of_stalling = 10;
/// gains less than this share of the speed that its motor would give it without resistance,
constexpr double share_of_stalling = 0.1;
/// and turns at less than this multiple of the critical speed.
constexpr double speeds_of_stalling = 1.5;

}  // namespace

double reach(const Body<double>& body, const Supports<double>& supports,
             const Motion<double>& motion) {
  const double frequency = std::sqrt(supports.stiffness / body.mass);
  const Vector<double> along = motion.eccentricity / body.eccentricity;  // the rotor's axis x
  const Vector<double> steady =
      body.eccentricity > 0
          ? Vector<double>(complex_product(supports.unbalance_response(body, motion.speed), along))
          : Vector<double>(0, 0);
  const Vector<double> deviation = motion.mass_centre() - steady;
  const Vector<double> velocity =
      motion.mass_centre_velocity() - motion.speed * quarter_turn(steady);
  const double amplitude = std::hypot(deviation.norm(), velocity.norm() / frequency);
  return amplitude + steady.norm() + body.eccentricity;
}

OutcomeWatch::OutcomeWatch(const Scenario& scenario)
    : parameters_(scenario.parameters), supports_(scenario.parameters, scenario.equations) {
  const double period =
      2 * std::numbers::pi * std::sqrt(parameters_.mass / parameters_.support_stiffness);
  time_of_speed_s_ = scenario.until - periods_of_stalling * period;
}

void OutcomeWatch::note(const Instant& at) {
  touched_ = touched_ || at.touches();
  rolled_ = rolled_ || at.contact == ContactState::rolling;
  if (!at.touches())
    contact_since_s_ = std::nullopt;
  else if (!contact_since_s_)
    contact_since_s_ = at.time_s;
  last_ = at;
}

Outcome OutcomeWatch::outcome() const {
  if (rolled_) return Outcome::rolling;
  if (is_stalled()) return Outcome::stalled;
  const double contact_period =
      2 * std::numbers::pi * std::sqrt(last_.body.mass / parameters_.contact_stiffness);
  if (contact_since_s_ && last_.time_s - *contact_since_s_ > contact_period)
    return Outcome::sliding;
  const bool is_free = last_.contact == ContactState::free;
  const double clearance = parameters_.stator_radius - parameters_.rotor_radius;
  if (is_free && reach(last_.body, supports_, last_.motion()) < clearance)
    return touched_ ? Outcome::freed : Outcome::no_contact;
  return touched_ ? Outcome::bouncing : Outcome::undecided;
}

bool OutcomeWatch::is_stalled() const {
  if (!last_.motor_on || !early_speed_ || !(parameters_.torque > 0)) return false;
  const double critical = std::sqrt(parameters_.support_stiffness / last_.body.mass);
  const double unresisted =
      parameters_.torque / last_.body.inertia * (last_.time_s - time_of_speed_s_);
  const double speed = last_.state[5];
  return std::abs(speed) < speeds_of_stalling * critical &&
         speed - *early_speed_ < share_of_stalling * unresisted;
}

}  // namespace rotor
