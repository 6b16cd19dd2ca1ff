/// The smooth phases of the motion, each in the coordinates in which it is slowest, and the guards
/// that end them. A phase writes the vectors of rotor.hpp and contact.hpp in a basis of its own;
/// the physics stays there. Friction is Filippov's: set-valued at zero slip, where rolling is a
/// phase of its own. Right-hand sides are flattened, which lets the compiler see through the
/// vectors of a basis that are constant.
#pragma once

#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "model/instant.hpp"

namespace rotor {

/// All that acts on the rotor.
template <class S>
struct Surroundings {
  Body<S> body;
  Supports<S> supports;
  Ring<S> ring;
  S motor_off;  ///< speed at which the motor is switched off, rad/s
  bool motor_on;

  /// Before the mass loss, the motor driving.
  static Surroundings of(const Scenario& scenario) {
    const Parameters& p = scenario.parameters;
    return {.body = Body<S>::of(p),
            .supports = Supports<S>(p, scenario.equations),
            .ring = Ring<S>(p),
            .motor_off = boost::math::constants::two_pi<S>() * S(p.motor_off_Hz),
            .motor_on = true};
  }

  /// Becomes negative where the motor is to be switched off.
  S motor_guard(const S& speed) const { return motor_on ? motor_off - speed : S(1); }
};

/// How each guard of a phase is called: the phase ends where one of them becomes negative.
enum class Guard { touch_down, release, ring_clear, renewed_contact, slip_ends, break_away, motor };

/// A quantity whose maximum may be asked for. The maximum is where its rate becomes negative.
template <class S>
struct Maximum {
  Extreme of;
  S value;  ///< m or N
  S rate;   ///< m/s or N/s
};

/// No contact force. In the stator's frame the mass centre hardly feels the rotation, because the
/// supports are soft; what is left of it well above the critical speed is the steady response to
/// the unbalance, and the unknowns are the deviation from that. The axes are the stator's, turned
/// to where the rotor's axes were not long ago, so that the angle stays small.
template <class S>
class Flight {
 public:
  /// Deviation of C along both axes (m), angle of the rotor from them (rad), then deviation of the
  /// velocity of C (m/s), and the speed (rad/s).
  using Unknowns = std::array<S, 6>;
  /// Whether the rates take the contact into account, and whether the guards do.
  static constexpr bool contact_in_rates = false, contact_in_guards = false;

  Flight(const Surroundings<S>& around, const State<S>& start) : around_(around) {
    lay_axes(start);
  }

  /// Turns the axes to where the rotor's are.
  void lay_axes(const State<S>& q) {
    using std::cos, std::sin;
    angle_ = q[2];
    down_ = Vector<S>(cos(angle_), -sin(angle_));
    subtracts_response_ = is_fast(q[5]);
  }

  Unknowns unknowns(const State<S>& q) const {  // the axes coincide
    const Motion<S> m = RotatingFrame<S>::motion(around_.body, q);
    const Steady steady = this->steady(m.eccentricity, m.speed);
    const Vector<S> position = m.mass_centre() - steady.displacement;
    const Vector<S> velocity =
        m.mass_centre_velocity() - m.speed * quarter_turn(steady.displacement);
    return {position.x(), position.y(), S(0), velocity.x(), velocity.y(), m.speed};
  }

  Motion<S> motion(const Unknowns& x) const {
    const Vector<S> eccentricity = this->eccentricity(x);
    return motion(x, eccentricity, steady(eccentricity, x[5]));
  }

  State<S> state(const Unknowns& x) const {
    using std::cos, std::sin;
    const S c = cos(x[2]), s = sin(x[2]), e = around_.body.eccentricity;
    const Vector<S> eccentricity(e * c, e * s);
    const Motion<S> m = motion(x, eccentricity, steady(eccentricity, x[5]));
    const Vector<S> q = turned(m.displacement, c, S(-s));
    const Vector<S> rate = turned(m.velocity, c, S(-s)) - x[5] * quarter_turn(q);
    return {q.x(), q.y(), angle_ + x[2], rate.x(), rate.y(), x[5]};
  }

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const Vector<S> eccentricity = this->eccentricity(x);
    const Steady steady = this->steady(eccentricity, x[5]);
    const Motion<S> m = motion(x, eccentricity, steady);
    const auto a =
        acceleration(around_.body, m, around_.supports.loads(around_.body, m, around_.motor_on));
    // The steady response turns with the rotor and changes with its speed.
    const S w = m.speed;
    const Vector<S> drift = a.angular * steady.slope;
    const Vector<S> velocity = Vector<S>(x[3], x[4]) - drift;
    const Vector<S> rate = a.mass_centre + w * w * steady.displacement -
                           quarter_turn<S>(a.angular * steady.displacement + w * drift);
    rates = {velocity.x(), velocity.y(), w, rate.x(), rate.y(), a.angular};
  }

  /// Lays the axes anew if the rotor has turned far from them, or has become too slow for its
  /// response to be subtracted. Returns whether the rates have to be worked out again.
  bool start_step(Unknowns& x) {
    constexpr double far = 32;  // rad; the angle is known to some 1e-14 rad until there
    const bool is_near = x[2] < far && x[2] > -far;
    if (is_near && (!subtracts_response_ || is_fast(x[5]))) return false;
    const State<S> q = state(x);
    lay_axes(q);
    x = unknowns(q);
    return true;
  }

  /// Sizes that the errors of the unknowns are measured by. Every contact multiplies the errors
  /// that it begins with, and a flight is cheap: its lengths are measured by a small part of the
  /// clearance. The speed hardly changes, but its ripple must not pass unnoticed under long steps.
  Unknowns scale(const Unknowns& x) const {
    const S length = around_.ring.clearance / 300, w = frequency(around_, x[5]);
    return {length, length, S(1), length * w, length * w, w / 100};
  }

  /// Fastest natural rate of change, rad/s.
  static S frequency(const Surroundings<S>& around, const S& speed) {
    using std::abs, std::max, std::sqrt;
    return max({S(1), abs(speed), sqrt(around.supports.stiffness / around.body.mass)});
  }

  /// Into how many arcs to divide a step of length h, for each to have one maximum at most.
  int arcs(const Unknowns& x, const S& h) const {
    using std::ceil;
    return static_cast<int>(ceil(h * frequency(around_, x[5])));
  }

 protected:
  /// Of C in the steady response to the unbalance, as far as that is subtracted, m.
  S steady_amplitude(const Unknowns& x) const {
    if (!subtracts_response_) return S(0);
    return around_.body.eccentricity *
           around_.supports.unbalance_response(around_.body.mass, x[5]).factor.norm();
  }

  const Surroundings<S>& around_;

 private:
  /// Far above the critical speed. Near it the response changes too fast with the speed to be worth
  /// subtracting.
  bool is_fast(const S& speed) const {
    const S critical = around_.supports.stiffness / around_.body.mass;  // squared
    return speed * speed > 4 * critical;
  }

  /// The steady response to the unbalance, O_a C.
  struct Steady {
    Vector<S> displacement;  ///< m
    Vector<S> slope;         ///< its change with the speed, m s
  };

  Steady steady(const Vector<S>& eccentricity, const S& speed) const {
    if (!subtracts_response_) return {Vector<S>(0, 0), Vector<S>(0, 0)};
    const auto response = around_.supports.unbalance_response(around_.body.mass, speed);
    return {complex_product(eccentricity, response.factor),
            complex_product(eccentricity, response.slope)};
  }

  Vector<S> eccentricity(const Unknowns& x) const {
    using std::cos, std::sin;
    const S e = around_.body.eccentricity;
    return {e * cos(x[2]), e * sin(x[2])};
  }

  Motion<S> motion(const Unknowns& x, const Vector<S>& eccentricity, const Steady& steady) const {
    const Vector<S> turning = steady.displacement - eccentricity;
    return {.displacement = Vector<S>(x[0], x[1]) + turning,
            .velocity = Vector<S>(x[3], x[4]) + x[5] * quarter_turn(turning),
            .eccentricity = eccentricity,
            .down = down_,
            .speed = x[5]};
  }

  S angle_;
  Vector<S> down_;
  bool subtracts_response_;
};

/// Clear of the ring.
template <class S>
class FreeFlight : public Flight<S> {
 public:
  using Flight<S>::Flight, typename Flight<S>::Unknowns;

  static constexpr std::array guard_names = {Guard::touch_down, Guard::motor};
  using Guards = std::array<S, guard_names.size()>;
  Guards guards(const Unknowns& x) const {
    const S clearance = this->around_.ring.clearance;
    return {clearance * clearance - this->motion(x).displacement.squaredNorm(),  // rho = r_a - r
            this->around_.motor_guard(x[5])};                                    // f = f_max
  }

  /// Whether no guard can end the phase within a step from x to y of length h.
  bool passes(const Unknowns& x, const Unknowns& y, const S& h) const {
    const auto bounds = motion_bounds(x, h);
    return bounds && reach(*bounds, x, y, h) < this->around_.ring.clearance &&
           (!this->around_.motor_on || bounds->speed < this->around_.motor_off);
  }

  /// A bound of rho within a step from x to y of length h, if it can be told, m.
  std::optional<S> reach(const Unknowns& x, const Unknowns& y, const S& h) const {
    const auto bounds = motion_bounds(x, h);
    return bounds ? std::optional(reach(*bounds, x, y, h)) : std::nullopt;
  }

  /// The largest second derivative that a guard can have from x on for a time h, if it can be told.
  std::optional<S> greatest_curvature(std::size_t guard, const Unknowns& x, const S& h) const {
    if (guard != 0) return std::nullopt;
    const auto bounds = motion_bounds(x, h);
    if (!bounds) return std::nullopt;
    const S e = this->around_.body.eccentricity;
    const S of_O =
        bounds->acceleration + e * (bounds->speed * bounds->speed + bounds->angular_acceleration);
    return 2 * (bounds->velocity * bounds->velocity + this->around_.ring.clearance * of_O);
  }

  static constexpr bool has_maxima = true;
  std::array<Maximum<S>, 1> maxima(const Unknowns& x, const Unknowns& /*rates*/) const {
    const Motion<S> m = this->motion(x);
    const S rho = m.displacement.norm();
    const S rate = rho > 0 ? S(m.displacement.dot(m.velocity) / rho) : S(0);
    return {{{Extreme::displacement, rho, rate}}};
  }

 private:
  struct Bounds {
    S velocity;      ///< of O, m/s
    S acceleration;  ///< of C, m/s^2
    S speed;         ///< rad/s
    S angular_acceleration;
  };

  S reach(const Bounds& bounds, const Unknowns& x, const Unknowns& y, const S& h) const {
    using std::max, std::sqrt;
    const S farther = max(x[0] * x[0] + x[1] * x[1], y[0] * y[0] + y[1] * y[1]);
    const S of_C = sqrt(farther) + max(this->steady_amplitude(x), this->steady_amplitude(y)) +
                   bounds.acceleration * h * h / 8;
    return of_C + this->around_.body.eccentricity;
  }

  /// Bounds that hold from x on for a time h, as long as O is inside the clearance. The velocity is
  /// assumed to stay below a bound; if the loads that this allows cannot drive it there, it does.
  std::optional<Bounds> motion_bounds(const Unknowns& x, const S& h) const {
    using std::abs, std::sqrt;
    const Body<S>& body = this->around_.body;
    const Supports<S>& supports = this->around_.supports;
    const S clearance = this->around_.ring.clearance, e = body.eccentricity;
    const S speed = abs(x[5]);
    const S velocity_of_C = sqrt(x[3] * x[3] + x[4] * x[4]) + speed * this->steady_amplitude(x);
    const S spring = supports.stiffness * clearance;

    const S velocity = 2 * (velocity_of_C + speed * e + spring / body.mass * h);
    const S force = spring + supports.damping * velocity;
    const S moment = supports.torque + supports.damping * clearance * velocity +
                     (clearance + e) * (body.mass * supports.gravity + force);
    const Bounds bounds{velocity, force / body.mass, speed + moment / body.inertia * h,
                        moment / body.inertia};
    if (velocity_of_C + bounds.acceleration * h + bounds.speed * e > velocity) return std::nullopt;
    return bounds;
  }
};

/// Without force, the ring still being indented.
template <class S>
class IndentedFlight : public Flight<S> {
 public:
  using Flight<S>::Flight, typename Flight<S>::Unknowns;
  static constexpr bool contact_in_guards = true;

  static constexpr std::array guard_names = {Guard::ring_clear, Guard::renewed_contact,
                                             Guard::motor};
  using Guards = std::array<S, guard_names.size()>;
  Guards guards(const Unknowns& x) const {
    const Ring<S>& ring = this->around_.ring;
    const RimPoint<S> k = ring.rim_point(this->motion(x));
    return {k.indentation,                     // Delta = 0
            ring.elastic_force(k),             // k_t Delta + d_t Delta' = 0
            this->around_.motor_guard(x[5])};  // f = f_max
  }

  bool passes(const Unknowns&, const Unknowns&, const S&) const { return false; }
  std::optional<S> greatest_curvature(std::size_t, const Unknowns&, const S&) const {
    return std::nullopt;
  }

  static constexpr bool has_maxima = false;
};

/// In contact: polar coordinates of O in the rotating axes. The basis is the normal and the tangent
/// at K.
template <class S>
class Rub {
 public:
  /// Delta, which is known more sharply than rho (m), direction of O in the rotating axes and angle
  /// of the rotor, both since the start of the step (rad), then the velocity of O along normal and
  /// tangent (m/s), and the speed (rad/s).
  using Unknowns = std::array<S, 6>;
  static constexpr bool contact_in_rates = true, contact_in_guards = true;

  Rub(const Surroundings<S>& around, const State<S>& start) : around_(around) { lay_axes(start); }

  void lay_axes(const State<S>& q) {
    using std::atan2;
    q3_ = q[2];
    alpha_ = atan2(q[1], q[0]);
    lay_basis();
  }

  Unknowns unknowns(const State<S>& q) const {
    const Motion<S> motion = RotatingFrame<S>::motion(around_.body, q);
    const RimPoint<S> k = around_.ring.rim_point(motion);
    return {k.indentation, S(0), S(0), k.normal_velocity, k.tangent.dot(motion.velocity),
            motion.speed};
  }

  Motion<S> motion(const Unknowns& x) const {
    using std::cos, std::sin;
    const S c = cos(x[1]), s = -sin(x[1]);
    Vector<S> down(S(0), S(0));
    if (around_.supports.gravity != 0)
      down = turned(turned(down_, c, s), S(cos(x[2])), S(-sin(x[2])));
    return {.displacement = Vector<S>(displacement(x), 0),
            .velocity = Vector<S>(x[3], x[4]),
            .eccentricity = turned(eccentricity_, c, s),
            .down = down,
            .speed = x[5]};
  }

  State<S> state(const Unknowns& x) const {
    using std::cos, std::sin;
    const S c = cos(alpha_ + x[1]), s = sin(alpha_ + x[1]), rho = displacement(x);
    const Vector<S> q = turned(Vector<S>(rho, 0), c, s);
    const Vector<S> rate = turned(Vector<S>(x[3], x[4] - x[5] * rho), c, s);
    return {q.x(), q.y(), q3_ + x[2], rate.x(), rate.y(), x[5]};
  }

  /// Counts both angles from here: small ones are known more sharply, and cost less.
  bool start_step(Unknowns& x) {
    alpha_ += x[1];
    q3_ += x[2];
    x[1] = x[2] = 0;
    lay_basis();
    return false;
  }

  bool passes(const Unknowns&, const Unknowns&, const S&) const { return false; }
  std::optional<S> greatest_curvature(std::size_t, const Unknowns&, const S&) const {
    return std::nullopt;
  }

  static S frequency(const Surroundings<S>& around, const S& speed) {
    using std::max, std::sqrt;
    return max(Flight<S>::frequency(around, speed), sqrt(around.ring.stiffness / around.body.mass));
  }

  static constexpr bool has_maxima = true;
  std::array<Maximum<S>, 2> maxima(const Unknowns& x, const Unknowns& rates) const {
    const Ring<S>& ring = around_.ring;
    return {
        {{Extreme::displacement, displacement(x), x[3]},
         {Extreme::normal_force, pressure(x), ring.stiffness * x[3] + ring.damping * rates[3]}}};
  }
  int arcs(const Unknowns& x, const S& h) const {
    using std::ceil;
    return static_cast<int>(ceil(h * frequency(around_, x[5])));
  }
  std::optional<S> reach(const Unknowns&, const Unknowns&, const S&) const { return std::nullopt; }

 protected:
  /// The rotor at x, friction left out.
  struct Contact {
    Motion<S> motion;
    RimPoint<S> k;
    S normal_force;
    Acceleration<S> acceleration;
  };

  /// F_n is not clamped: a guard ends the phase where it changes sign.
  Contact contact(const Unknowns& x) const {
    const Motion<S> m = motion(x);
    const RimPoint<S> k{.normal = Vector<S>(1, 0),
                        .tangent = Vector<S>(0, 1),
                        .displacement = m.displacement.x(),
                        .indentation = x[0],
                        .normal_velocity = x[3],
                        .slip_velocity = slip_velocity(x)};
    Loads<S> loads = around_.supports.loads(around_.body, m, around_.motor_on);
    const S normal_force = around_.ring.elastic_force(k);
    loads += around_.ring.loads(k, {normal_force, S(0)});
    return {m, k, normal_force, acceleration(around_.body, m, loads)};
  }

  /// What a friction of 1 N adds to the acceleration.
  Acceleration<S> mobility(const Contact& c) const {
    return friction_mobility(around_.body, c.motion, c.k, around_.ring.rotor_radius);
  }

  Unknowns rates(const Unknowns& x, const Contact& c, const S& friction,
                 const Acceleration<S>& per_newton) const {
    const Acceleration<S> a = c.acceleration + friction * per_newton;
    const Vector<S> of_O = acceleration_of_centre(a, c.motion);
    const S whirl = x[4] / c.k.displacement;  // of the basis, rad/s
    return {x[3], whirl - x[5], x[5], of_O.x() + whirl * x[4], of_O.y() - whirl * x[3], a.angular};
  }

  S displacement(const Unknowns& x) const { return around_.ring.clearance + x[0]; }

  S pressure(const Unknowns& x) const {
    const Ring<S>& ring = around_.ring;
    return ring.stiffness * x[0] + ring.damping * x[3];  // -F_n of Eq. (21)
  }

  S slip_velocity(const Unknowns& x) const { return x[4] + around_.ring.rotor_radius * x[5]; }

  /// The same to rounding for a rim that does not slip.
  Unknowns without_slip(Unknowns x) const {
    x[4] = -around_.ring.rotor_radius * x[5];
    return x;
  }

  const Surroundings<S>& around_;

 private:
  void lay_basis() {
    using std::cos, std::sin;
    const S e = around_.body.eccentricity, beta = q3_ + alpha_;
    eccentricity_ = Vector<S>(e * cos(alpha_), -e * sin(alpha_));
    down_ = Vector<S>(cos(beta), -sin(beta));
  }

  S q3_, alpha_;                   // at the start of the step
  Vector<S> eccentricity_, down_;  // in the basis there
};

/// In contact, the rim sliding in one direction.
template <class S>
class Sliding : public Rub<S> {
 public:
  using typename Rub<S>::Unknowns;

  /// `direction` is the sign of the slip velocity, or what it will be `from_rest`.
  Sliding(const Surroundings<S>& around, const State<S>& start, int direction, bool from_rest)
      : Rub<S>(around, start), direction_(direction), from_rest_(from_rest) {}

  Unknowns unknowns(const State<S>& q) const {
    return from_rest_ ? this->without_slip(Rub<S>::unknowns(q)) : Rub<S>::unknowns(q);
  }

  /// Nearly as small as in flight.
  Unknowns scale(const Unknowns& x) const {
    const S length = this->around_.ring.clearance / 100;
    const S w = Flight<S>::frequency(this->around_, x[5]) / 10;
    const S radial_velocity = length * this->frequency(this->around_, x[5]);
    return {length, S(1), S(1), radial_velocity, this->around_.ring.rotor_radius * w, w};
  }

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    const auto c = this->contact(x);
    const S friction = this->around_.ring.sliding_friction(c.normal_force, direction_);
    rates = this->rates(x, c, friction, this->mobility(c));
  }

  static constexpr std::array guard_names = {Guard::release, Guard::slip_ends, Guard::motor};
  using Guards = std::array<S, guard_names.size()>;
  Guards guards(const Unknowns& x) const {
    using std::abs;
    // A slip that has come from zero may be too slow to be told from rounding for a while.
    const S rounding = 16 * std::numeric_limits<S>::epsilon() * abs(x[4]);
    return {this->pressure(x),                                  // F_n = 0
            S(direction_) * this->slip_velocity(x) + rounding,  // v_Ktau = 0
            this->around_.motor_guard(x[5])};                   // f = f_max
  }

 private:
  int direction_;
  bool from_rest_;
};

/// In contact without slip. The constraint is linear in the unknowns, v_t = -r w, so that
/// Runge-Kutta steps keep it to rounding.
template <class S>
class Rolling : public Rub<S> {
 public:
  using typename Rub<S>::Unknowns;
  using Rub<S>::Rub;

  Unknowns unknowns(const State<S>& q) const { return this->without_slip(Rub<S>::unknowns(q)); }

  /// The radial oscillation is so much faster than the whirl that its errors average out.
  Unknowns scale(const Unknowns& x) const {
    const S length = 10 * this->around_.ring.clearance;
    const S w = Flight<S>::frequency(this->around_, x[5]);
    const S radial_velocity = length * this->frequency(this->around_, x[5]);
    return {length, S(1), S(1), radial_velocity, this->around_.ring.rotor_radius * w, w};
  }

  [[gnu::flatten]] void operator()(const Unknowns& x, Unknowns& rates, const S& /*time*/) const {
    evaluate(x, rates);
  }

  /// F_tau, N.
  S friction(const Unknowns& x) const { return evaluate(x).friction; }

  static constexpr std::array guard_names = {Guard::release, Guard::break_away, Guard::motor};
  using Guards = std::array<S, guard_names.size()>;
  Guards guards(const Unknowns& x) const {
    const auto [normal, friction] = evaluate(x);
    // A friction that rounding alone asks for is there even when F_n has vanished.
    const S rounding = 64 * std::numeric_limits<S>::epsilon() * this->around_.supports.stiffness *
                       this->displacement(x);
    const S limit = this->around_.ring.friction * -normal + rounding;
    return {-normal,                              // F_n = 0
            limit * limit - friction * friction,  // |F_tau| = mu |F_n|
            this->around_.motor_guard(x[5])};     // f = f_max
  }

 private:
  ContactForces<S> evaluate(const Unknowns& x, Unknowns& rates) const {
    const auto c = this->contact(x);
    const Acceleration<S> mobility = this->mobility(c);
    const S friction = friction_without_slip(c.motion, c.k, c.acceleration, mobility,
                                             this->around_.ring.rotor_radius);
    rates = this->rates(x, c, friction, mobility);
    return {c.normal_force, friction};
  }

  ContactForces<S> evaluate(const Unknowns& x) const {
    Unknowns unused;
    return evaluate(x, unused);
  }
};

/// How a phase begins.
struct Begin {
  Event event;
  ContactState contact;
  int direction = 0;       ///< of the slip, while sliding
  bool from_rest = false;  ///< whether the slip is zero yet
};

/// What a rim at rest on the ring does: it rolls if friction can hold it. If not, it slides to
/// where the friction that would be needed does not want it.
template <class S>
Begin leave_zero_slip(const Surroundings<S>& around, const State<S>& q) {
  const Rolling<S> rolling(around, q);
  const auto x = rolling.unknowns(q);
  const auto [pressure, grip, motor] = rolling.guards(x);
  if (grip >= 0) return {Event::rolling_onset, ContactState::rolling};
  return {Event::slip_reversal, ContactState::sliding, rolling.friction(x) > 0 ? -1 : 1, true};
}

/// The rim meets the ring with the slip that it has.
template <class S>
Begin meet_ring(const Surroundings<S>& around, const State<S>& q, Event event) {
  const S slip = around.ring.rim_point(RotatingFrame<S>::motion(around.body, q)).slip_velocity;
  if (slip != 0) return {event, ContactState::sliding, slip > 0 ? 1 : -1};
  Begin begin = leave_zero_slip(around, q);
  begin.event = event;
  return begin;
}

/// What follows when a guard has ended a phase (not the motor's, which ends no contact).
template <class S>
Begin follow(Guard guard, const Surroundings<S>& around, const State<S>& q) {
  switch (guard) {
    case Guard::touch_down:
      return meet_ring(around, q, Event::touch_down);
    case Guard::renewed_contact:
      return meet_ring(around, q, Event::renewed_contact);
    case Guard::release:
      return {Event::release, ContactState::indented};
    case Guard::ring_clear:
      return {Event::ring_clear, ContactState::free};
    case Guard::slip_ends:
      return leave_zero_slip(around, q);
    case Guard::break_away: {
      const Rolling<S> rolling(around, q);
      return {Event::break_away, ContactState::sliding,
              rolling.friction(rolling.unknowns(q)) > 0 ? -1 : 1, true};
    }
    case Guard::motor:
      break;
  }
  return {};
}

/// How a motion goes on that is taken up in contact with the ring, perhaps after a jump.
template <class S>
Begin begin_again(const Surroundings<S>& around, const State<S>& q, ContactState contact) {
  const auto k = around.ring.rim_point(RotatingFrame<S>::motion(around.body, q));
  if (around.ring.elastic_force(k) > 0) return {Event::none, ContactState::indented};
  if (contact == ContactState::rolling) return {Event::none, contact};
  return meet_ring(around, q, Event::none);
}

}  // namespace rotor
